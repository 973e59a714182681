// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::actions_formula_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

// Values of fifty digits: an identity holds to 1e-45, far above rounding and far below any wrong term.
constexpr double exact = 1e-45;

/// Two points of 2 kg and 3 kg, free in a plane.
class TwoPoints : public ::testing::Test {
 protected:
  Scene scene{"two_points"};
  Expression x1 = scene.coordinate("x1", "m"), y1 = scene.coordinate("y1", "m");
  Expression x2 = scene.coordinate("x2", "m"), y2 = scene.coordinate("y2", "m");
  FrameHandle first, second;
  PointHandle a, b;
  Point state{{"x1", rational(1, 3)},   {"y1", rational(-1, 2)},  {"x2", rational(7, 5)},   {"y2", rational(2, 3)},
              {"x1'", rational(-3, 7)}, {"y1'", rational(5, 11)}, {"x2'", rational(8, 13)}, {"y2'", rational(9, 17)}};

  TwoPoints() {
    first = scene.prismatic("first", scene.prismatic("first_slide", scene.ground(), axis::x, x1), axis::y, y1);
    second = scene.prismatic("second", scene.prismatic("second_slide", scene.ground(), axis::x, x2), axis::y, y2);
    scene.body("first", first, Inertia::point(kilograms("2")));
    scene.body("second", second, Inertia::point(kilograms("3")));
    a = scene.point("A", first, {0, 0, 0});
    b = scene.point("B", second, {0, 0, 0});
  }
  const Real& of(const char* name) const { return state.at(name); }
};

TEST_F(TwoPoints, AttractEachOtherByTheInverseSquareOfTheirDistance) {
  scene.gravitation("attraction", a, b, Expression::quantity("11", "N m^2"));
  const Equations equations(scene);
  NamedState here(equations, state);
  const Real x = of("x2") - of("x1");
  const Real y = of("y2") - of("y1");
  const Real d = sqrt(x * x + y * y);
  const Real by_length = Real(11) / (d * d * d);
  EXPECT_LT(relative_difference(here(equations.actions().spring_force_function), Real(11) / d), exact);
  // The bias is −Q: the first point is pulled towards the second, the second towards the first.
  EXPECT_LT(relative_difference(-here(equations.bias()[0]), by_length * x), exact);
  EXPECT_LT(relative_difference(-here(equations.bias()[1]), by_length * y), exact);
  EXPECT_LT(relative_difference(-here(equations.bias()[2]), -by_length * x), exact);
  EXPECT_LT(relative_difference(-here(equations.bias()[3]), -by_length * y), exact);
  EXPECT_TRUE(equations.actions().without_force_function.empty());
}

TEST_F(TwoPoints, LosePowerToTheirAttractionWhileTheyMoveApart) {
  // P = −𝒢 m1 m2 P1P2 · d(P1P2)/dt / |P1P2|³, with its minus.
  scene.gravitation("attraction", a, b, Expression::quantity("11", "N m^2"));
  const Equations equations(scene);
  NamedState here(equations, state);
  const Real x = of("x2") - of("x1");
  const Real y = of("y2") - of("y1");
  const Real radial = x * (of("x2'") - of("x1'")) + y * (of("y2'") - of("y1'"));
  ASSERT_GT(radial, Real(0));
  const Real d = sqrt(x * x + y * y);
  Real power(0);
  const char* rates[] = {"x1'", "y1'", "x2'", "y2'"};
  for (std::size_t i = 0; i < 4; ++i) power -= here(equations.bias()[i]) * of(rates[i]);
  EXPECT_LT(relative_difference(power, -Real(11) * radial / (d * d * d)), exact);
  EXPECT_LT(power, Real(0));
}

TEST_F(TwoPoints, FollowAGivenForceFunction) {
  // U = −½ k (x1² y2) / l + c sin(x2/l): ∂U by hand.
  const Expression k = Expression::quantity("5", "N/m");
  const Expression l = metres("2");
  scene.force_function("field", -k * x1 * x1 * y2 / l / 2 + Expression::quantity("3", "J") * sin(x2 / l));
  const Equations equations(scene);
  NamedState here(equations, state);
  EXPECT_LT(relative_difference(here(equations.bias()[0]), Real(5) * of("x1") * of("y2") / Real(2)), exact);
  EXPECT_TRUE(here(equations.bias()[1]).is_zero());
  EXPECT_LT(relative_difference(here(equations.bias()[2]), -rational(3, 2) * cos(of("x2") / Real(2))), exact);
  EXPECT_LT(relative_difference(here(equations.bias()[3]), Real(5) * of("x1") * of("x1") / Real(4)), exact);
  // It joins U: the energy is a first integral.
  const PainleveReport report = painleve(equations);
  ASSERT_EQ(report.first_integrals.size(), 2U);
  EXPECT_EQ(report.first_integrals[0].name, "energy");
  EXPECT_EQ(report.first_integrals[1].name, "momentum_y1");
}

TEST_F(TwoPoints, AreMovedByAnEffortAlongItsDisplacement) {
  // A cubic damper on the stretch of a belt e = 2 x1 − x2.
  const Expression e = 2 * x1 - x2;
  scene.generalised_force("belt", e, Expression::quantity("-7", "N s^3/m^3") * pow(rate(e), 3));
  const Equations equations(scene);
  NamedState here(equations, state);
  const Real speed = Real(2) * of("x1'") - of("x2'");
  const Real force = Real(-7) * speed * speed * speed;
  EXPECT_LT(relative_difference(-here(equations.bias()[0]), Real(2) * force), exact);
  EXPECT_LT(relative_difference(-here(equations.bias()[2]), -force), exact);
  EXPECT_LT(relative_difference(here(equations.power()), force * speed), exact);
  EXPECT_EQ(equations.actions().without_force_function, std::vector<std::string>{"belt"});
  EXPECT_EQ(painleve(equations).failing_conditions, std::vector<std::string>{"'belt' has no force function"});
}

TEST(Wrench, WorksWithTheVelocityOfItsPointAndTheTurn) {
  // A lever turned by θ about z: the force (3, 4, 0) N in ground axes at (2, 0, 0) m of the lever and 5 N m about z.
  Scene scene("lever");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle lever = scene.revolute("lever", scene.ground(), axis::z, theta);
  scene.body("lever", lever, Inertia::rod(kilograms("3"), metres("4"), 0).at({metres("2"), 0, 0}));
  scene.point("P", lever, {metres("2"), 0, 0});
  const auto newtons = [](const char* value) { return Expression::quantity(value, "N"); };
  scene.wrench("push", {.body = lever,
                        .point = scene.point("P"),
                        .force = {newtons("3"), newtons("4"), 0},
                        .moment = {Expression::quantity("9", "N m"), 0, Expression::quantity("5", "N m")},
                        .axes = scene.ground()});
  const Equations equations(scene);
  const Real angle = rational(2, 3);
  NamedState here(equations, {{"theta", angle}, {"theta'", rational(3, 7)}});
  // OP ∧ F · z = 2 (4 cos θ − 3 sin θ).
  const Real torque = Real(2) * (Real(4) * cos(angle) - Real(3) * sin(angle)) + Real(5);
  EXPECT_LT(relative_difference(-here(equations.bias()[0]), torque), exact);
  EXPECT_LT(relative_difference(here(equations.power()), torque * rational(3, 7)), exact);
}

TEST_F(TwoPoints, RefuseFormulasThatAreNoForces) {
  const Expression push = scene.motor("push", x1);
  const auto refusal = [&](const auto& add) {
    Scene bad = scene;
    return error_of([&] {
      add(bad);
      Equations(bad).actions();
    });
  };
  EXPECT_EQ(refusal([&](Scene& s) { s.generalised_force("law", x2, 2 * push); }),
            "generalised force 'law' depends on accelerations, inputs or multipliers through 2*push: give a formula of "
            "coordinates, "
            "their rates, time and parameters");
  EXPECT_EQ(refusal([&](Scene& s) { s.force_function("U", Expression::quantity("1", "J s/m") * rate(x1)); }),
            "force function 'U' depends on more than coordinates, time and parameters: an action that depends on "
            "velocities has no force function; use generalised_force(...)");
  EXPECT_EQ(refusal([&](Scene& s) { s.force_function("U", Expression::quantity("1", "W") * s.time()); }),
            "force function 'U' depends on no unknown coordinate: it makes no force; drop it");
  EXPECT_EQ(refusal([&](Scene& s) { s.force_function("U", Expression::quantity("1", "J") * sign(x1)); }),
            "force function 'U' has the slope 0 along x1 but at its steps, where no force is finite: use a smooth function "
            "such as tanh, or a stop");
  EXPECT_EQ(refusal([&](Scene& s) { s.generalised_force("pull", x1, metres("2")); }),
            "the generalised force 'pull' on x1 [m] is 2 [m] and must be in N");
  EXPECT_EQ(refusal([&](Scene& s) { s.gravitation("g", a, b, Expression::quantity("1", "N")); }),
            "the strength of the gravitation 'g' is 1 [N] and must be in N m^2");
  Scene released = scene;
  const Expression held = released.released_coordinate("held", "m");
  released.generalised_force("stretch", x1 + held, Expression::quantity("1", "N"));
  EXPECT_EQ(error_of([&] { Equations(released).actions(); }),
            "generalised force 'stretch' names the released coordinate 'held', which its joint holds at zero: write it "
            "without, or "
            "between points");
}

}  // namespace
}  // namespace torsor::actions_formula_test
