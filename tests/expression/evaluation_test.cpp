// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/expression/test_symbols.hpp"

namespace torsor::evaluation_test {
namespace {

using namespace testing_symbols;
using namespace literals;

TEST(Evaluator, ComputesEveryFunction) {
  Program program;
  const Expression x = make_symbol("x");
  const auto in_double = [](const SymbolPointer&) { return 0.6; };
  Evaluator<double> evaluate(program, in_double);
  const auto value = [&](const Expression& f) { return evaluate(program.lower(f)); };
  // The same calls of the same library: equal to the last bit.
  EXPECT_EQ(value(sin(x)), std::sin(0.6));
  EXPECT_EQ(value(cos(x)), std::cos(0.6));
  EXPECT_EQ(value(exp(x)), std::exp(0.6));
  EXPECT_EQ(value(log(x)), std::log(0.6));
  EXPECT_EQ(value(sqrt(x)), std::sqrt(0.6));
  EXPECT_EQ(value(1 / x), 1 / 0.6);
  EXPECT_EQ(value(x - 3), 0.6 - 3);
  EXPECT_EQ(value(3 - x), 3 - 0.6);
  EXPECT_EQ(value(-x), -0.6);
  EXPECT_EQ(value(0), 0.0);
}

TEST(Evaluator, RoundsConstantsOnceFromTheirExactValue) {
  Program program;
  const Value root = program.lower(sqrt(Expression(3)));
  Evaluator<double> fast(program, {});
  EXPECT_EQ(fast(root), std::sqrt(3.0));  // correctly rounded by IEEE 754
  const WorkingDigits precision(80);
  Evaluator<Real> exact(program, {});
  EXPECT_LT(abs(exact(root) * exact(root) - Real(3)).to_double(), 1e-78);
  EXPECT_LT(abs(exact(program.lower(0.1_r)) * Real(10) - Real(1)).to_double(), 1e-79);
}

TEST(Evaluator, AsksForEachSymbolOnceAndForgetsItWhenMoved) {
  Program program;
  const Expression x = make_symbol("x");
  const Value value = program.lower(sin(x) * cos(x) * (x + 1) + x * x);
  int asked = 0;
  Evaluator<double> evaluate(program, [&](const SymbolPointer&) { return ++asked, 2.0; });
  const double before = evaluate(value);
  evaluate(value);
  EXPECT_EQ(asked, 1);
  evaluate.move_to([](const SymbolPointer&) { return 3.0; });
  EXPECT_NE(evaluate(value), before);
  // A program that has grown since is no obstacle.
  EXPECT_EQ(evaluate(program.lower(x * 7)), 21.0);
}

TEST(Vanishes, RecognisesIdentitiesThatNoTermByTermComparisonSees) {
  Program program;
  const Expression x = make_symbol("x");
  const Expression y = make_symbol("y");
  const auto zero = [&](const Expression& f) { return vanishes(program.lower(f)); };
  EXPECT_TRUE(zero(sin(2 * x) - 2 * sin(x) * cos(x)));
  EXPECT_TRUE(zero((x + y) * (x - y) - (x * x - y * y)));
  EXPECT_TRUE(zero(exp(x + y) - exp(x) * exp(y)));
  EXPECT_TRUE(zero(x - x));
  EXPECT_TRUE(zero(pow(sin(0.3_r), 2) + pow(cos(0.3_r), 2) - 1));
}

TEST(Vanishes, IsNotFooledBySmallOrUndefinedValues) {
  Program program;
  const Expression x = make_symbol("x");
  const auto zero = [&](const Expression& f) { return vanishes(program.lower(f)); };
  EXPECT_FALSE(zero(sin(x) - x));
  EXPECT_FALSE(zero(x * Expression(Number(10).pow(-30))));
  EXPECT_FALSE(zero(Expression(Number(10).pow(-90))));
  EXPECT_FALSE(zero(sqrt(-x - 1)));  // not a number anywhere
}

TEST(Vanishes, LooksAtBothSignsOfWhatMoves) {
  Program program;
  const Expression x = TestCoordinate("x").q;
  const Expression length = make_symbol("length");
  EXPECT_FALSE(vanishes(program.lower(sqrt(x * x) - x)));
  EXPECT_FALSE(vanishes(program.lower(sqrt(x * x) + x)));
  EXPECT_TRUE(vanishes(program.lower(sqrt(x * x) * sqrt(x * x) - x * x)));
  EXPECT_TRUE(vanishes(program.lower(sqrt(length * length) - length)));  // parameters are taken for sizes
}

TEST(Vanishes, AnswersForManyValuesAtOnce) {
  Program program;
  const Expression x = make_symbol("x");
  const std::vector<Value> values{program.lower(sin(2 * x) - 2 * sin(x) * cos(x)), Value(), program.lower(x),
                                  program.lower(3), program.lower(exp(x) * exp(-x) - 1)};
  EXPECT_EQ(vanish(values), (std::vector<bool>{true, true, false, false, true}));
  EXPECT_EQ(vanish({}), std::vector<bool>{});
  EXPECT_EQ(vanish({Value()}), std::vector<bool>{true});
}

}  // namespace
}  // namespace torsor::evaluation_test
