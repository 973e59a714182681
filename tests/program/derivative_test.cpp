// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/program/test_symbols.hpp"

namespace torsor::derivative_test {
namespace {

using namespace testing_symbols;
using namespace literals;

class DerivativeTest : public ::testing::Test {
 protected:
  SymbolPointer sx = make_symbol("x"), sy = make_symbol("y");
  Expression x = sx, y = sy;
  Program program;

  /// f' − expected, which must vanish.
  Value gap(const Expression& f, const Expression& expected) {
    const Value derivative = partial_derivation(program, sx)(program.lower(f));
    return derivative - program.lower(expected);
  }
};

using PartialDerivative = DerivativeTest;

TEST_F(PartialDerivative, FollowsEachRule) {
  EXPECT_TRUE(gap(x, 1).is_zero());
  EXPECT_TRUE(gap(y, 0).is_zero());
  EXPECT_TRUE(gap(pow(x, 5), 5 * pow(x, 4)).is_zero());
  EXPECT_TRUE(gap(1 / x, -pow(x, -2)).is_zero());
  EXPECT_TRUE(gap(x * y * y, y * y).is_zero());
  EXPECT_TRUE(gap(y / x, -y * pow(x, -2)).is_zero());
  EXPECT_TRUE(gap(sin(x), cos(x)).is_zero());
  EXPECT_TRUE(gap(cos(x), -sin(x)).is_zero());
  EXPECT_TRUE(gap(exp(x), exp(x)).is_zero());
  EXPECT_TRUE(identically_zero(gap(log(x), 1 / x)));
  EXPECT_TRUE(identically_zero(gap(sqrt(x), 1 / (2 * sqrt(x)))));
  EXPECT_TRUE(identically_zero(gap(sin(x * y), y * cos(x * y))));
  EXPECT_TRUE(identically_zero(gap(exp(2 * x + y), 2 * exp(2 * x + y))));
  EXPECT_TRUE(identically_zero(gap(pow(x + y, 3), 3 * pow(x + y, 2))));
  EXPECT_TRUE(identically_zero(gap(tan(x), 1 + pow(tan(x), 2))));
  EXPECT_TRUE(identically_zero(gap(sqrt(1 + x * x), x / sqrt(1 + x * x))));
  EXPECT_TRUE(identically_zero(gap(sin(cos(x)), -cos(cos(x)) * sin(x))));
}

TEST_F(PartialDerivative, HasTheUnitOfTheQuotient) {
  const SymbolPointer length = make_symbol("length", "m");
  const Value area = program.lower(pow(Expression(length), 2));
  EXPECT_EQ(partial_derivation(program, length)(area).unit(), units::metre);
  EXPECT_EQ(gradient(area, {length})[0].unit(), units::metre);
}

/// sin(x/L) with L = 1 m folded leaves the symbol x, which has a unit, as the argument of a function.
TEST_F(PartialDerivative, KeepsUnitsRightWhenAFoldedUnitLengthDisappears) {
  const TestCoordinate position("position", units::metre);
  const Expression p = position.q;
  const Expression unit_length = Expression::quantity("1", "m");
  const Expression f = p + unit_length * sin(p / unit_length) + unit_length * exp(p / unit_length);
  const Value value = program.lower(f);
  const Expression slope = 1 + cos(p / unit_length) + exp(p / unit_length);
  EXPECT_TRUE(identically_zero(partial_derivation(program, position.q)(value) - program.lower(slope)));
  EXPECT_TRUE(identically_zero(gradient(value, {position.q})[0] - program.lower(slope)));
  const Value speed = time_derivative(value);
  EXPECT_EQ(speed.unit(), units::metre_per_second);
  EXPECT_TRUE(identically_zero(speed - program.lower(slope * Expression(position.v))));
  Substitution nothing(program, [](const SymbolPointer&) -> std::optional<Value> { return std::nullopt; });
  EXPECT_TRUE(identically_zero(nothing(value) - value));
}

/// 3 θ is first met as a torque, then as an angle: one definition serves both and must not hand on the unit N m.
TEST_F(PartialDerivative, KeepsUnitsRightWhenQuantitiesOfTwoUnitsShareADefinition) {
  const TestCoordinate theta("theta");
  const Expression angle = theta.q;
  program.bind(program.lower(Expression::quantity("3", "N m") * angle));
  const Value value = program.lower(angle + sin(3 * angle));
  const Value expected = program.lower(Expression(theta.v) + 3 * cos(3 * angle) * Expression(theta.v));
  EXPECT_TRUE(identically_zero(time_derivative(value) - expected));
  EXPECT_TRUE(identically_zero(gradient(value, {theta.q})[0] - program.lower(1 + 3 * cos(3 * angle))));
  Substitution nothing(program, [](const SymbolPointer&) -> std::optional<Value> { return std::nullopt; });
  EXPECT_TRUE(identically_zero(nothing(value) - value));
}

TEST_F(PartialDerivative, GoesAroundConstantsWithoutExactValue) {
  const Value value = program.lower(x * sin(0.3_r) + y * cos(0.3_r) * sqrt(Expression(5)) + exp(0.2_r));
  const std::vector<Value> both = gradient(value, {sx, sy});
  EXPECT_TRUE(identically_zero(both[0] - program.lower(sin(0.3_r))));
  EXPECT_TRUE(identically_zero(both[1] - program.lower(cos(0.3_r) * sqrt(Expression(5)))));
  EXPECT_TRUE(gap(x * sin(0.3_r), sin(0.3_r)).is_zero());
}

/// In double a quotient by e^300 has derivatives, though the square of e^300 is beyond what a double holds two and a half times.
TEST_F(PartialDerivative, DividesByNoPowersOfSumsOfExponentials) {
  const auto check = [&](const Expression& f, double at, double first, double second, double third) {
    const Value once = partial_derivation(program, sx)(program.lower(f)), backward = gradient(once, {sx})[0];
    const Value twice = partial_derivation(program, sx)(once), thrice = partial_derivation(program, sx)(twice);
    Evaluator<double> evaluate(program, [at](const SymbolPointer&) { return at; });
    EXPECT_NEAR(evaluate(once), first, 1e-200 + 1e-14 * std::abs(first)) << at;
    EXPECT_NEAR(evaluate(twice), second, 1e-200 + 1e-14 * std::abs(second)) << at;
    EXPECT_NEAR(evaluate(backward), second, 1e-200 + 1e-14 * std::abs(second)) << at;
    EXPECT_NEAR(evaluate(thrice), third, 1e-200 + 1e-14 * std::abs(third)) << at;
  };
  for (const double at : {-300.0, -2.0, 1.0, 250.0, 300.0, 600.0}) {
    const double p = 1 / (1 + std::exp(at)), s = std::exp(at) / (1 + std::exp(at)) * p;  // p' = -s, s' = s (2 p - 1)
    const double rate = 2 * p - 1;
    check(1 / (1 + exp(x)), at, -s, -s * rate, -s * (rate * rate - 2 * s));
  }
  // tanh: what is left of its rates at 250 is below 1e-200.
  check((exp(x) - exp(-x)) / (exp(x) + exp(-x)), 250, 0, 0, 0);
}

/// A random formula of the symbols, regular on [1/2, 2]: arguments of roots, logarithms and quotients stay positive.
Expression random_formula(std::mt19937& random, const std::vector<Expression>& symbols, int depth) {
  if (depth == 0) {
    if (random() % 4U == 0) return Expression(Number::rational(static_cast<long>(random() % 9U) + 1, 4));
    return symbols[random() % symbols.size()];
  }
  const auto sub = [&] { return random_formula(random, symbols, depth - 1); };
  const Expression a = sub();
  switch (random() % 9U) {
    case 0:
      return a + sub();
    case 1:
      return a - sub();
    case 2:
    case 3:
      return a * sub();
    case 4:
      return a / (2 + pow(sin(sub()), 2));
    case 5:
      return sin(a);
    case 6:
      return cos(a);
    case 7:
      return sqrt(1 + a * a);
    default:
      return random() % 2U == 0 ? exp(sin(a)) : log(2 + cos(a));
  }
}

TEST(Derivation, AgreesForwardAndBackwardAndWithFiniteDifferencesOnRandomPrograms) {
  const WorkingDigits precision(60);
  std::mt19937 random(20);
  // Central differences: the truncation h² f'''/6 ~ 1e-40 and the rounding 1e-60 / h = 1e-40.
  const Real h = power_of_ten(-20);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<SymbolPointer> symbols;
    std::vector<Expression> formulas;
    Point point;
    for (int k = 0; k < 4; ++k) {
      const std::string name = "s" + std::to_string(k);
      symbols.push_back(make_symbol(name));
      formulas.emplace_back(symbols.back());
      point[name] = rational(static_cast<long>(random() % 1500U) + 500, 1000);
    }
    Program program;
    const Value value = program.lower(random_formula(random, formulas, 5));
    const std::vector<Value> backward = gradient(value, symbols);
    for (std::size_t k = 0; k < symbols.size(); ++k) {
      const Value forward = partial_derivation(program, symbols[k])(value);
      Evaluator<Real> evaluate(program, at(point));
      const Real slope = evaluate(forward);
      ASSERT_LT(relative_difference(evaluate(backward[k]), slope), 1e-52) << trial;  // rounding of ~10² operations
      Point above = point;
      Point below = point;
      above[symbols[k]->name] += h;
      below[symbols[k]->name] -= h;
      Evaluator<Real> at_above(program, at(above));
      Evaluator<Real> at_below(program, at(below));
      const Real difference = (at_above(value) - at_below(value)) / (h + h);
      // Third derivatives of nested formulas stay below 1e8 at this depth.
      ASSERT_LT(relative_difference(difference, slope), 1e-30) << trial;
    }
  }
}

TEST(Derivation, CostsNoMoreThanAFewTimesTheFunction) {
  // x_{k+1} = sin(x_k) x_k: as a tree its derivative would have 2^20 leaves.
  Program program;
  const SymbolPointer symbol = make_symbol("x");
  Value x = program.lower(symbol);
  for (int k = 0; k < 20; ++k) x = program.bind(program.sin(x) * x);
  const std::size_t size = program.size();
  gradient(x, {symbol});
  EXPECT_LT(program.size(), 6 * size);
  const std::size_t after = program.size();
  partial_derivation(program, symbol)(x);
  EXPECT_LT(program.size() - after, 5 * size);
}

TEST(TimeDerivative, LeadsFromPositionToVelocityToAcceleration) {
  Program program;
  const TestCoordinate q("q");
  const Expression position = q.q;
  const Expression velocity = q.v;
  const Expression acceleration = q.a;
  const Value sine = program.lower(sin(position));
  const Value once = time_derivative(sine);
  EXPECT_TRUE(identically_zero(once - program.lower(cos(position) * velocity)));
  const Value twice = time_derivative(once);
  EXPECT_TRUE(identically_zero(twice - program.lower(cos(position) * acceleration - sin(position) * pow(velocity, 2))));
  EXPECT_EQ(twice.unit(), units::second.pow(-2));
}

TEST(TimeDerivative, FollowsFormulasOfTimeAndPosition) {
  const WorkingDigits precision(60);
  Program program;
  const TestCoordinate q("q");
  const SymbolPointer t = make_symbol("t", "s", SymbolKind::time);
  const Expression omega = Expression::quantity("3", "rad/s");
  const Expression f = sin(omega * Expression(t) + Expression(q.q)) * exp(Expression(q.q) / 5);
  const Value rate_value = program.lower(rate(f));
  const Value second = time_derivative(rate_value);
  // Along q(t) = t²/3 + t/7: finite differences of f itself know nothing of the chain rule.
  const auto point = [](const Real& time) {
    return Point{{"t", time},
                 {"q", time * time * rational(1, 3) + time * rational(1, 7)},
                 {"q'", time * rational(2, 3) + rational(1, 7)},
                 {"q''", rational(2, 3)}};
  };
  const Real h = power_of_ten(-15);
  const Real now = rational(4, 5);
  const auto value_at = [&](const Value& value, const Real& time) {
    Evaluator<Real> evaluate(program, at(point(time)));
    return evaluate(value);
  };
  const Value value = program.lower(f);
  const Real first = (value_at(value, now + h) - value_at(value, now - h)) / (h + h);
  // Truncation h² f'''/6 with derivatives below 1e3: 1e-27.
  EXPECT_LT(relative_difference(value_at(rate_value, now), first), 1e-26);
  const Real curvature =
      (value_at(value, now + h) - Real(2) * value_at(value, now) + value_at(value, now - h)) / (h * h);
  EXPECT_LT(relative_difference(value_at(second, now), curvature), 1e-25);
}

TEST(TimeDerivative, IsZeroForParametersAndUnknownForAccelerations) {
  Program program;
  const TestCoordinate q("q");
  EXPECT_TRUE(time_derivative(program.lower(Expression(make_symbol("mass", "kg")) * 3)).is_zero());
  EXPECT_TRUE(time_derivative(program.number(Number(3))).is_zero());
  EXPECT_EQ(error_of<SceneError>([&] { time_derivative(program.lower(Expression(q.a))); }),
            "'q''' has no known time derivative: only time, parameters, coordinates and their velocities may stand "
            "under d/dt");
}

using SubstitutionTest = DerivativeTest;

TEST_F(SubstitutionTest, RebuildsWhatDependsOnTheSymbol) {
  const auto f = [](const Expression& a, const Expression& b) { return sin(a * b + 1) * (a - b) / sqrt(1 + a * a); };
  const Value original = program.lower(f(x, y));
  const Value replacement = program.lower(pow(y, 2) + 1);
  Substitution substitute(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol == sx) return replacement;
    return std::nullopt;
  });
  EXPECT_TRUE(identically_zero(substitute(original) - program.lower(f(pow(y, 2) + 1, y))));
}

TEST_F(SubstitutionTest, FoldsWhatBecomesConstant) {
  const Value original = program.lower(cos(x) * y + sin(x) * pow(y, 3) + x);
  Substitution at_zero(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol == sx) return program.number(Number());
    return std::nullopt;
  });
  EXPECT_TRUE(identically_zero(at_zero(original) - program.lower(y)));
}

TEST_F(SubstitutionTest, LeavesTheRestAsItIs) {
  const Value original = program.bind(program.lower(sin(y) * (y + 1)));
  Substitution substitute(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol == sx) return program.number(Number(3));
    return std::nullopt;
  });
  EXPECT_TRUE(identically_zero(substitute(original) - original));
}

/// x/√(x² + ε²) and its like, whose slopes are what ε leaves: by the product rule a difference of nearly equal numbers.
class SmoothedQuotient : public ::testing::Test {
 protected:
  TestCoordinate x{"x"}, y{"y"};
  SymbolPointer epsilon = make_symbol("epsilon");
  Program program;

  /// As computed in double, beside sixty digits of the same: relative.
  double error_of_double(const Value& value) {
    const WorkingDigits precision(60);
    const Real e = rational(1, 1000000), a = rational(13, 10), b = rational(1, 3000);
    Evaluator<Real> exact(program, at({{"x", a}, {"y", b}, {"epsilon", e}}));
    Evaluator<double> rounded(program, [&](const SymbolPointer& symbol) {
      return (symbol == x.q ? a : symbol == y.q ? b : e).to_double();
    });
    const Real right = exact(value);
    return std::abs(rounded(value) / right.to_double() - 1.0);
  }
  void expect_digits_of_slopes(const Expression& f) {
    const Value value = program.lower(f);
    EXPECT_LT(error_of_double(value), 1e-15);
    Derivation by_x = partial_derivation(program, x.q);
    const Value slope = by_x(value);
    EXPECT_LT(error_of_double(slope), 1e-14) << f.to_string();
    EXPECT_LT(error_of_double(gradient(value, {x.q})[0]), 1e-14) << f.to_string();
    EXPECT_LT(error_of_double(by_x(slope)), 1e-14) << f.to_string();
    EXPECT_LT(error_of_double(partial_derivation(program, epsilon)(value)), 1e-14) << f.to_string();
  }
};

TEST_F(SmoothedQuotient, HasSlopesWithAllTheirDigits) {
  const Expression X = x.q, e = epsilon;
  expect_digits_of_slopes(X / sqrt(pow(X, 2) + pow(e, 2)));
  expect_digits_of_slopes(3 * X / sqrt(4 * pow(X, 2) + pow(e, 2)));
  expect_digits_of_slopes(exp(e) * X / sqrt(pow(X, 2) + pow(e, 2)));
}

TEST_F(SmoothedQuotient, HasTheSlopesOfItsFormula) {
  const Expression X = x.q, Y = y.q, e = epsilon, s = sqrt(pow(X, 2) + pow(Y + 2 * X, 2) + pow(e, 2));
  const auto slope_of = [&](const Expression& f) { return partial_derivation(program, x.q)(program.lower(f)); };
  const Expression half = X + 2 * (Y + 2 * X);  // (s²)'/2
  EXPECT_TRUE(identically_zero(slope_of(X / s) - program.lower(1 / s - X * half / pow(s, 3))));
  EXPECT_TRUE(identically_zero(slope_of(Y / s) - program.lower(-Y * half / pow(s, 3))));
  EXPECT_TRUE(identically_zero(slope_of(X * X * Y / s) - program.lower(2 * X * Y / s - X * X * Y * half / pow(s, 3))));
  EXPECT_TRUE(identically_zero(slope_of((Y + 2 * X) / s) - program.lower(2 / s - (Y + 2 * X) * half / pow(s, 3))));
  EXPECT_TRUE(identically_zero(slope_of(X / pow(s, 2)) - program.lower(1 / pow(s, 2) - 2 * X * half / pow(s, 4))));
  EXPECT_TRUE(identically_zero(gradient(program.lower(X * Y / s), {x.q})[0] -
                               program.lower(Y / s - X * Y * half / pow(s, 3))));
  EXPECT_EQ(slope_of(X / s).unit(), Unit());
}

}  // namespace
}  // namespace torsor::derivative_test
