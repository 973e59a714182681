// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the motion against central differences of the motion in sixty digits.
#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/central_differences.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::forward_derivatives_test {
namespace {

using namespace testing_mechanisms;

enum class Contact { smooth, rough };

/// A bar on a slider, its foot on a wall and its middle on a curve, both of which move in time: two multipliers, whose
/// rows change with the configuration. A rough wall makes the answer to forces unsymmetric.
Scene bar_between_two_guides(Contact contact) {
  Scene scene("bar_between_two_guides");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"),
                   theta = scene.coordinate("theta", "rad");
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  const FrameHandle slider = scene.prismatic("slider", across, axis::y, y);
  const FrameHandle bar = scene.revolute("bar", slider, axis::z, theta);
  const FrameHandle bead = scene.prismatic("bead", bar, {1, 2, 2}, z);
  scene.body("bar", bar,
             Inertia::box(kilograms("2"), metres("1"), metres("0.5"), metres("0.2")).at({metres("0.3"), 0, 0}));
  scene.body("bead", bead, Inertia::point(kilograms("0.7")));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  scene.spring("spring", x * theta, Expression::quantity("40", "N/m"), metres("0.2"));
  scene.damper("damper", theta, Expression::quantity("0.3", "N m s"));
  scene.motor("push", x);
  scene.motor("pull", metres("0.4") * theta + z);
  const PointHandle foot = scene.point("foot", bar, {metres("1"), 0, 0});
  const Expression t = scene.time();
  const ConstraintHandle wall =
      scene.holonomic("wall", x + metres("1") * cos(theta) - Expression::quantity("0.1", "m/s") * t);
  scene.holonomic("curve", y * cos(theta) - z * sin(theta) * Expression::quantity("0.5", "1/s") * t);
  if (contact == Contact::rough) {
    scene.reaction(wall, "N", {.body = bar, .contact = foot, .direction = axis::x, .axes = scene.ground()});
    scene.sliding_friction("rub", wall,
                           {.coefficient = Expression(Number::rational(3, 10)),
                            .body = bar,
                            .point = foot,
                            .direction = axis::y,
                            .axes = scene.ground()});
  }
  return scene;
}

void expect_slopes(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Equations one(scene), other(scene);
  const ForwardDerivatives exact = forward_derivatives_by_factorisation(one);
  const ForwardSolution& motion = other.forward();
  const RandomState state(scene, seed);
  Evaluator<Real> at(one.program(), state.in_real());
  CentralDifferences differences(other, seed);
  const auto compare = [&](ValueMatrix ForwardDerivatives::Of::*matrix, std::size_t k,
                           const CentralDifferences::Change& by) {
    EXPECT_LT(largest_difference(at(column(exact.accelerations.*matrix, k)), differences(motion.accelerations, by)),
              CentralDifferences::bound);
    EXPECT_LT(largest_difference(at(column(exact.multipliers.*matrix, k)), differences(motion.multipliers, by)),
              CentralDifferences::bound);
  };
  using Of = ForwardDerivatives::Of;
  for (std::size_t j = 0; j < static_cast<std::size_t>(one.model().unknown_count()); ++j) {
    SCOPED_TRACE(one.model().coordinates()[j].q->name);
    compare(&Of::by_position, j, differences.along(j));
    compare(&Of::by_velocity, j, CentralDifferences::of(other.model().coordinates()[j].v));
  }
  const std::vector<SymbolPointer> inputs = other.model().inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    SCOPED_TRACE(inputs[k]->name);
    compare(&Of::by_input, k, CentralDifferences::of(inputs[k]));
  }
}

TEST(ForwardDerivatives, AreSlopesOfTheMotionOnMovingGuides) {
  for (const std::uint64_t seed : {1U, 2U}) expect_slopes(bar_between_two_guides(Contact::smooth), seed);
}

TEST(ForwardDerivatives, AreSlopesOfTheMotionWithFriction) {
  for (const std::uint64_t seed : {1U, 2U}) expect_slopes(bar_between_two_guides(Contact::rough), seed);
}

}  // namespace
}  // namespace torsor::forward_derivatives_test
