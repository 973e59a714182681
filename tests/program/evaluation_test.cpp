// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/program/test_symbols.hpp"

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

TEST(Evaluator, KnowsWhatWasMadeReadyAtEveryState) {
  Program program;
  const Expression x = make_symbol("x"), y = make_symbol("y");
  std::vector<Value> values;
  const std::vector<Expression> formulas{x, -x, Expression(0), Expression(-3), x + y, -sin(x), x * y - 2};
  for (const Expression& each : formulas) values.push_back(program.lower(each));
  values.push_back(program.bind(program.lower(x - y)));
  Evaluator<double> evaluate(program, [](const SymbolPointer&) { return 0.5; });
  std::vector<Evaluator<double>::Ready> ready;
  for (const Value& value : values) ready.push_back(evaluate.ready(value));
  for (const double at : {0.5, -1.25}) {
    evaluate.move_to([at](const SymbolPointer& symbol) { return symbol->name == "x" ? at : 7 * at; });
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(evaluate(ready[i]), evaluate(values[i])) << i;
    EXPECT_EQ(evaluate(ready[4]), 8 * at);
    EXPECT_EQ(evaluate(program.lower(x * y * 11)), 77 * at * at);  // the program has grown
  }
  evaluate.fix(*values[7].value_number(), 4);
  evaluate.move_to([](const SymbolPointer&) { return 1.0; });
  EXPECT_EQ(evaluate(ready[7]), 4);
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

}  // namespace
}  // namespace torsor::evaluation_test
