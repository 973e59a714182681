// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/actions.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::actions_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

/// A bob free in a plane, tied to the origin.
class TiedBob : public ::testing::Test, public SlidingPoint {
 protected:
  PointHandle origin = scene.point("O", scene.ground(), {0, 0, 0});
  FrameHandle bob = point;
  PointHandle center = place;

  TiedBob() : SlidingPoint("tied_bob", "2") {}
  static Expression stiffness() { return Expression::quantity("5", "N/m"); }
};

TEST_F(TiedBob, FeelsNothingFromASpringOfNoNaturalLengthAtZeroLength) {
  scene.spring("tie", {.a = origin, .b = center, .stiffness = stiffness()});
  const Equations equations(scene);
  const Linearisation linear = linearisation(equations);
  NamedState at_origin(equations, {});
  EXPECT_TRUE(at_origin(equations.bias()[0]).is_zero());
  EXPECT_TRUE(at_origin(equations.bias()[1]).is_zero());
  EXPECT_TRUE(at_origin(equations.forward().accelerations[0]).is_zero());
  EXPECT_TRUE(at_origin(equations.actions().spring_force_function).is_zero());
  EXPECT_EQ(at_origin.in_double(linear.K[0][0]), 5);
  EXPECT_EQ(at_origin.in_double(linear.K[0][1]), 0);
  // Nothing hides a square root: the same scene is linear everywhere.
  EXPECT_EQ(count(equations.program(), equations.bias()).square_roots, 0);
}

TEST_F(TiedBob, IsPulledAlongTheSpringByStiffnessTimesElongation) {
  scene.spring("tie", {.a = origin, .b = center, .stiffness = stiffness(), .rest = metres("0.5")});
  const Equations equations(scene);
  NamedState state(equations, {{"x", Real(3)}, {"y", Real(-4)}});  // length 5, tension 5 (5 − 1/2) = 22.5
  EXPECT_NEAR(state.in_double(equations.bias()[0]), 22.5 * 3 / 5, 1e-14);
  EXPECT_NEAR(state.in_double(equations.bias()[1]), -22.5 * 4 / 5, 1e-14);
  EXPECT_NEAR(state.in_double(equations.actions().spring_force_function), -0.5 * 5 * 4.5 * 4.5, 1e-14);
}

TEST_F(TiedBob, LosesPowerInADamperAlongItsLengthOnly) {
  scene.damper("brake", origin, center, Expression::quantity("7", "N s/m"));
  const Equations equations(scene);
  NamedState moving(equations, {{"x", Real(3)}, {"y", Real(4)}, {"x'", Real(1)}, {"y'", Real(2)}});
  const double length_rate = (3.0 * 1 + 4.0 * 2) / 5;
  EXPECT_NEAR(moving.in_double(equations.actions().power), -7 * length_rate * length_rate, 1e-13);
  EXPECT_NEAR(moving.in_double(equations.bias()[0]), 7 * length_rate * 3 / 5, 1e-14);
  NamedState turning(equations, {{"x", Real(3)}, {"y", Real(4)}, {"x'", Real(-4)}, {"y'", Real(3)}});
  EXPECT_TRUE(turning(equations.actions().power).is_zero());
}

TEST_F(TiedBob, WorksWithGivenForcesAndMotors) {
  const Expression push = scene.motor("push", x);
  scene.force("wind", {.body = bob,
                       .point = center,
                       .components = {Expression::quantity("1.5", "N"), Expression::quantity("-2", "N"), 0},
                       .axes = scene.ground()});
  const Equations equations(scene);
  ASSERT_EQ(push.as_symbol()->kind, SymbolKind::input);
  NamedState state(equations, {{"x'", Real(2)}, {"y'", Real(3)}, {"push", Real(11)}});
  EXPECT_EQ(state.in_double(equations.actions().power), 11 * 2 + 1.5 * 2 - 2 * 3);
  EXPECT_EQ(state.in_double(equations.forward().accelerations[0]), (11 + 1.5) / 2);
  EXPECT_EQ(state.in_double(equations.forward().accelerations[1]), -1);
  EXPECT_EQ(equations.actions().without_force_function, (std::vector<std::string>{"push", "wind"}));
}

TEST(JointActions, TurnAsTheySay) {
  Scene scene("torsion");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle wheel = scene.revolute("wheel", scene.ground(), -axis::z, theta);
  scene.body("wheel", wheel, Inertia::disk(kilograms("4"), metres("1"), 2));  // J = 2 kg m²
  scene.spring("spring", theta, Expression::quantity("6", "N m"), Expression(Number::rational(1, 2)));
  scene.damper("friction", theta, Expression::quantity("3", "N m s"));
  scene.torque("wind", wheel, {0, 0, Expression::quantity("-5", "N m")}, scene.ground());
  const Equations equations(scene);
  NamedState state(equations, {{"theta", Real(2)}, {"theta'", Real(-1)}});
  // 2 θ̈ = −6 (2 − ½) − 3 (−1) + 5: the axis is −z, so the torque −5 z turns forwards.
  EXPECT_EQ(state.in_double(equations.forward().accelerations[0]), (-9.0 + 3 + 5) / 2);
  EXPECT_EQ(state.in_double(equations.actions().spring_force_function), -0.5 * 6 * 1.5 * 1.5);
  EXPECT_EQ(state.in_double(equations.actions().power), -3 * 1.0 + 5 * -1.0);
}

TEST_F(TiedBob, RefusesActionsThatCannotAct) {
  const auto refusal = [&](const auto& add) {
    Scene bad = scene;
    add(bad);
    return error_of<SceneError>([&] { Equations(bad).actions(); });
  };
  EXPECT_EQ(refusal([&](Scene& s) {
              s.force("f", {.body = s.ground(),
                            .point = s.point("O"),
                            .components = {Expression::quantity("1", "N"), 0, 0},
                            .axes = s.ground()});
            }),
            "action 'f' is applied to the ground, which it cannot move");
  EXPECT_EQ(refusal([&](Scene& s) {
              s.point("H", bob, {metres("1"), 0, 0});
              s.spring("rigid", {.a = s.point("P"), .b = s.point("H"), .stiffness = stiffness()});
            }),
            "spring 'rigid' ties two points of one rigid body: its length never changes");
  EXPECT_EQ(refusal([&](Scene& s) {
              s.spring("lost", {.a = s.point("O"), .b = s.point("nowhere"), .stiffness = stiffness()});
            }),
            "unknown point 'nowhere' in spring 'lost': the scene has P, O");
}

}  // namespace
}  // namespace torsor::actions_test
