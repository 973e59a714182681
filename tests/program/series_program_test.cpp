// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/series_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/program/series_evaluation.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::series_program_test {
namespace {

using namespace testing_symbols;

SymbolPointer moving(const std::string& name) { return make_symbol(name, "1", SymbolKind::velocity); }

/// Coefficients of w with w' = f(x), x' = 1, x(0) = 3/5, so that (k + 1) w_(k+1) = f⁽ᵏ⁾(3/5)/k!.
std::vector<Real> coefficients_of(const std::function<Expression(const Expression&)>& f, int order) {
  Program program;
  const std::vector<SymbolPointer> state{moving("x"), moving("w")};
  const Value one = program.number(Number(1));
  const Value rate = program.lower(f(Expression(state[0])));
  const SeriesProgram series(program, {one, rate});
  Evaluator<Real> here(program, [](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::pi ? Real::pi() : rational(3, 5);
  });
  const auto y = SeriesEvaluation<Real>(series, state, here)(order + 1);
  std::vector<Real> result;
  for (int k = 0; k <= order; ++k) result.push_back(Real(k + 1) * y[static_cast<std::size_t>(k + 1)][1]);
  return result;
}

/// Coefficient k of f at 3/5 in closed form.
void expect_series(const std::function<Expression(const Expression&)>& f, const std::function<Real(int)>& closed) {
  const WorkingDigits precision(60);
  constexpr int order = 30;
  const std::vector<Real> found = coefficients_of(f, order);
  // Thirty sums of terms not larger than (5/3)^30 = 4e6, with 60 digits.
  for (int k = 0; k <= order; ++k) {
    EXPECT_LT(relative_difference(found[static_cast<std::size_t>(k)], closed(k)), 1e-50) << "order " << k;
  }
}

Real factorial(int k) { return k < 2 ? Real(1) : Real(k) * factorial(k - 1); }

Real of_circle(int k) {  // sin at x + k pi/2
  const Real x = rational(3, 5);
  const Real value = k % 2 == 0 ? sin(x) : cos(x);
  return k % 4 < 2 ? value : -value;
}

TEST(SeriesProgram, FollowsTheRecurrenceOfEveryFunction) {
  using E = Expression;
  const Real x = []() {
    const WorkingDigits precision(60);
    return rational(3, 5);
  }();
  expect_series([](const E& e) { return sin(e); }, [](int k) { return of_circle(k) / factorial(k); });
  expect_series([](const E& e) { return cos(e); }, [](int k) { return of_circle(k + 1) / factorial(k); });
  expect_series([](const E& e) { return exp(e); }, [&](int k) { return exp(x) / factorial(k); });
  expect_series([](const E& e) { return 1 / e; }, [&](int k) { return Real(k % 2 == 0 ? 1 : -1) / pow(x, k + 1); });
  expect_series([](const E& e) { return 3 / (e * e); },
                [&](int k) { return Real(k % 2 == 0 ? 3 : -3) * Real(k + 1) / pow(x, k + 2); });
  expect_series([](const E& e) { return log(e); },
                [&](int k) { return k == 0 ? log(x) : Real(k % 2 == 1 ? 1 : -1) / (Real(k) * pow(x, k)); });
  expect_series([](const E& e) { return sqrt(e); },
                [&](int k) {
                  Real binomial = Real(1);
                  for (int i = 0; i < k; ++i) binomial = binomial * (rational(1, 2) - Real(i)) / Real(i + 1);
                  return binomial * sqrt(x) / pow(x, k);
                });
  expect_series(
      [](const E& e) { return pow(e, 5) - 2 * e; },
      [&](int k) {
        Real binomial = Real(1);
        for (int i = 0; i < k; ++i) binomial = binomial * Real(5 - i) / Real(i + 1);
        return k > 5 ? Real(0) : binomial * pow(x, 5 - k) - (k == 0 ? Real(2) * x : k == 1 ? Real(2) : Real(0));
      });
}

// (exp o sin)' = cos · exp o sin, and a quotient, by a check that knows no recurrence: f = u/v gives u = f v.
TEST(SeriesProgram, ComposesFunctions) {
  const WorkingDigits precision(60);
  const auto quotient = coefficients_of([](const Expression& e) { return exp(sin(e)) / (2 + cos(e)); }, 20);
  const auto dividend = coefficients_of([](const Expression& e) { return exp(sin(e)); }, 20);
  const auto divisor = coefficients_of([](const Expression& e) { return 2 + cos(e); }, 20);
  for (std::size_t k = 0; k <= 20; ++k) {
    Real sum = Real(0);
    for (std::size_t i = 0; i <= k; ++i) sum += quotient[i] * divisor[k - i];
    EXPECT_LT(relative_difference(sum, dividend[k]), 1e-55) << k;
  }
}

int nonlinear(const std::vector<Expression>& rates) {
  Program program;
  std::vector<Value> values;
  for (const Expression& rate : rates) values.push_back(program.lower(rate));
  return SeriesProgram(program, values).nonlinear_count();
}

TEST(SeriesProgram, TakesFewConvolutions) {
  const Expression x = moving("x"), y = moving("y"), z = moving("z"), u = make_symbol("u", "1", SymbolKind::input);
  const Expression p = make_symbol("p"), q = make_symbol("q");
  EXPECT_EQ(nonlinear({2 * x + p * y + u * z + p * q * u}), 0);
  EXPECT_EQ(nonlinear({x * y + p * x * z + 3 * x * x}), 1);         // x (y + p z + 3 x)
  EXPECT_EQ(nonlinear({x / z + y / z - 7 * x * p / (2 * z)}), 1);   // one quotient
  EXPECT_EQ(nonlinear({x * y, 2 * p * x * y + z, -x * y / q}), 1);  // made once
  EXPECT_EQ(nonlinear({sin(x) + cos(x)}), 2);
  EXPECT_EQ(nonlinear({sin(p) * x + sqrt(u) * y}), 0);  // constant functions
  EXPECT_EQ(nonlinear({pow(x, 4)}), 2);
  EXPECT_EQ(nonlinear({x * y + z * y + x * u + z * u}), 1);  // (x + z) y, or x + z taken out
}

TEST(SeriesProgram, KnowsSquaresOfSinesAndWhatCancelsWithThem) {
  const Expression x = moving("x"), y = moving("y"), z = moving("z"), p = make_symbol("p");
  const Expression s = sin(x), c = cos(x);                       // take two convolutions, if used
  EXPECT_EQ(nonlinear({y * (p * s) * s + y * c * (p * c)}), 0);  // p y
  EXPECT_EQ(nonlinear({p * s * s + 3 * c * c}), 3);              // p + (3 - p) cos²
  const Expression divisor = 2 + c * c;
  EXPECT_EQ(nonlinear({1 + s * s / divisor}), 4);                        // 3 / (2 + cos²)
  EXPECT_EQ(nonlinear({y / (1 + s * s / divisor)}), 4);                  // y (2 + cos²) / 3
  EXPECT_EQ(nonlinear({(z + y / divisor) / (1 + s * s / divisor)}), 4);  // (z (2 + cos²) + y) / 3
  EXPECT_EQ(nonlinear({z + y / divisor, (z + y / divisor) * x}), 5);     // used twice: made once
}

TEST(SeriesProgram, IsTheSameSeriesWhereDivisorsCancel) {
  const auto of = [](const Expression& x) {
    const Expression s = sin(x), c = cos(x), divisor = 2 + c * c;
    return (exp(x) + x * s / divisor) / (1 + s * s / divisor) + s * s * x + 3 * c * c * x;
  };
  // By another derivation: 1 + s²/d = 3/d multiplied out by hand, with double angles in the place of squares.
  const auto by_hand = [](const Expression& x) {
    const Expression divisor = (5 + cos(2 * x)) / 2;
    return (exp(x) * divisor + x * sin(x)) / 3 + x * (2 + cos(2 * x));
  };
  const WorkingDigits precision(60);
  const std::vector<Real> found = coefficients_of(of, 30), expected = coefficients_of(by_hand, 30);
  // As in expect_series.
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_LT(relative_difference(found[k], expected[k]), 1e-50) << k;
}

}  // namespace
}  // namespace torsor::series_program_test
