// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/printing/check_inline.hpp"
#include "tests/scenes/with_parameters.hpp"

#include <gtest/gtest.h>

namespace torsor::check_inline_test {
namespace {

class PrintedEquations : public testing::TestWithParam<Scene (*)()> {};

TEST_P(PrintedEquations, AgreeWithTheProgramAtFiftyDigits) {
  const test::InlineCheck check = test::check_inline(GetParam()(), 50, 10);
  ASSERT_TRUE(check.written_out);
  EXPECT_EQ(check.states, 10);
  EXPECT_GE(check.compared.size(), 3U);
  // At most some 400 terms of size 1e3 at most, rounded at 1e-50 each: 1e-45 leaves two digits.
  EXPECT_LT(check.worst, Real::parse("1e-45")) << check.worst_of;
}

Scene absolute() { return test::double_pendulum({}); }
Scene relative() { return test::double_pendulum({.second = test::Angle::of_the_joint}); }
Scene chain_3() { return test::chain(3); }

INSTANTIATE_TEST_SUITE_P(Scenes, PrintedEquations,
                         testing::Values(test::absorber, absolute, relative, test::satellite, test::elastic_pendulum,
                                         test::released_block, test::sled, chain_3));

TEST(CheckInline, SaysWhenThereIsNothingWrittenOutToCheck) {
  const test::InlineCheck check = test::check_inline(test::chain(7), 50, 1);
  EXPECT_FALSE(check.written_out);
  EXPECT_EQ(check.states, 0);
}

}  // namespace
}  // namespace torsor::check_inline_test
