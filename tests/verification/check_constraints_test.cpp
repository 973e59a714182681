// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_constraints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/verification/moving_state.hpp"
#include "torsor/generator/verification/posed_constraints.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/rolling.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::check_constraints_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

void expect_passed(const Scene& scene, const std::vector<const char*>& wanted) {
  const std::vector<CheckResult> results = check_derivations(scene, {.states = 3});
  for (const CheckResult& result : results) EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst;
  for (const char* name : wanted) {
    EXPECT_TRUE(std::any_of(results.begin(), results.end(), [&](const auto& each) { return each.name == name; }))
        << name;
  }
}

// x y = L² (cos wt − 1): the rate has y x' + x y' and a part of time alone, w L² sin wt, whose own rate γ must have.
TEST(CheckConstraints, DifferentiatesAConditionThatIsNotLinearInTime) {
  SlidingPoint it("driven", "2");
  const Expression turns = cos(quantity("3", "rad/s") * it.scene.time());
  it.scene.holonomic("driven", it.x * it.y - quantity("1", "m^2") * (turns - 1));
  it.scene.initial(it.x, metres("1"));
  expect_passed(it.scene, {"constraint_motion"});
}

// A crank that follows a law of time closes a loop: the closure depends on time through its joint.
TEST(CheckConstraints, DifferentiatesALoopWhoseCrankFollowsALawOfTime) {
  Scene scene("crank");
  const Expression turn = scene.coordinate("turn", "rad"), swing = scene.coordinate("swing", "rad");
  const Expression slide = scene.coordinate("slide", "m");
  scene.drive(turn, quantity("2", "rad/s^2") * pow(scene.time(), 2) / 2);
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, turn);
  const FrameHandle rod = scene.revolute("rod", crank, axis::z, swing, {.origin = {metres("0.3"), 0, 0}});
  const FrameHandle block = scene.prismatic("block", scene.ground(), axis::x, slide);
  scene.body("rod", rod, Inertia::rod(kilograms("1"), metres("1"), 0).at({metres("0.5"), 0, 0}));
  scene.body("block", block, Inertia::point(kilograms("2")));
  scene.initial(slide, metres("1.3"));
  scene.closure("pin_x", scene.point("end", rod, {metres("1"), 0, 0}), scene.point("pin", block, {0, 0, 0}), axis::x);
  scene.closure("pin_y", scene.point("end"), scene.point("pin"), axis::y);
  expect_passed(scene, {"constraint_motion", "constraint_wrenches"});
}

// Rolling: a condition on velocities, with a point of contact that moves over the disc.
TEST(CheckConstraints, DifferentiatesRollingAndFindsThePowerOfItsForces) {
  expect_passed(RollingDisc().scene, {"constraint_motion", "constraint_wrenches"});
}

// A ball rolls on a table that turns by a law of time on a carriage that is free to move: what rolls there slips by its
// velocity less that of the table's own matter, and the force on it has an opposite.
TEST(CheckConstraints, DifferentiatesRollingOnABodyThatMoves) {
  Scene scene("ball_on_table");
  const Expression slide = scene.coordinate("slide", "m"), turn = scene.coordinate("turn", "rad");
  scene.drive(turn, quantity("2", "rad/s^2") * pow(scene.time(), 2) / 2);
  const FrameHandle carriage = scene.prismatic("carriage", scene.ground(), axis::x, slide);
  const FrameHandle table = scene.revolute("table", carriage, axis::z, turn);
  scene.body("table", table, Inertia::disk(kilograms("3"), metres("2"), 2));
  add_rolling_ball(scene, table, Inertia::solid_sphere(kilograms("2"), metres("0.5")));
  scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
  expect_passed(scene, {"constraint_motion", "constraint_wrenches"});
}

Scene with_closing_joint(JointType type) {
  Scene scene("closed");
  const Expression pitch = type == JointType::helical ? metres("0.2") : Expression(0);
  const Expression q = scene.coordinate("q", "rad");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), {1, -2, 2}, q, {.origin = {metres("0.1"), 0, 0}});
  const Expression moved = scene.released_coordinate("moved", "m"), turned = scene.released_coordinate("turned", "rad");
  const FrameHandle slide = scene.prismatic("slide", arm, {2, 1, 2}, moved, {.rotation = Rotation::about(1, 5)});
  const FrameHandle a = scene.revolute("a", slide, {2, 2, 1}, turned, {.origin = {0, metres("0.3"), metres("0.2")}});
  scene.body("a", a, Inertia::box(kilograms("1"), metres("1"), metres("2"), metres("0.5")).at({0, metres("0.1"), 0}));
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle b = scene.free("b", scene.ground(), {x, y, z}, scene.attitude("e"));
  scene.body("b", b, Inertia::box(kilograms("2"), metres("1"), metres("0.4"), metres("0.6")).at({metres("0.1"), 0, 0}));
  const FrameHandle near = scene.weld("near", a, {.rotation = Rotation::about(2, 3)});
  const FrameHandle far = scene.weld("far", b, {.origin = {0, metres("0.2"), 0}, .rotation = Rotation::about(0, 7)});
  scene.loop_joint("joint", {.type = type, .a = near, .b = far, .pitch = pitch});
  return scene;
}

class EveryClosingJoint : public ::testing::TestWithParam<JointType> {};

// At states where the loop is open as well: reactions work along released directions as the gradient of f says, and on
// each body as its virtual displacement changes f.
TEST_P(EveryClosingJoint, HasReactionsThatAgreeWithItsConditions) {
  const Scene scene = with_closing_joint(GetParam());
  expect_passed(scene, {"constraint_motion", "constraint_wrenches", "derivations"});
  const WorkingDigits precision(50);
  const Equations equations(scene);
  const RandomState state(scene, 5);
  Evaluator<Real> here(equations.program(), state.in_real());
  Real along_moved(0), about_turned(0);
  for (const ConstraintRow& row : equations.constraints()) {
    along_moved += abs(here(row.column[row.column.size() - 2]));
    about_turned += abs(here(row.column.back()));
  }
  EXPECT_GT(along_moved.to_double(), 1e-3);
  EXPECT_GT(about_turned.to_double(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryClosingJoint,
                         ::testing::Values(JointType::weld, JointType::revolute, JointType::prismatic,
                                           JointType::helical, JointType::cylindrical, JointType::universal,
                                           JointType::spherical, JointType::planar, JointType::line_contact,
                                           JointType::sphere_in_cylinder, JointType::point_contact));

/// Force and moment on the link of a frame, at its origin in its axes.
std::array<double, 6> wrench_on(const Equations& equations, int constraint, const char* frame, Evaluator<Real>& here) {
  const auto wrenches = ideal_wrench(equations.model(), constraint);
  const Wrench& wrench = wrenches->at(equations.model().place(frame, "a test").link);
  std::array<double, 6> numbers;
  for (int i = 0; i < 3; ++i) {
    numbers[static_cast<std::size_t>(i)] = here(wrench.resultant[i]).to_double();
    numbers[static_cast<std::size_t>(i) + 3] = here(wrench.moment[i]).to_double();
  }
  return numbers;
}

// Multipliers of a weld are the components of force and moment on b (closed form where a and b coincide).
TEST(ClosureWrench, OfAWeldAreUnitForcesAndCouples) {
  Scene scene("weld");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle b = scene.free("b", scene.ground(), {x, y, z}, scene.attitude("e"));
  scene.body("b", b, Inertia::box(kilograms("2"), metres("1"), metres("0.4"), metres("0.6")));
  scene.loop_joint("weld", {.type = JointType::weld, .a = scene.ground(), .b = b});
  const Equations equations(scene);
  Evaluator<Real> here(equations.program(), [](const SymbolPointer& s) { return Real(s->name == "e_w" ? 1 : 0); });
  for (int k = 0; k < 6; ++k) {
    const std::array<double, 6> on_b = wrench_on(equations, k, "b", here),
                                on_a = wrench_on(equations, k, "ground", here);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(on_b[i], i == static_cast<std::size_t>(k) ? 1 : 0) << k << ' ' << i;
      EXPECT_EQ(on_a[i], -on_b[i]) << k << ' ' << i;
    }
  }
}

// A nut of mass m and moment J pushed along its thread of pitch p: x'' = F/(m + J/p²). The thread's force λ slows it
// down, m x'' = F + λ, and its moment turns it, J q'' = −p λ.
TEST(ClosureWrench, OfAThreadPushesTheNutBackAndTurnsIt) {
  constexpr double m = 2, J = 0.09, p = 0.1, force = 3;
  Scene scene = nut_on_a_thread();
  scene.motor("push", Expression(scene.content().coordinates[0].q));
  const Equations equations(scene);
  NamedState state(equations, {{"push", Real(3)}, {"x", rational(1, 5)}, {"q", Real(2)}});  // x = p q
  const double lambda = state.in_double(equations.forward().multipliers[0]);
  const double a = state.in_double(equations.forward().accelerations[0]);
  // Doubles of numbers of some ten operations in 50 digits: one rounding each.
  EXPECT_NEAR(a, force / (m + J / (p * p)), 1e-15);
  EXPECT_NEAR(lambda, m * a - force, 1e-15);
  Evaluator<Real> here(equations.program(), at({{"x", rational(1, 5)}, {"q", Real(2)}}));
  const std::array<double, 6> unit = wrench_on(equations, 0, "nut", here);
  EXPECT_NEAR(unit[0] * lambda, m * a - force, 1e-15);
  EXPECT_NEAR(unit[3] * lambda, J * a / p, 1e-15);
  for (const std::size_t i : {1U, 2U, 4U, 5U}) EXPECT_NEAR(unit[i], 0, 1e-15) << i;
}

// |e(h)|² = 1 + O(h³), and the twist of its rotation is ω.
TEST(MovingState, TurnsUnitQuaternionsByTheirAngularVelocity) {
  const WorkingDigits precision(100);
  const Scene scene = torque_free_body();
  const RandomState state(scene, 3);
  const MovingState motion(scene, state);
  const AttitudeContent& attitude = scene.content().attitudes[0];
  const Real h = pow(Real(10), -20);
  Real square(0);
  for (const SymbolPointer& e : attitude.symbols->e) {
    const Real component = motion.at(h)(e);
    square += component * component;
  }
  EXPECT_LT(abs(square - Real(1)).to_double(), 1e-58);
  Program program;
  const Model model(scene, program);
  const PosedScene posed(model);
  Evaluator<Real> before(program, motion.at(-h)), after(program, motion.at(h)), here(program, motion.at(Real(0)));
  const auto at = [&](Evaluator<Real>& evaluate) { return posed.at(evaluate).back().rotation; };
  const RealRotation r = at(here), r_before = at(before), r_after = at(after);
  for (int i = 0; i < 3; ++i) {  // ω_i = e_k · dė_j/dt along the moving axes, (i, j, k) cyclic
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const RealVector slope = (Real(1) / (Real(2) * h)) * (column(r_after, j) - column(r_before, j));
    const Real omega = dot(slope, column(r, k));
    const auto expected = state.in_real()(attitude.symbols->omega[static_cast<std::size_t>(i)]);
    EXPECT_LT(abs(omega - expected).to_double(), 1e-38) << i;  // h² times third derivatives
  }
}

}  // namespace
}  // namespace torsor::check_constraints_test
