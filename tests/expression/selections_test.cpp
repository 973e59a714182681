// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/series_evaluation.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::selections_test {
namespace {

using namespace testing_symbols;

class SelectionsTest : public ::testing::Test {
 protected:
  SymbolPointer sx = make_symbol("x"), sy = make_symbol("y");
  Expression x = sx, y = sy;
  Program program;

  Value lowered(const Expression& formula) { return program.lower(formula); }
  bool same(const Expression& a, const Expression& b) { return (lowered(a) - lowered(b)).is_zero(); }
  Real value(const Value& of, const Real& at_x, const Real& at_y = Real(1)) {
    Evaluator<Real> evaluate(program, at({{"x", at_x}, {"y", at_y}}));
    return evaluate(of);
  }
  double number(const Expression& formula, double at_x, double at_y = 1) {
    return value(lowered(formula), Real::from_double(at_x), Real::from_double(at_y)).to_double();
  }
};

using Selections = SelectionsTest;

TEST_F(Selections, TakeTheFormThatCounts) {
  EXPECT_EQ(number(abs(x), -2.5), 2.5);
  EXPECT_EQ(number(abs(x), 0), 0);
  EXPECT_EQ(number(sign(x), -2.5), -1);
  EXPECT_EQ(number(sign(x), 0), 0);
  EXPECT_EQ(number(max(x, y), -2, 3), 3);
  EXPECT_EQ(number(min(x, y), -2, 3), -2);
  EXPECT_EQ(number(max(x, 0), -2), 0);
  const Expression stairs = piecewise({{x < 1, 10}, {x <= 2, 20}, {x > 5, 40}}, 30);
  const std::vector<std::pair<double, double>> wanted{{0, 10}, {1, 20}, {2, 20}, {2.5, 30}, {5, 30}, {5.5, 40}};
  for (const auto& [at_x, step] : wanted) EXPECT_EQ(number(stairs, at_x), step) << at_x;
}

TEST_F(Selections, AreSharedUpToSignAndOrder) {
  EXPECT_TRUE(same(abs(x - y), abs(y - x)));
  EXPECT_TRUE(same(abs(-3 * x), 3 * abs(x)));
  EXPECT_TRUE(same(sign(x - y), -sign(y - x)));
  EXPECT_TRUE(same(sign(2 * x), sign(x)));
  EXPECT_TRUE(same(max(x, y), max(y, x)));
  EXPECT_TRUE(same(min(x, y), min(y, x)));
  EXPECT_TRUE(same(max(x, x), x));
  EXPECT_TRUE(same(max(x + 1, x), x + 1));
  EXPECT_TRUE(same(atan2(-y, x), -atan2(y, x)));
  EXPECT_TRUE(same(piecewise({{x < 1, y}}, y), y));
  EXPECT_TRUE(same(piecewise({{Expression(1) < 2, x}}, y), x));
  EXPECT_TRUE(same(abs(-5), 5));
}

TEST_F(Selections, KnowTheAnglesThatAreExact) {
  const Expression root = sqrt(Expression(3));
  EXPECT_TRUE(same(atan2(1, 1), pi() / 4));
  EXPECT_TRUE(same(atan2(0, -1), pi()));
  EXPECT_TRUE(same(atan2(-1, 0), -pi() / 2));
  EXPECT_TRUE(same(atan2(-2, 2 * root), -pi() / 6));
  EXPECT_TRUE(same(atan2(root, -1), 2 * pi() / 3));
  EXPECT_TRUE(same(atan2(0, 3), 0));
}

TEST_F(Selections, HaveUnits) {
  const Expression mass = make_symbol("mass", "kg"), length = make_symbol("length", "m");
  EXPECT_EQ(abs(length).unit(), units::metre);
  EXPECT_EQ(sign(length).unit(), Unit());
  EXPECT_EQ(max(length, 0).unit(), units::metre);
  EXPECT_EQ(max(0, length).unit(), units::metre);
  EXPECT_EQ(atan2(length, 2 * length).unit(), Unit());
  EXPECT_EQ(piecewise({{mass > Expression::quantity("2", "kg"), length}}, 0).unit(), units::metre);
  EXPECT_EQ(error_of<UnitError>([&] { max(mass, length); }),
            "the argument 2 of max(mass, length) has the unit m and another one kg: give them one unit");
  EXPECT_EQ(error_of<UnitError>([&] { atan2(mass, length); }).substr(0, 14), "the argument 2");
  EXPECT_NE(error_of<UnitError>([&] { piecewise({{mass < 1, length}}, length); }).find("cannot add"), std::string::npos);
  EXPECT_EQ(partial_derivation(program, length.as_symbol())(lowered(abs(length))).unit(), Unit());
  EXPECT_EQ(gradient(lowered(max(length, 0)), {length.as_symbol()})[0].unit(), Unit());
}

/// Forward and reverse, against central differences of 50 digits with a step of 1e-15: their error is of the order of
/// the step squared times the third derivative, below 1e-26 for slopes of the size of one.
TEST_F(Selections, AreDifferentiatedWhereTheyAreSmooth) {
  const std::vector<Expression> formulas{abs(x),
                                         x * abs(x),
                                         sign(x) * x * x,
                                         max(x * x, y),
                                         min(sin(x), x * y),
                                         atan2(x, y),
                                         atan2(y * x, sin(x) + y),
                                         piecewise({{x < 0, sin(x)}, {x < 1, x}}, sqrt(x)),
                                         exp(-max(x, y)) * atan2(x, 1),
                                         spline(x, {{-2, 1}, {-1, 0}, {0.5, 2}, {3, 1}})};
  for (const Expression& formula : formulas) {
    const Value f = lowered(formula);
    const Value forward = partial_derivation(program, sx)(f);
    const Value reverse = gradient(f, {sx, sy})[0];
    for (const auto& [at_x, at_y] : {std::pair(rational(-7, 5), rational(4, 7)), {rational(2, 7), rational(-5, 3)},
                                     {rational(8, 3), rational(1, 9)}}) {
      const Real h = Real(Number(10).pow(-15), 50);
      const Real wanted = (value(f, at_x + h, at_y) - value(f, at_x - h, at_y)) / (Real(2) * h);
      EXPECT_LT(relative_difference(value(forward, at_x, at_y), wanted), 1e-26) << formula.to_string();
      EXPECT_LT(relative_difference(value(reverse, at_x, at_y), wanted), 1e-26) << formula.to_string();
    }
  }
}

/// The root has no value where its form does not count: 0 times its slope is no number.
TEST_F(Selections, MakeATanhOfEveryArgument) {
  const Value value = lowered(tanh(x)), once = partial_derivation(program, sx)(value),
              twice = partial_derivation(program, sx)(once);
  for (const double place : {-1e300, -800.0, -40.0, -3.0, -0.25, -1e-9, 0.0, 1e-9, 0.25, 3.0, 40.0, 360.0, 800.0, 1e300}) {
    Evaluator<double> evaluate(program, [place](const SymbolPointer&) { return place; });
    const double t = std::tanh(place), c = std::abs(place) < 700 ? 1 / std::cosh(place) : 0, slope = c * c;
    EXPECT_NEAR(evaluate(value), t, 2e-16) << place;
    EXPECT_NEAR(evaluate(once), slope, 1e-15 * slope) << place;
    EXPECT_NEAR(evaluate(twice), -2 * t * slope, 4e-15 * slope) << place;
  }
  const std::string refused = error_of<UnitError>([&] { (void)tanh(Expression::quantity("1", "m")); });
  EXPECT_EQ(refused.find("the argument of tanh(1) "), 0U) << refused;
}

TEST_F(Selections, KeepFormsThatDoNotCountOutOfDerivatives) {
  const Value f = lowered(piecewise({{x > 0, x * sqrt(x)}}, 0));
  for (const Value& slope : {partial_derivation(program, sx)(f), gradient(f, {sx})[0]}) {
    EXPECT_TRUE(value(slope, rational(-1, 2)).is_zero());
    EXPECT_LT(relative_difference(value(slope, rational(1, 4)), rational(3, 4)), 1e-45);
  }
}

TEST_F(Selections, AreNoNumberWhereTheirConditionIsNone) {
  const Value f = lowered(piecewise({{sqrt(x) < 1, 1}}, 2));
  EXPECT_TRUE(value(f, Real(-1)).is_nan());
  EXPECT_TRUE(value(lowered(max(sqrt(x), y)), Real(-1)).is_nan());
  EXPECT_TRUE(value(lowered(abs(log(x))), Real(-1)).is_nan());
  EXPECT_TRUE(value(lowered(sign(log(x))), Real(-1)).is_nan());
}

/// A force that acts in a narrow window only is silent at nearly every random state.
TEST_F(Selections, AreNotTakenForZeroWhereTheyAreSilent) {
  const Expression window = piecewise({{x < Expression(20001) / 10000, 0}, {x < Expression(20002) / 10000, y}}, 0);
  EXPECT_FALSE(identically_zero(lowered(window)));
  EXPECT_FALSE(identically_zero(lowered(x * window - y * window)));
  EXPECT_FALSE(identically_zero(lowered(max(x - 123456, 0))));
  EXPECT_FALSE(identically_zero(lowered(abs(x - 100000) - 100000 + x)));  // zero below 100000
  EXPECT_FALSE(identically_zero(lowered(sign(x + 1000000) - 1)));
  EXPECT_FALSE(identically_zero(lowered(max(max(x, 50000), y) - 50000)));
}

TEST_F(Selections, VanishWhereEachOfTheirFormsDoes) {
  const Expression turn = pow(sin(x + y), 2) + pow(cos(x + y), 2) - 1, sum = sin(x + y) - sin(x) * cos(y) - cos(x) * sin(y);
  EXPECT_TRUE(identically_zero(lowered(piecewise({{x < 1, sum}}, 0))));
  EXPECT_TRUE(identically_zero(lowered(max(x, y) * sum + turn)));
  EXPECT_TRUE(identically_zero(lowered(abs(x) * sign(x) - x)));
  EXPECT_TRUE(identically_zero(lowered(pow(abs(x), 2) - x * x)));
}

TEST(Atan2, HasTheAngleOfEveryVectorInHighPrecision) {
  // tan(pi/12) = 2 - sqrt(3): every multiple of pi/12 but those on the cut.
  for (int k = -11; k <= 12; ++k) {
    const Real angle = Real(k) * Real::pi() / Real(12), length = rational(7, 3);
    const Real found = atan2(length * sin(angle), length * cos(angle));
    EXPECT_LT(relative_difference(k == 12 ? abs(found) : found, angle), 1e-48) << k;  // sin(pi) is rounded
  }
  EXPECT_TRUE(atan2(Real(0), Real(0)).is_zero());
  EXPECT_TRUE(atan2(Real::not_a_number(), Real(1)).is_nan());
}

TEST(Spline, PassesThroughItsPointsTwiceContinuously) {
  Program program;
  const SymbolPointer sx = make_symbol("x", "m");
  const Expression x = sx;
  const std::vector<std::array<double, 2>> points{{-1, 0.5}, {0.25, 2}, {1, -1}, {2.5, 0}, {4, 3}};
  for (const auto& ends : {std::optional<std::array<double, 2>>(), std::optional<std::array<double, 2>>({{0.5, -2}})}) {
    const Value f = program.lower(spline(x, points, "N", ends));
    EXPECT_EQ(f.unit(), units::newton);
    const Value slope = partial_derivation(program, sx)(f), curvature = partial_derivation(program, sx)(slope);
    const auto value = [&](const Value& of, const Real& at_x) { return Evaluator<Real>(program, at({{"x", at_x}}))(of); };
    const Real tiny(Number(10).pow(-25), 50);
    for (const auto& [abscissa, ordinate] : points) {
      const Real knot = Real::from_double(abscissa);
      EXPECT_LT(relative_difference(value(f, knot), Real::from_double(ordinate)), 1e-28);
      EXPECT_LT(relative_difference(value(f, knot - tiny), value(f, knot + tiny)), 1e-23);
      EXPECT_LT(relative_difference(value(slope, knot - tiny), value(slope, knot + tiny)), 1e-23);
      const bool inner = abscissa > -1 && abscissa < 4;
      if (inner || !ends) {
        EXPECT_LT(relative_difference(value(curvature, knot - tiny), value(curvature, knot + tiny)), 1e-23) << abscissa;
      }
    }
    if (!ends) continue;
    EXPECT_LT(relative_difference(value(slope, Real(-1)), rational(1, 2)), 1e-28);
    EXPECT_LT(relative_difference(value(slope, Real(5)), Real(-2)), 1e-28);  // a straight line from the end on
  }
}

/// A complete spline reproduces a cubic (de Boor, ch. IV): between its points too.
TEST(Spline, ReproducesACubicFromItsEndSlopes) {
  Program program;
  const SymbolPointer sx = make_symbol("x");
  const auto cubic = [](double u) { return ((0.5 * u - 1) * u + 2) * u - 3; };
  const auto slope = [](double u) { return (1.5 * u - 2) * u + 2; };
  std::vector<std::array<double, 2>> points;
  for (const double u : {-2.0, -1.0, 0.5, 1.0, 3.0}) points.push_back({u, cubic(u)});
  const Value f = program.lower(spline(Expression(sx), points, "1", std::array<double, 2>{slope(-2), slope(3)}));
  for (const double u : {-1.75, -0.25, 0.75, 2.5}) {
    // Slopes are rounded to 30 digits.
    EXPECT_LT(relative_difference(Evaluator<Real>(program, at({{"x", Real::from_double(u)}}))(f),
                                  Real::from_double(cubic(u))), 1e-28);
  }
}

TEST(Spline, RefusesPointsThatMakeNone) {
  const Expression x = make_symbol("x");
  EXPECT_EQ(error_of([&] { spline(x, {{1, 2}}); }), "a spline needs at least two points and has 1");
  EXPECT_EQ(error_of([&] { spline(x, {{1, 2}, {1, 3}}); }), "the abscissae of a spline must grow, and 1 comes after 1");
}

/// Coefficients of w with w' = f(x, s), x' = 1, s' = x around x = 3/5, s = −2/5, against those of the form that is
/// taken there.
void expect_series_of(const std::function<Expression(const Expression&, const Expression&)>& f,
                      const std::function<Expression(const Expression&, const Expression&)>& form,
                      double tolerance = 1e-45) {
  const WorkingDigits precision(60);
  constexpr int order = 20;
  const auto coefficients = [&](const auto& rate) {
    Program program;
    const std::vector<SymbolPointer> state{make_symbol("x", "1", SymbolKind::velocity),
                                           make_symbol("s", "1", SymbolKind::velocity),
                                           make_symbol("w", "1", SymbolKind::velocity)};
    const Value one = program.number(Number(1)), x = program.symbol(state[0]);
    const Value changing = program.lower(rate(Expression(state[0]), Expression(state[1])));
    const SeriesProgram series(program, {one, x, changing});
    Evaluator<Real> here(program, [](const SymbolPointer& symbol) {
      return symbol->kind == SymbolKind::pi ? Real::pi() : symbol->name == "s" ? rational(-2, 5) : rational(3, 5);
    });
    return SeriesEvaluation<Real>(series, state, here)(order);
  };
  const auto found = coefficients(f), wanted = coefficients(form);
  // Twenty sums of terms below 10^10 with 60 digits.
  for (std::size_t k = 0; k <= order; ++k) EXPECT_LT(relative_difference(found[k][2], wanted[k][2]), tolerance) << k;
}

TEST(SelectionSeries, KeepTheFormTakenAtTheStart) {
  using E = const Expression&;
  expect_series_of([](E x, E s) { return abs(s) * x; }, [](E x, E s) { return -s * x; });
  expect_series_of([](E x, E s) { return sign(s) * exp(x); }, [](E x, E) { return -exp(x); });
  expect_series_of([](E x, E s) { return max(x, s); }, [](E x, E) { return x; });
  expect_series_of([](E x, E s) { return min(x, s) / max(1, x); }, [](E, E s) { return s; });
  expect_series_of([](E x, E s) { return piecewise({{s < 0, sin(x) * s}}, sqrt(s)); }, [](E x, E s) { return sin(x) * s; });
  expect_series_of([](E x, E s) { return piecewise({{s >= 0, sqrt(s)}}, 5) + x; }, [](E x, E) { return 5 + x; });
  // A complete spline through points of a cubic is that cubic, but for slopes that are rounded to 30 digits.
  const std::vector<std::array<double, 2>> cubic{{0, 1}, {0.5, 1.125}, {1, 2}, {2, 9}};
  expect_series_of([&](E x, E) { return spline(x, cubic, "1", std::array<double, 2>{0, 12}); },
                   [](E x, E) { return 1 + pow(x, 3); }, 1e-27);
}

TEST(SelectionSeries, FollowTheRecurrenceOfTheAngle) {
  using E = const Expression&;
  // atan2(s, x) has the derivative (x s' - s x')/(x² + s²): compared as the rate of a further unknown would be, one
  // order lower, with the angle itself taken from the start.
  const WorkingDigits precision(60);
  const std::vector<SymbolPointer> state{make_symbol("x", "1", SymbolKind::velocity),
                                         make_symbol("s", "1", SymbolKind::velocity),
                                         make_symbol("w", "1", SymbolKind::velocity),
                                         make_symbol("a", "1", SymbolKind::velocity)};
  const auto series_of = [&](E angle) {
    Program program;
    const Expression x = state[0], s = state[1];
    const Expression rate = (x * x - s) / (x * x + s * s);  // s' = x, x' = 1
    const std::vector<Value> rates{program.number(Number(1)), program.symbol(state[0]), program.lower(angle),
                                   program.lower(rate)};
    const SeriesProgram series(program, rates);
    Evaluator<Real> here(program, [](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      if (symbol->name == "a") return atan2(rational(-2, 5), rational(3, 5));
      return symbol->name == "s" ? rational(-2, 5) : rational(3, 5);
    });
    return SeriesEvaluation<Real>(series, state, here)(20);
  };
  const auto found = series_of(atan2(Expression(state[1]), Expression(state[0]))), wanted = series_of(Expression(state[3]));
  for (std::size_t k = 0; k <= 20; ++k) EXPECT_LT(relative_difference(found[k][2], wanted[k][2]), 1e-45) << k;
}

}  // namespace
}  // namespace torsor::selections_test
