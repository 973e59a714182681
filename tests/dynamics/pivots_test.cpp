// SPDX-License-Identifier: GPL-3.0-or-later
// What kernels compare the pivots of their solves with.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::pivots_test {
namespace {

using namespace testing_mechanisms;
using namespace literals;

/// The least pivot of the multipliers over what the kernel compares it with, in roundings of a double.
double least_pivot(const Scene& scene, bool absolute, int one_over_angle) {
  const Equations equations(scene);
  const Real a(Number::rational(1, one_over_angle), 50);
  NamedState here(equations, {{"a", a}, {"b", absolute ? Real(0) : -a}, {"c", a}});
  double least = std::numeric_limits<double>::infinity();
  const auto& pivots = equations.forward().pivots;
  for (std::size_t k = pivots.size() - 2; k < pivots.size(); ++k) {
    const Real ratio = here(pivots[k].pivot) / here(pivots[k].measure);
    const double roundings = pivots[k].of_several_rows ? many_roundings::in_double : 1;
    least = std::min(least, ratio.to_double() / (roundings * std::numeric_limits<double>::epsilon()));
  }
  return least;
}

TEST(Pivots, OfMultipliersAreSmallWhereALoopLaysItselfFlat) {
  // In proportion to the square of the angle, and the row of one closure with them: nothing of its own says so.
  for (const bool absolute : {false, true}) {
    const Scene scene = parallelogram(absolute ? Angle::absolute : Angle::of_the_joint, 1);
    EXPECT_GT(least_pivot(scene, absolute, 1), 1e9);
    EXPECT_GT(least_pivot(scene, absolute, 1000), 10);  // six digits are left
    EXPECT_LT(least_pivot(scene, absolute, 10'000'000), 1.0);
  }
}

}  // namespace
}  // namespace torsor::pivots_test
