// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>


#include "tests/long_tests.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::derivations_test {
namespace {

using testing_mechanisms::random_mechanism;

/// All comparisons of check_scene on a random mechanism: Lagrange's operator on T against virtual power, both mass
/// matrices, symmetry, positiveness, forward against inverse dynamics, the energy theorem, constraints, all to
/// 10^(5 - 50), and the double kernels against CLN. At a random state the terms of a kernel may cancel to a hundredth
/// of their size, hence 1e-11 for those.
class RandomMechanism : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomMechanism, HasOneSetOfEquationsByEveryDerivation) {
  const Scene scene = random_mechanism(GetParam());
  const std::vector<CheckResult> results = check_scene(scene, {.digits = 50, .states = 1});
  EXPECT_GE(results.size(), 6U);
  for (const CheckResult& result : results) {
    const double bound = result.name.starts_with("double.") ? 1e-11 : result.bound;
    EXPECT_LE(result.worst, bound) << result.name;
  }
}

// Some take a minute; four of them by default, beside those of verification/five_hundred_mechanisms_test.cpp.
INSTANTIATE_TEST_SUITE_P(Seeds, RandomMechanism, ::testing::Range(1U, 81U, wanted(20U, 1U)));

}  // namespace
}  // namespace torsor::derivations_test
