// SPDX-License-Identifier: GPL-3.0-or-later
// Each function of the table.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "torsor/generator/expression/expression_derivative.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/series_evaluation.hpp"
#include "torsor/generator/verification/running_error.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::function_table_test {
namespace {

using namespace testing_symbols;

std::vector<Function> analytic_of_one() {
  std::vector<Function> found;
  for (const FunctionTraits& each : functions()) {
    if (each.arity == 1 && !each.selects) found.push_back(each.function);
  }
  return found;
}

/// Of values and of formulas, against central differences of 50 digits with a step of 1e-15: their error is of the
/// order of the step squared times the third derivative, below 1e-26 for slopes of the size of one.
TEST(FunctionTable, HasTheSlopeOfEachFunction) {
  const SymbolPointer x = make_symbol("x");
  const Real h = Real(Number(10).pow(-15), 50);
  for (const Function function : analytic_of_one()) {
    Program program;
    const auto value = [&](const Value& of, const Real& at_x) {
      return Evaluator<Real>(program, at({{"x", at_x}}))(of);
    };
    const Expression formula = apply(function, Expression(x) * x);
    const Value f = program.lower(formula);
    for (const Value& slope :
         {partial_derivation(program, x)(f), gradient(f, {x})[0], program.lower(partial_derivative(formula, x))}) {
      for (const Real& here : {rational(4, 7), rational(7, 5)}) {
        const Real wanted = (value(f, here + h) - value(f, here - h)) / (Real(2) * h);
        EXPECT_LT(relative_difference(value(slope, here), wanted), 1e-26) << to_string(function);
      }
    }
  }
}

/// As a displacement of a joint is differentiated: (x y' - y x')/(x² + y²) of atan2(y, x), here y = 2 q, x = 1 + q.
TEST(FunctionTable, HasTheSlopesOfTheAngle) {
  const SymbolPointer symbol = make_symbol("q");
  const Expression q = symbol;
  Program program;
  const Value found = program.lower(partial_derivative(atan2(2 * q, 1 + q), symbol));
  const Value wanted = program.lower(2 / (pow(1 + q, 2) + 4 * q * q));
  const auto value = [&](const Value& of) { return Evaluator<Real>(program, at({{"q", rational(3, 7)}}))(of); };
  EXPECT_LT(relative_difference(value(found), value(wanted)), 1e-48);
}

/// w' = f(x) with x' = s, s' = x: coefficient k + 1 of w is the k-th derivative of f(x) along the motion over (k + 1)!.
TEST(FunctionTable, HasTheTaylorSeriesOfEachFunction) {
  const WorkingDigits precision(60);
  const std::vector<SymbolPointer> state{make_symbol("x", "1", SymbolKind::velocity),
                                         make_symbol("s", "1", SymbolKind::velocity),
                                         make_symbol("w", "1", SymbolKind::velocity)};
  const auto start = at({{"x", rational(3, 5)}, {"s", rational(-2, 5)}, {"w", Real(0)}});
  for (const Function function : analytic_of_one()) {
    Program program;
    const Value x = program.symbol(state[0]), s = program.symbol(state[1]);
    Value rate = program.apply(function, x);
    Evaluator<Real> here(program, start);
    const SeriesProgram series(program, {s, x, rate});
    const auto found = SeriesEvaluation<Real>(series, state, here)(8);
    Derivation along(program, [&](const SymbolPointer& symbol) { return symbol == state[0] ? s : x; }, Unit());
    Real factorial(1);
    for (int k = 1; k <= 8; ++k) {
      factorial *= Real(k);
      // Sums of at most some hundred terms below 10^8 with 60 digits.
      const Real derivative = Evaluator<Real>(program, start)(rate);
      EXPECT_LT(relative_difference(found[static_cast<std::size_t>(k)][2] * factorial, derivative), 1e-48)
          << to_string(function) << ' ' << k;
      rate = program.bind(along(rate));
    }
  }
}

template <class Float>
void expect_bounded(Function function) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(0.01, 6), share(-1, 1);
  const bool any_sign = function != Function::sqrt && function != Function::log;
  for (int k = 0; k < 400; ++k) {
    const auto x = static_cast<Float>(any_sign && k % 2 == 0 ? -number(random) : number(random));
    const double bound = k % 4 == 0 ? 0 : std::ldexp(std::abs(static_cast<double>(x)), -(k % 50) - 2);
    const auto found = value_of_call(function, std::vector<Running<Float>>{{x, bound}});
    const Real meant = Real::from_double(static_cast<double>(x), 60) + Real::from_double(bound * share(random), 60);
    const Real exact = value_of_call(function, std::vector<Real>{meant});
    const Real error = abs(Real::from_double(static_cast<double>(found.value()), 60) - exact);
    EXPECT_LE(error, Real::from_double(found.bound(), 60)) << to_string(function) << ' ' << k;
    // Not by much more than the interval is wide: no slope here exceeds exp(7.5), no value of these exp(6).
    EXPECT_LE(found.bound(), 2000 * bound + 500 * 32 * static_cast<double>(std::numeric_limits<Float>::epsilon()));
  }
}

TEST(FunctionTable, HasABoundOfTheErrorOfEachFunction) {
  for (const Function function : analytic_of_one()) {
    expect_bounded<double>(function);
    expect_bounded<float>(function);
  }
}

}  // namespace
}  // namespace torsor::function_table_test
