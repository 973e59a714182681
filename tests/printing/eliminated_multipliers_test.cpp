// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/eliminated_multipliers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/written.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::printing::eliminated_multipliers_test {
namespace {

std::string printed(const Scene& scene) { return print_equations(scene, Format::text); }
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::optional<FreeEquations> free_equations(const Scene& scene) {
  LagrangeEquations equations(scene, {});
  return without_multipliers(equations);
}

/// What an equation gives for values of the symbols.
double value(const FreeEquation& equation, const std::map<std::string, int>& values) {
  const auto value_of = [&](const SymbolPointer& symbol) { return Real(values.at(symbol->name)); };
  return evaluate(collected(equation.residual), value_of, 40).to_double();
}

/// A wheel of radius r that rolls along x: x' = r phi'.
Scene wheel() {
  Scene s("wheel");
  const Expression m = s.parameter("m", "kg", 2), J = s.parameter("J", "kg m^2", 1), r = s.parameter("r", "m", 1);
  const Expression x = s.coordinate("x", "m"), phi = s.coordinate("phi", "rad");
  const FrameHandle axle = s.prismatic("axle", s.ground(), axis::x, x);
  const FrameHandle rim = s.revolute("rim", axle, axis::y, phi);
  s.body("rim", rim, Inertia::general({.mass = m, .yy = J}));
  s.nonholonomic("rolls", rate(x) - r * rate(phi));
  return s;
}

// The force of the edge is across it: cos psi (m x'') + sin psi (m y'') = 0 whatever it is, and nothing turns the sled.
// The multiplier comes from the equation of y, where it has the factor cos psi.
TEST(EliminatedMultipliers, AreThoseOfASledsEdge) {
  const Scene scene = test::sled();
  const std::optional<FreeEquations> free = free_equations(scene);
  ASSERT_TRUE(free);
  EXPECT_EQ(free->dependent, std::vector<std::string>{"y"});
  ASSERT_EQ(free->equations.size(), 2U);
  EXPECT_EQ(free->equations[0].coordinate.q->name, "x");
  EXPECT_EQ(free->equations[1].coordinate.q->name, "psi");
  EXPECT_EQ(text(collected(free->determinant)), "cos(psi)");
  EXPECT_TRUE(free->can_fail());
  const std::map<std::string, int> at{{"m", 3}, {"I", 5}, {"psi", 1}, {"x''", 7}, {"y''", -2}, {"psi''", 11}, {"x'", 1}, {"y'", 4}, {"psi'", -6}};
  // Two roundings to double.
  EXPECT_NEAR(value(free->equations[0], at), 3 * 7 + std::tan(1.0) * 3 * -2, 1e-14);
  EXPECT_NEAR(value(free->equations[1], at), 5 * 11, 1e-13);
  const std::string page = printed(scene);
  EXPECT_TRUE(contains(page, "Equations without multipliers\n  The multipliers from the equation of y, put into the others:\n  x:  "));
  EXPECT_TRUE(contains(page, "They hold where det C is not zero, C the factors of the multipliers in the equations that gave them:\n"
                             "  det C = cos(psi)\n"))
      << page;
}

// A radius is not zero: no place is said to be left out. m r x'' + J phi'' = 0 without a force.
TEST(EliminatedMultipliers, FailNowhereBehindAProductOfParameters) {
  const std::optional<FreeEquations> free = free_equations(wheel());
  ASSERT_TRUE(free);
  EXPECT_FALSE(free->can_fail());
  ASSERT_EQ(free->equations.size(), 1U);
  EXPECT_EQ(free->dependent, std::vector<std::string>{"phi"});
  // P_x + P_phi/r, for x' = r phi' and opposite signs of the force.
  EXPECT_NEAR(value(free->equations[0], {{"m", 3}, {"J", 5}, {"r", 2}, {"x''", 7}, {"phi''", 4}, {"phi", 1}, {"x'", 1}, {"phi'", 1}}), 3 * 7 + 5 * 4 / 2, 1e-13);
  const std::string page = printed(wheel());
  EXPECT_TRUE(contains(page, "The multipliers from the equation of phi, put into the other:"));
  EXPECT_FALSE(contains(page, "det C"));
}

// The reaction of a stop is in the equation of x alone: eliminated equations without it hold away from the stop.
TEST(EliminatedMultipliers, SayThatTheyLeaveContactsOut) {
  const std::string note = "They are those of the mechanism on which no contact acts.\n";
  EXPECT_FALSE(contains(printed(wheel()), note));
  Scene stopped = wheel();
  stopped.stop(Expression(stopped.content().coordinates[0].q), std::nullopt, Expression::quantity("1", "m"));
  EXPECT_TRUE(contains(printed(stopped), "put into the other:\n  " + note + "  x:")) << printed(stopped);
}

TEST(EliminatedMultipliers, CanFailWhereASumOrAFunctionMayVanish) {
  const Scene scene = wheel();
  const Sum a = Sum::symbol(scene.content().parameters[0].symbol), b = Sum::symbol(scene.content().parameters[1].symbol);
  const auto can_fail = [](const Sum& determinant) { return FreeEquations{{}, {}, determinant}.can_fail(); };
  EXPECT_FALSE(can_fail(Sum(Number(-2))));
  EXPECT_FALSE(can_fail(a * b));
  EXPECT_TRUE(can_fail([&] {
    Sum sum = a;
    sum += b;
    return sum;
  }()));
  EXPECT_TRUE(can_fail(Sum::function(Function::sin, a)));
  EXPECT_TRUE(can_fail(a * Sum::symbol(scene.content().coordinates[0].q)));
}

TEST(EliminatedMultipliers, AreLeftAloneWhereNothingIsGained) {
  EXPECT_FALSE(free_equations(test::absorber()));  // no constraint
  EXPECT_FALSE(contains(printed(test::absorber()), "Equations without multipliers"));
  Scene held = wheel();  // as many as coordinates
  held.nonholonomic("brake", rate(Expression(held.content().coordinates[1].q)));
  EXPECT_FALSE(free_equations(held));
}

}  // namespace
}  // namespace torsor::printing::eliminated_multipliers_test
