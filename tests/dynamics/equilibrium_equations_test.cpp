// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/dynamics/theorems/stability.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/loops.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::equilibrium_equations_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

/// A bead on a vertical hoop of radius R that turns at omega about its vertical diameter, theta from the bottom. All
/// parameters have values: m = 2, R = 1, g = 981/100, omega = 5.
Scene turning_hoop(const std::string& angle = "uniform") {
  Scene scene("turning_hoop");
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression R = scene.parameter("R", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 5);
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression t = scene.time();
  const Expression turned = angle == "uniform" ? omega * t : omega * t * t * Expression::quantity("1", "1/s");
  const FrameHandle hoop = scene.revolute("hoop", scene.ground(), axis::z, turned);
  const FrameHandle radius = scene.revolute("radius", hoop, axis::y, theta);
  scene.body("bead", radius, Inertia::point(m).at({0, 0, -R}));
  scene.gravity({0, 0, -g});
  return scene;
}

ModelOptions symbolic_parameters() {
  ModelOptions options;
  options.symbolic_parameters = true;
  return options;
}

TEST(EquilibriumEquations, NameActionsThatAreFeltAtRestAlone) {
  Scene scene = turning_hoop();
  const SymbolPointer theta = scene.content().coordinates[0].q;
  scene.damper("oil", theta, Expression::quantity("1", "N m s"));
  EXPECT_EQ(equilibrium_equations(Equations(scene)).remarks,
            std::vector<std::string>{"Lejeune-Dirichlet presupposes that 'oil' dissipates and that inputs are zero"});
  scene.motor("drive", theta);
  scene.generalised_force("wind", theta, Expression::quantity("1", "N m") * cos(scene.time() * Expression::quantity("1", "1/s")));
  EXPECT_EQ(equilibrium_equations(Equations(scene)).remarks,
            std::vector<std::string>{"the forces at rest do not derive from U + T0: 'drive', 'wind' act at rest"});
}

TEST(EquilibriumEquations, OfADrivenSystemAreThoseOfTheRelativeEquilibrium) {
  const Equations equations(turning_hoop(), symbolic_parameters());
  const EquilibriumEquations statics = equilibrium_equations(equations);
  EXPECT_TRUE(statics.driven);
  EXPECT_TRUE(statics.from_potential);
  EXPECT_TRUE(statics.remarks.empty());
  ASSERT_EQ(statics.rows.size(), 1U);
  const WorkingDigits precision(50);
  for (const auto& [angle, speed] : {std::pair(rational(1, 3), rational(7, 2)), std::pair(rational(-5, 2), Real(2))}) {
    const Real m = rational(3, 2), R = rational(4, 5), g = rational(49, 5);
    NamedState state(equations, {{"theta", angle}, {"omega", speed}, {"m", m}, {"R", R}, {"g", g}, {"t", Real(1)}});
    const Real s = sin(angle), c = cos(angle), inertia = m * R * R * speed * speed;
    EXPECT_LT(relative_difference(state(statics.rows[0]), m * g * R * s - inertia * s * c), 1e-45);
    EXPECT_LT(relative_difference(state(statics.hessian[0][0]), m * g * R * c - inertia * (c * c - s * s)), 1e-45);
    EXPECT_LT(relative_difference(state(statics.potential), -m * g * R * c - rational(1, 2) * inertia * s * s), 1e-45);
  }
}

TEST(EquilibriumEquations, AreWrittenMultipliedOut) {
  const Equations equations(turning_hoop(), symbolic_parameters());
  const std::string text = print_equilibrium(equilibrium_equations(equations));
  EXPECT_NE(text.find("-(U + T0) = "), std::string::npos) << text;
  EXPECT_NE(text.find("theta:  0 = "), std::string::npos) << text;
  EXPECT_EQ(text.find(" z1"), std::string::npos) << "no definition is left:\n" << text;
}

TEST(EquilibriumEquations, OfAMotionThatSpeedsUpHaveNoPotential) {
  const Equations equations(turning_hoop("faster and faster"));
  const EquilibriumEquations statics = equilibrium_equations(equations);
  EXPECT_TRUE(statics.driven);
  // T0 is a function of time; the force along theta is still its derivative, there being no T1 along theta.
  EXPECT_TRUE(statics.from_potential);
  // A pendulum on an accelerated cart feels m x'' cos: T1 = m x' L cos θ θ' depends on time.
  Scene cart("cart");
  const Expression theta = cart.coordinate("theta", "rad");
  const Expression path = Expression::quantity("2", "m/s^2") * cart.time() * cart.time();
  const FrameHandle moving = cart.prismatic("cart", cart.ground(), axis::x, path);
  const FrameHandle arm = cart.revolute("arm", moving, axis::z, theta);
  cart.body("bob", arm, Inertia::point(kilograms("1")).at({0, metres("-1"), 0}));
  const EquilibriumEquations accelerated = equilibrium_equations(Equations(cart));
  EXPECT_FALSE(accelerated.from_potential);
  ASSERT_EQ(accelerated.remarks.size(), 1U);
  EXPECT_NE(accelerated.remarks[0].find("T depends on time"), std::string::npos);
}

TEST(EquilibriumEquations, CountInputsAndGivenForcesAndForgetDampers) {
  Scene scene = pendulum();
  const SymbolPointer theta = scene.content().coordinates[0].q;
  scene.damper("friction", theta, Expression::quantity("1", "N m s"));
  scene.motor("torque", theta);
  const Equations equations(scene);
  const EquilibriumEquations statics = equilibrium_equations(equations);
  EXPECT_FALSE(statics.driven);
  EXPECT_TRUE(statics.from_potential);
  ASSERT_EQ(statics.remarks.size(), 1U);
  EXPECT_NE(statics.remarks[0].find("'friction'"), std::string::npos);
  NamedState state(equations, {{"theta", rational(1, 2)}, {"torque", Real(3)}, {"theta'", Real(100)}});
  EXPECT_NEAR(state.in_double(statics.rows[0]), 2 * 9.81 * 1.5 * std::sin(0.5) - 3, 1e-13);

  Scene pushed = pendulum();
  pushed.force("wind", {.body = "arm",
                        .point = pushed.point("tip", "arm", {0, metres("-1.5"), 0}),
                        .components = {Expression::quantity("4", "N"), 0, 0},
                        .axes = pushed.ground()});
  const Equations with_wind(pushed);
  const EquilibriumEquations blown = equilibrium_equations(with_wind);
  EXPECT_FALSE(blown.from_potential);
  EXPECT_NE(blown.remarks[0].find("'wind'"), std::string::npos);
  NamedState leaning(with_wind, {{"theta", rational(1, 2)}});
  EXPECT_NEAR(leaning.in_double(blown.rows[0]), 2 * 9.81 * 1.5 * std::sin(0.5) - 4 * 1.5 * std::cos(0.5), 1e-13);
}

TEST(EquilibriumEquations, OfAConstrainedSceneHaveMultipliersAndConditions) {
  SlidingPoint it("on_a_circle", "3");
  it.scene.gravity({0, quantity("-10", "m/s^2"), 0});
  it.scene.holonomic("circle", it.x * it.x + it.y * it.y - quantity("4", "m^2"));
  const Equations equations(it.scene);
  const EquilibriumEquations statics = equilibrium_equations(equations);
  ASSERT_EQ(statics.conditions.size(), 1U);
  NamedState state(equations, {{"x", Real(3)}, {"y", Real(5)}, {"lambda_circle", Real(7)}});
  EXPECT_EQ(state.in_double(statics.rows[0]), -7 * 2 * 3);
  EXPECT_EQ(state.in_double(statics.rows[1]), 30 - 7 * 2 * 5);
  EXPECT_EQ(state.in_double(statics.conditions[0]), 9 + 25 - 4);
  EXPECT_EQ(state.in_double(statics.hessian[0][0]), -14);
  EXPECT_THROW(lejeune_dirichlet(equations, statics, [](const SymbolPointer&) { return Real(0); }), UsageError);
}

LejeuneDirichlet verdict(const Equations& equations, const Real& theta, const Real& omega) {
  return lejeune_dirichlet(equations, equilibrium_equations(equations), [&](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return Real::pi();
    return symbol->name == "theta" ? theta : symbol->name == "omega" ? omega : Real(0);
  });
}

// R = 1: the bottom loses its minimum at omega² = g; above it cos θ0 = g / omega².
TEST(LejeuneDirichletCriterion, FollowsTheBeadThroughItsBifurcation) {
  const WorkingDigits precision(50);
  const Equations equations(turning_hoop());
  const Real pi = Real::pi();
  EXPECT_TRUE(verdict(equations, Real(0), Real(2)).stable);
  EXPECT_FALSE(verdict(equations, Real(0), Real(5)).stable);
  const LejeuneDirichlet top = verdict(equations, pi, Real(2));
  EXPECT_FALSE(top.stable);
  EXPECT_NE(top.reason.find("cannot conclude"), std::string::npos);
  // cos θ0 = 0.3924 at omega = 5, published to 24 digits.
  const LejeuneDirichlet branch = verdict(equations, Real::parse("1.167556903805042963872909"), Real(5));
  EXPECT_TRUE(branch.stable);
  EXPECT_LT(abs(branch.residual[0]).to_double(), 1e-21);
  const LejeuneDirichlet critical = verdict(equations, Real(0), sqrt(rational(981, 100)));
  EXPECT_FALSE(critical.stable);
  EXPECT_NE(critical.reason.find("zero within rounding"), std::string::npos) << critical.reason;
}

/// A point on a spring along a slide, on a table that turns: T0 = (turn')² x²/2.
Scene slide_on_a_table(bool swings, bool shaken) {
  Scene scene("table");
  const Expression x = scene.coordinate("x", "m");
  const Expression phase = Expression::quantity("2", "rad/s") * scene.time(), k = Expression::quantity("9", "N/m");
  const FrameHandle table = scene.revolute("table", scene.ground(), axis::z, swings ? cos(phase) : phase);
  scene.body("point", scene.prismatic("slide", table, axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
  scene.spring("spring", x, shaken ? k * (1 + 0.9_r * cos(phase)) : k);
  return scene;
}

// x'' + k (1 + 9/10 cos 2t) x = 0 (Mathieu) has a minimum of -U at every instant, and grows.
TEST(LejeuneDirichletCriterion, ConcludesNothingWhereTimeStands) {
  const WorkingDigits precision(50);
  const auto judged = [](bool swings, bool shaken) {
    const Equations equations(slide_on_a_table(swings, shaken));
    return lejeune_dirichlet(equations, equilibrium_equations(equations), [](const SymbolPointer&) { return Real(0); });
  };
  EXPECT_TRUE(judged(false, false).stable);
  for (const LejeuneDirichlet& verdict : {judged(true, false), judged(false, true)}) {
    EXPECT_FALSE(verdict.stable);
    EXPECT_EQ(verdict.reason, "cannot conclude: T or U depends on time explicitly, and the energy is no integral");
  }
}

// On a lift that rises by v t the force function has m g v t, which no coordinate feels: a pendulum is as stable there.
TEST(LejeuneDirichletCriterion, ConcludesWhereTimeAloneStandsInU) {
  const WorkingDigits precision(50);
  Scene scene("lift");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle lift = scene.prismatic("lift", scene.ground(), axis::z, Expression::quantity("2", "m/s") * scene.time());
  const FrameHandle rod = scene.revolute("rod", lift, axis::y, theta);
  scene.body("bob", rod, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, Expression::quantity("-1", "m")}));
  scene.gravity({0, 0, Expression::quantity("-10", "m/s^2")});
  const Equations equations(scene);
  EXPECT_TRUE(
      lejeune_dirichlet(equations, equilibrium_equations(equations), [](const SymbolPointer&) { return Real(0); }).stable);
}

// -U = (a x² + 2 b x y + c y²)/2: a minimum where a > 0 and c - b²/a > 0, the pivots, whatever a and c are by
// themselves.
TEST(LejeuneDirichletCriterion, LooksAtTheCouplingOfTwoCoordinates) {
  const WorkingDigits precision(50);
  const auto judged = [](int a, int b, int c) {
    Scene scene("saddle");
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
    scene.body("point", scene.prismatic("point", slide, axis::y, y), Inertia::point(Expression::quantity("1", "kg")));
    const Expression stiffness = Expression::quantity("1", "N/m");
    scene.force_function("field", -stiffness * (a * x * x + 2 * b * x * y + c * y * y) / 2);
    const Equations equations(scene);
    return lejeune_dirichlet(equations, equilibrium_equations(equations), [](const SymbolPointer&) { return Real(0); });
  };
  const LejeuneDirichlet minimum = judged(2, 1, 3);
  EXPECT_TRUE(minimum.stable);
  ASSERT_EQ(minimum.pivots.size(), 2U);
  EXPECT_LT(relative_difference(minimum.pivots[1], rational(5, 2)), 1e-45);
  EXPECT_FALSE(judged(1, 2, 1).stable);
  const LejeuneDirichlet valley = judged(1, -1, 1);
  EXPECT_FALSE(valley.stable);
  EXPECT_NE(valley.reason.find("pivot 2 of the Hessian of -(U + T0) is 0"), std::string::npos) << valley.reason;
}

TEST(SylvesterConditions, AreTheConditionsOfTheBottomOfTheHoop) {
  const Scene scene = turning_hoop();
  const Equations equations(scene, symbolic_parameters());
  const EquilibriumEquations statics = equilibrium_equations(equations);
  const AtState bottom(equations, {{Expression(scene.content().coordinates[0].q), 0}});
  const auto conditions = sylvester_conditions(equations.program(), bottom(statics.hessian));
  ASSERT_EQ(conditions.size(), 1U);
  EXPECT_EQ(readable(conditions[0]), "-omega^2 m R^2 + m R g");
}

// Of the five conditions of a revolute joint the three that lead out of the plane hold wherever the links are.
TEST(EquilibriumEquations, HaveNoConditionThatEveryPlaceFulfils) {
  FourBar bar("four_bar");
  const auto [tip, end] = bar.ends();
  bar.scene.loop_joint("pin", {.type = JointType::revolute, .a = tip, .b = end});
  const Equations equations(bar.scene);
  EXPECT_EQ(equations.constraints().size(), 5u);
  const EquilibriumEquations statics = equilibrium_equations(equations);
  EXPECT_EQ(statics.conditions.size(), 2u);
  EXPECT_EQ(print_equilibrium(statics).find("0 = 0"), std::string::npos) << print_equilibrium(statics);
}

TEST(AtState, RefusesWhatIsNoSymbolAndOtherUnits) {
  const Scene scene = turning_hoop();
  const Equations equations(scene);
  const Expression theta(scene.content().coordinates[0].q);
  EXPECT_THROW(AtState(equations, {{theta + 1, 0}}), UsageError);
  EXPECT_THROW(AtState(equations, {{theta, Expression::quantity("1", "m")}}), UnitError);
}

TEST(Determinant, IsMultipliedOutExactly) {
  Program program;
  const Value a = program.symbol(make_symbol("a")), b = program.symbol(make_symbol("b"));
  const Value one = program.number(Number(1));
  // Vandermonde: (b − a)(1 − a)(1 − b), and twice the same row.
  const ValueMatrix vandermonde{{one, a, a * a}, {one, b, b * b}, {one, one, one}};
  const Value expected = multiplied_out(program.bind((b - a)) * program.bind(one - a) * program.bind(one - b));
  EXPECT_TRUE((determinant(program, vandermonde) - expected).is_zero());
  EXPECT_TRUE(determinant(program, {{a, b, one}, {b, a, one}, {a, b, one}}).is_zero());
  const Value sine = program.sin(a), cosine = program.cos(a);
  EXPECT_TRUE(determinant(program, {{cosine, -sine}, {sine, cosine}}).is_number(1));
  EXPECT_THROW(determinant(program, {{a, b}}), UsageError);
}

}  // namespace
}  // namespace torsor::equilibrium_equations_test
