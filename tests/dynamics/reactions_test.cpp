// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::reactions_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

const Real mass(2), length = Real(Number::rational(3, 2), 50), g = Real(Number::rational(981, 100), 50);

/// Newton's law along the rod: tension = m (g cos θ + l θ̇²).
Real tension(const Real& theta, const Real& rate) { return mass * (g * cos(theta) + length * rate * rate); }
/// The motion: l θ̈ = −g sin θ.
Real acceleration(const Real& theta) { return -g * sin(theta) / length; }

TEST(ReleasedCoordinate, GivesTheTensionInTheRodOfAPendulum) {
  Scene scene("pendulum_with_rod");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression stretch = scene.released_coordinate("stretch", "m");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, theta);
  const FrameHandle tip = scene.prismatic("tip", arm, -axis::y, stretch, {.origin = {0, metres("-1.5"), 0}});
  scene.body("bob", tip, Inertia::point(kilograms("2")));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  const Equations equations(scene);
  ASSERT_EQ(equations.model().unknown_count(), 1);
  ASSERT_EQ(equations.model().released_count(), 1);
  for (const auto& [angle, rate] :
       {std::pair(rational(1, 3), rational(7, 5)), std::pair(rational(-9, 4), rational(2, 9))}) {
    NamedState state(equations, {{"theta", angle}, {"theta'", rate}, {"theta''", acceleration(angle)}});
    // The reaction along the outward direction is that of the rod on the bob, inwards: −tension.
    EXPECT_LT(relative_difference(state(equations.inverse_dynamics()[1]), -tension(angle, rate)), 1e-45);
    EXPECT_LT(relative_difference(state(equations.inverse_dynamics()[0]), Real(0)), 1e-45);
    EXPECT_LT(relative_difference(state(equations.forward().accelerations[0]), acceleration(angle)), 1e-45);
  }
}

/// Released angles and displacements at the root of a two-link chain in space: with the chain isolated, the force and
/// the moment at its root are d(momentum)/dt minus weight, from positions alone.
TEST(ReleasedCoordinate, GivesTheForceThatNewtonGivesForTheIsolatedChain) {
  Scene scene("chain");
  const Expression g_value = Expression::quantity("9.81", "m/s^2");
  Triple slides;
  FrameHandle frame = scene.ground();
  for (std::size_t i = 0; i < 3; ++i) {
    slides[i] = scene.released_coordinate(std::string("R") + "xyz"[i], "m");
    frame = scene.prismatic("slide" + std::to_string(i), frame,
                            i == 0   ? axis::x
                            : i == 1 ? axis::y
                                     : axis::z,
                            slides[i]);
  }
  const Expression q1 = scene.coordinate("q1", "rad");
  const Expression q2 = scene.coordinate("q2", "rad");
  const FrameHandle first = scene.revolute("first", frame, axis::z, q1);
  const FrameHandle second = scene.revolute("second", first, axis::x, q2, {.origin = {metres("0.8"), 0, 0}});
  scene.body("first", first, Inertia::rod(kilograms("1.5"), metres("0.8"), 0).at({metres("0.4"), 0, 0}));
  scene.body("second", second, Inertia::rod(kilograms("0.7"), metres("0.6"), 1).at({0, metres("0.3"), 0}));
  scene.gravity({0, 0, -g_value});
  const Equations equations(scene);

  // G1 = 0.4 (c1, s1, 0), G2 = 0.8 (c1, s1, 0) + 0.3 (−s1 c2, c1 c2, s2), differentiated twice in the test's program.
  const Expression t1 = q1;
  const Expression t2 = q2;
  const std::array<Expression, 3> momentum_potential{
      (1.5_r * 0.4_r + 0.7_r * 0.8_r) * cos(t1) - 0.7_r * 0.3_r * sin(t1) * cos(t2),
      (1.5_r * 0.4_r + 0.7_r * 0.8_r) * sin(t1) + 0.7_r * 0.3_r * cos(t1) * cos(t2), 0.7_r * 0.3_r * sin(t2)};
  const Point point{{"q1", rational(2, 3)},    {"q1'", rational(5, 4)},   {"q1''", rational(-7, 3)},
                    {"q2", rational(-11, 10)}, {"q2'", rational(13, 10)}, {"q2''", rational(1, 7)}};
  NamedState state(equations, point);
  for (std::size_t i = 0; i < 3; ++i) {
    Program program;
    const Value second_derivative = program.lower(rate(rate(momentum_potential[i])));
    Evaluator<Real> evaluate(program, at(point));
    Real force = evaluate(second_derivative);
    if (i == 2) force += rational(22, 10) * g;
    EXPECT_LT(relative_difference(state(equations.inverse_dynamics()[2 + i]), force), 1e-45) << i;
  }
}

/// A bob of 2 kg at the length of its rod, placed by x and y.
struct CartesianPendulum : SlidingPoint {
  Expression r = sqrt(x * x + y * y);
  ConstraintHandle rod = scene.holonomic("rod", metres("1.5") - r);
  CartesianPendulum() : SlidingPoint("cartesian_pendulum", "2") { scene.gravity({0, quantity("-9.81", "m/s^2"), 0}); }
};

TEST(Multiplier, OfAUnitGradientIsTheForceItself) {
  // f = l − r has ∂f/∂(x, y) = −(x, y)/r: λ pulls inwards, so that λ is the tension.
  const Equations equations(CartesianPendulum().scene);
  const Real angle = rational(4, 5);
  const Real rate = rational(3, 2);
  NamedState state(equations, {{"x", length * sin(angle)},
                               {"y", -length * cos(angle)},
                               {"x'", length * cos(angle) * rate},
                               {"y'", length * sin(angle) * rate}});
  const ForwardSolution& forward = equations.forward();
  EXPECT_LT(relative_difference(state(forward.multipliers[0]), tension(angle, rate)), 1e-45);
  const Real s_ddot = length * acceleration(angle);
  EXPECT_LT(
      relative_difference(state(forward.accelerations[0]), s_ddot * cos(angle) - length * rate * rate * sin(angle)),
      1e-45);
  EXPECT_LT(
      relative_difference(state(forward.accelerations[1]), s_ddot * sin(angle) + length * rate * rate * cos(angle)),
      1e-45);
}

TEST(Multiplier, IsTheIntensityOfItsNamedReaction) {
  // The same rod, its force named: unit vector from the bob to the pivot, so R = tension.
  CartesianPendulum it;
  it.scene.reaction(
      it.rod, "R",
      {.body = it.point, .contact = it.place, .direction = {-it.x / it.r, -it.y / it.r, 0}, .axes = it.scene.ground()});
  const Equations equations(it.scene);
  const Real angle = rational(-6, 5);
  NamedState state(equations, {{"x", length * sin(angle)}, {"y", -length * cos(angle)}});
  EXPECT_LT(relative_difference(state(equations.forward().multipliers[0]), tension(angle, Real(0))), 1e-45);
  const ConstraintRow& row = equations.constraints()[0];
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(identically_zero(row.column[i] - row.jacobian[i]));
}

// A locomotive of 2 kg is pushed and pulls a car of 3 kg by a bar without mass: F = 5 a, and the bar pulls the car by 3 a
// and the locomotive by -3 a.
TEST(Multiplier, ActsOnBothBodiesOfItsNamedReaction) {
  Scene scene("train");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle locomotive = scene.prismatic("locomotive", scene.ground(), axis::x, x);
  const FrameHandle car = scene.prismatic("car", scene.ground(), axis::x, y);
  scene.body("locomotive", locomotive, Inertia::point(kilograms("2")));
  scene.body("car", car, Inertia::point(kilograms("3")));
  scene.motor("push", x);
  const ConstraintHandle bar = scene.holonomic("bar", y - x + metres("4"));
  scene.reaction(bar, "R",
                 {.body = car,
                  .contact = scene.point("hook", car, {0, 0, 0}),
                  .direction = axis::x,
                  .axes = scene.ground(),
                  .other = locomotive});
  const Equations equations(scene);
  NamedState state(equations, {{"push", Real(10)}});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(relative_difference(state(equations.forward().accelerations[i]), Real(2)), 1e-45);
  }
  EXPECT_LT(relative_difference(state(equations.forward().multipliers[0]), Real(6)), 1e-45);
}

TEST(Constraint, HasTheRateAndTheDriftOfItsValueAlongAMotion) {
  Scene scene("closed_loop");
  const Expression a = scene.coordinate("a", "rad");
  const Expression b = scene.coordinate("b", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle second = scene.revolute("second", first, {1, 2, 2}, b, {.origin = {metres("0.7"), 0, 0}});
  scene.body("first", first, Inertia::box(kilograms("1"), metres("1"), metres("1"), metres("1")));
  scene.body("second", second, Inertia::box(kilograms("1"), metres("1"), metres("1"), metres("1")));
  scene.point("A", scene.ground(), {metres("0.2"), 0, 0});
  scene.point("B", second, {0, metres("0.5"), metres("0.1")});
  scene.closure("along_y", scene.point("A"), scene.point("B"), axis::y);
  scene.holonomic("moving", sin(a) * b - scene.time() / Expression::quantity("7", "s"));
  const Equations equations(scene);
  // a(t) = 1/3 + t/2 − t²/5, b(t) = 1/4 − t + t²/3 around t = 1/2; value, rate and acceleration by differences.
  const auto state_at = [&](const Real& t) {
    return Point{{"t", t},
                 {"a", rational(1, 3) + t * rational(1, 2) - t * t * rational(1, 5)},
                 {"a'", rational(1, 2) - t * rational(2, 5)},
                 {"b", rational(1, 4) - t + t * t * rational(1, 3)},
                 {"b'", -Real(1) + t * rational(2, 3)}};
  };
  const Real now = rational(1, 2);
  const Real h = power_of_ten(-15);
  for (const ConstraintRow& row : equations.constraints()) {
    NamedState before(equations, state_at(now - h)), here(equations, state_at(now)),
        after(equations, state_at(now + h));
    const Real rate = (after(row.value) - before(row.value)) / (h + h);
    const Real drift = (after(row.rate) - before(row.rate)) / (h + h);
    // Differences of step 1e-15: truncation 1e-30, rounding 1e-50/1e-15.
    EXPECT_LT(relative_difference(here(row.rate), rate), 1e-27) << row.name;
    const Real accelerated =
        here(row.jacobian[0]) * rational(-2, 5) + here(row.jacobian[1]) * rational(2, 3) + here(row.gamma);
    EXPECT_LT(relative_difference(accelerated, drift), 1e-27) << row.name;
  }
  // The closure starts from true positions: AB · y of the two points by hand at a = b = 0.
  NamedState flat(equations, {});
  EXPECT_LT(relative_difference(flat(equations.constraints()[0].value), rational(1, 2)), 1e-45);
}

}  // namespace
}  // namespace torsor::reactions_test
