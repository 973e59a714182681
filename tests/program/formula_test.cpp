// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/earliest_start.hpp"
#include "torsor/generator/program/formula.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/program/test_symbols.hpp"

namespace torsor::formula_test {
namespace {

using namespace testing_symbols;
using namespace literals;

/// Exact value at value number k = k + 2.
Number value_of(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::value_number:
      return Number(formula.value_number.value() + 2);
    case Formula::Kind::constant:
      return formula.number;
    case Formula::Kind::quotient:
      return value_of(formula.children[0]) / value_of(formula.children[1]);
    case Formula::Kind::product: {
      Number product(1);
      for (const Formula& child : formula.children) product *= value_of(child);
      return product;
    }
    case Formula::Kind::sum: {
      Number sum;
      for (std::size_t k = 0; k < formula.children.size(); ++k) {
        sum += formula.negative[k] ? -value_of(formula.children[k]) : value_of(formula.children[k]);
      }
      return sum;
    }
    case Formula::Kind::function:
      break;
  }
  ADD_FAILURE() << "a function inside a sum";
  return {};
}

Number value_of(const Polynomial& polynomial) {
  Number sum;
  for (const Term& term : polynomial.terms()) {
    Number value = term.coefficient;
    for (const Factor& factor : term.monomial) value *= Number(factor.value_number + 2).pow(factor.exponent);
    sum += value;
  }
  return sum;
}

TEST(Formula, OnlyRegroupsItsPolynomial) {
  std::mt19937 random(5);
  Program program;  // of five value numbers that are known at different times
  const Value x = program.lower(TestCoordinate("x").q), y = program.lower(TestCoordinate("y").q);
  program.sin(x);
  program.sqrt(y);
  ASSERT_EQ(program.size(), 5U);
  for (int trial = 0; trial < 300; ++trial) {
    Polynomial polynomial;
    const int terms = 1 + static_cast<int>(random() % 9U);
    for (int k = 0; k < terms; ++k) {
      Monomial monomial;
      for (ValueNumber value_number = 0; value_number < 5; ++value_number) {
        const int exponent = std::max(static_cast<int>(random() % 6U) - 2, -1);
        if (exponent != 0) monomial.push_back({value_number, exponent});
      }
      polynomial.add({monomial, Number::rational(static_cast<long>(random() % 9U) - 4, 3)});
    }
    ASSERT_EQ(value_of(factored(polynomial)), value_of(polynomial)) << trial;
    ASSERT_EQ(value_of(EarliestStarts(program).in_order(factored(polynomial))), value_of(polynomial)) << trial;
  }
}

class FormulaCount : public ::testing::Test {
 protected:
  OperationCount of(const Expression& expression) { return count(factored(program.lower(expression).polynomial())); }
  Program program;
  // Coordinates: what depends on parameters only is counted on another occasion.
  Expression a = TestCoordinate("a").q, b = TestCoordinate("b").q, c = TestCoordinate("c").q, d = TestCoordinate("d").q;
};

void expect_counts(const OperationCount& count, int additions, int multiplications, int divisions) {
  EXPECT_EQ(count.additions, additions);
  EXPECT_EQ(count.multiplications, multiplications);
  EXPECT_EQ(count.divisions, divisions);
  EXPECT_EQ(count.total(), additions + multiplications + divisions);
}

TEST_F(FormulaCount, IsThatOfTheFactoredText) {
  expect_counts(of(a * b + a * c), 1, 1, 0);              // a (b + c)
  expect_counts(of(a * b + a * c + a * d + d), 3, 1, 0);  // a (b + c + d) + d
  expect_counts(of(2 * a + 2 * b), 1, 1, 0);              // 2 (a + b)
  expect_counts(of(2 * a - 2 * b), 1, 1, 0);              // 2 (a - b)
  expect_counts(of(a * b + c * d), 1, 2, 0);
  expect_counts(of(a - b), 1, 0, 0);
}

TEST_F(FormulaCount, CountsAPowerAsItsMultiplicationsAndASignAsNothing) {
  expect_counts(of(pow(a, 3)), 0, 2, 0);
  expect_counts(of(-(a * b)), 0, 1, 0);
  expect_counts(of(-a - b), 1, 0, 0);
  expect_counts(of(a / b), 0, 0, 1);
  expect_counts(of(a / (b * c)), 0, 1, 1);
  expect_counts(of(pow(a, -2)), 0, 1, 1);
  expect_counts(of(a), 0, 0, 0);
  expect_counts(of(3), 0, 0, 0);
}

TEST_F(FormulaCount, CountsASineAndACosineOfOneAngleAsOnePairOfTwo) {
  const Value sine = program.lower(sin(a));
  const Value cosine = program.lower(cos(a));
  OperationCount total = count(program, {sine, cosine});
  EXPECT_EQ(total.sincos_pairs, 1);
  EXPECT_EQ(total.total(), 2);
  total = count(program, {sine});
  EXPECT_EQ(total.total(), 2);
  total = count(program, {sine, program.lower(cos(b))});
  EXPECT_EQ(total.total(), 4);
}

TEST_F(FormulaCount, CountsASharedDefinitionOnceAndADeadOneNever) {
  const Value shared = program.bind(program.lower(a * b + c));  // 1 addition, 1 multiplication
  program.bind(program.lower(a * b * c * d));                   // dead
  const Value first = shared * shared;                          // 1 multiplication
  const Value second = shared * program.lower(d);               // 1 multiplication
  const OperationCount total = count(program, {first, second});
  EXPECT_EQ(total.additions, 1);
  EXPECT_EQ(total.multiplications, 3);
}

TEST_F(FormulaCount, CountsOutputsThatAreEqualUpToSignOnce) {
  const Value product = program.lower(a * b);
  EXPECT_EQ(count(program, {product, -product, product}).total(), 1);
}

TEST_F(FormulaCount, CountsRootsAndOtherFunctionsOnceAndConstantsOfTheGenerationNever) {
  const OperationCount root = count(program, {program.lower(sqrt(a))});
  EXPECT_EQ(root.square_roots, 1);
  EXPECT_EQ(root.total(), 1);
  const OperationCount other = count(program, {program.lower(exp(a)), program.lower(log(a))});
  EXPECT_EQ(other.others, 2);
  EXPECT_EQ(count(program, {program.lower(sin(0.3_r))}).total(), 0);
  EXPECT_EQ(count(program, {program.lower(a * sin(0.3_r))}).total(), 1);
}

TEST_F(FormulaCount, SeparatesWhatIsDoneOnceForASetOfParameters) {
  const Expression m = make_symbol("m");
  const Expression l = make_symbol("l");
  const Value of_parameters = program.bind(program.lower(m * l + l));  // l (m + 1)
  const Value value = of_parameters * program.lower(a) * program.lower(b);
  expect_counts(count(program, {value}, Occasion::parameters), 1, 1, 0);
  expect_counts(count(program, {value}, Occasion::state), 0, 2, 0);
  expect_counts(count(program, {of_parameters * of_parameters}, Occasion::parameters), 1, 2, 0);
}

}  // namespace
}  // namespace torsor::formula_test
