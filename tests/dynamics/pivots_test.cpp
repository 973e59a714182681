// SPDX-License-Identifier: GPL-3.0-or-later
// What kernels compare the pivots of their solves with.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/dynamics/simple_scenes.hpp"

namespace torsor::pivots_test {
namespace {

using namespace testing_mechanisms;
using namespace literals;

/// Cranks of length 1 from pivots 2 apart and a coupler of length 2, in relative or absolute angles.
Scene parallelogram(bool absolute) {
  Scene scene("parallelogram");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const Placement offset{{metres("1"), 0, 0}, {}};
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, absolute ? b - a : b, offset);
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {{metres("2"), 0, 0}, {}});
  for (const auto& [name, frame] :
       std::vector<std::pair<std::string, FrameHandle>>{{"s1", crank}, {"s2", coupler}, {"s3", rocker}}) {
    scene.body(name, frame, Inertia::rod(kilograms("1"), metres("1"), 0));
  }
  scene.initial(a, 1);
  scene.initial(b, absolute ? 0 : -1);
  scene.initial(c, 1);
  scene.closure("x", scene.point("tip", coupler, {metres("2"), 0, 0}), scene.point("end", rocker, {metres("1"), 0, 0}),
                axis::x);
  scene.closure("y", scene.point("tip"), scene.point("end"), axis::y);
  return scene;
}

/// The least pivot of the multipliers over what the kernel compares it with, in roundings of a double.
double least_pivot(const Scene& scene, bool absolute, int one_over_angle) {
  const Equations equations(scene);
  const Real a(Number::rational(1, one_over_angle), 50);
  NamedState here(equations, {{"a", a}, {"b", absolute ? Real(0) : -a}, {"c", a}});
  double least = std::numeric_limits<double>::infinity();
  const auto& pivots = equations.forward().pivots;
  for (std::size_t k = pivots.size() - 2; k < pivots.size(); ++k) {
    const Real ratio = here(pivots[k].first) / here(pivots[k].second);
    least = std::min(least, ratio.to_double() / std::numeric_limits<double>::epsilon());
  }
  return least;
}

TEST(Pivots, OfMultipliersAreSmallWhereALoopLaysItselfFlat) {
  // In proportion to the square of the angle, and the row of one closure with them: nothing of its own says so.
  for (const bool absolute : {false, true}) {
    const Scene scene = parallelogram(absolute);
    EXPECT_GT(least_pivot(scene, absolute, 1), 1e9);
    EXPECT_GT(least_pivot(scene, absolute, 1000), 10);  // six digits are left
    EXPECT_LT(least_pivot(scene, absolute, 10'000'000), 1.0);
  }
}

}  // namespace
}  // namespace torsor::pivots_test
