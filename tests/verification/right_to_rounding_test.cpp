// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/right_to_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor::right_to_rounding_test {
namespace {

using namespace testing_rounding;

constexpr double unit = unit_of<double>, nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> truth{3, -4, 12};  // of the length 13

/// Results that are right but for one, as a vector and one by one: the names of those that are found out.
std::string found_out(std::size_t which, double change, double allowed) {
  std::vector<double> found = truth;
  found[which] += change;
  RightToRounding check(unit);
  check.vector("all", found, truth, allowed);
  for (std::size_t i = 0; i < truth.size(); ++i) check.entry(std::to_string(i), found[i], truth[i], allowed);
  std::string names;
  for (const Excess& each : check.excesses()) names += each.entry + " ";
  EXPECT_EQ(static_cast<bool>(check), names.empty());
  return names;
}

TEST(RightToRounding, FindsEachResultThatIsFurtherOffThanItsBound) {
  // The ulp of 12 is 16 units: 16/12 roundings of its own size, 16/13 of the length of the vector.
  const double step = 16 * unit;
  EXPECT_EQ(found_out(2, step, 1.4), "");
  EXPECT_EQ(found_out(2, step, 1.3), "2 ");
  EXPECT_EQ(found_out(2, step, 1.2), "all 2 ");
  EXPECT_EQ(found_out(0, 3 * step, 5), "0 ");
  EXPECT_EQ(found_out(1, -3 * step, 2), "all 1 ");
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NE(found_out(i, 1e-11, 450), "") << i;
}

TEST(RightToRounding, FindsWhatIsNoNumber) {
  EXPECT_EQ(found_out(1, nan, 1e300), "all 1 ");
  EXPECT_EQ(found_out(1, std::numeric_limits<double>::infinity(), 1e300), "all 1 ");
  RightToRounding check(unit);
  check.entry("unknown truth", 1.0, nan, 1e300);
  check.entry("no size", 1.0, 1.0 + 1e-10, nan, 1e300);
  EXPECT_EQ(check.excesses().size(), 2U);
  EXPECT_TRUE(std::isinf(roundings(nan, 1, unit)));  // std::max would lose a NaN
}

/// Where the truth is 0 there is nothing to measure by, but the size of terms that cancel.
TEST(RightToRounding, WantsZeroForZeroUnlessASizeIsGiven) {
  RightToRounding check(unit);
  check.entry("zero", 0.0, 0.0, 1);
  check.vector("zeros", std::vector<double>{0, 0}, std::vector<double>{0, 0}, 1);
  check.entry("rest of terms", 1e-16, 0.0, 1.0, 1);
  EXPECT_TRUE(check) << check;
  check.entry("small", 1e-300, 0.0, 1e300);
  EXPECT_EQ(check.excesses().size(), 1U);
}

/// The digits of the reference decide: half an ulp of a double is seen, and so is the 48th digit.
TEST(RightToRounding, TakesDifferencesInTheDigitsOfTheReference) {
  const WorkingDigits digits(50);
  const Real third = Real(1) / Real(3);
  RightToRounding check(unit);
  check.entry("rounded", 1.0 / 3, third, 1);
  EXPECT_NEAR(check.worst(), 0.5, 1e-9);  // 1/3 has the bits 0.0101...: 2^-54 of it is cut off
  RightToRounding fine(1e-48);
  fine.entry("many digits", third, third + Real::parse("1e-48"), 2);
  EXPECT_EQ(fine.excesses().size(), 1U);  // three roundings of a third
  EXPECT_NEAR(fine.excesses().at(0).off, 3, 1e-6);
}

TEST(RightToRounding, SaysWhatIsOffAndThatNothingWasCompared) {
  RightToRounding check(unit);
  std::ostringstream none, some;
  none << check;
  EXPECT_EQ(none.str(), "nothing was compared");
  EXPECT_FALSE(check);
  check.entry("mass[1]", 1 + 8 * unit, 1.0, 4);
  check.entry("mass[2]", 1.0, 1.0, 4);
  check.vector("short", std::vector<double>{1}, truth, 4);
  some << check;
  EXPECT_EQ(some.str(), "mass[1] is off by 8 roundings, allowed are 4\nshort is off by inf roundings, allowed are 4\n");
  EXPECT_EQ(check.compared(), 3);
}

}  // namespace
}  // namespace torsor::right_to_rounding_test
