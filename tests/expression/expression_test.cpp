// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/expression.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/expression/expression_node.hpp"
#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/program/program.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::expression_test {
namespace {

using namespace testing_symbols;
using namespace literals;

Number number_of(const Expression& expression) { return std::get<Number>(expression.node().content); }

TEST(Expression, ReadsADoubleAsItsShortestDecimal) {
  EXPECT_EQ(number_of(0.1), Number::rational(1, 10));
  EXPECT_EQ(number_of(-2.5e-3), Number::rational(-25, 10000));
  EXPECT_EQ(number_of(1.0 / 3.0), Number::rational(3333333333333333, 10000000000000000));
}

TEST(Expression, ReadsALiteralExactly) {
  EXPECT_EQ(number_of(9.81_r), Number::rational(981, 100));
  EXPECT_EQ(number_of(0.1000000000000000000000001_r) - Number::rational(1, 10), Number(10).pow(-25));
}

TEST(Expression, RefusesASumOfDifferentUnitsAndNamesBothTerms) {
  const Expression mass = make_symbol("mass", "kg");
  const Expression length = make_symbol("length", "m");
  EXPECT_EQ(error_of<UnitError>([&] { mass + length; }),
            "cannot add mass [kg] and length [m]: both terms of a sum need the same unit");
  EXPECT_EQ(error_of<UnitError>([&] { length - mass* length; }),
            "cannot add length [m] and mass*length [kg m]: both terms of a sum need the same unit");
  EXPECT_EQ(error_of<UnitError>([&] { length + 1; }),
            "cannot add length [m] and 1 [1]: both terms of a sum need the same unit");
}

TEST(Expression, RefusesAFunctionOfAQuantityWithAUnitAndNamesIt) {
  const Expression length = make_symbol("length", "m");
  for (const Function function : {Function::sin, Function::cos, Function::exp, Function::log}) {
    const std::string text = error_of<UnitError>([&] { apply(function, 2 * length); });
    EXPECT_EQ(text, "the argument of " + std::string(to_string(function)) +
                        "(2*length) has the unit m and must be dimensionless: divide it by a quantity of that unit");
  }
  EXPECT_EQ(error_of([&] { sin(length / length); }), "no error");
}

TEST(Expression, LetsZeroFitAnyUnit) {
  const Expression length = make_symbol("length", "m");
  EXPECT_EQ((length + 0).unit(), units::metre);
  EXPECT_EQ((0 + length).unit(), units::metre);
  EXPECT_EQ((0 - length).unit(), units::metre);
  EXPECT_EQ(error_of([&] { sin(Expression::quantity("0", "m")); }), "no error");
}

TEST(Expression, CarriesUnitsThroughProductsPowersRootsAndRates) {
  const Expression mass = make_symbol("mass", "kg");
  const Expression x = TestCoordinate("x", units::metre).q;
  EXPECT_EQ((mass * pow(rate(x), 2)).unit(), units::joule);
  EXPECT_EQ((mass * rate(rate(x))).unit(), units::newton);
  EXPECT_EQ(sqrt(mass * x / mass / x).unit(), units::one);
  EXPECT_EQ(sqrt(x * x).unit(), units::metre);
  EXPECT_EQ((1 / x).unit(), units::metre.pow(-1));
  EXPECT_EQ(tan(x / x).unit(), units::one);
  EXPECT_THROW(sqrt(sqrt(x)), UnitError);  // a quarter of an exponent has no place
}

TEST(Expression, RefusesToDivideByTheLiteralZero) {
  EXPECT_THROW(Expression(1) / Expression(0), Error);
  EXPECT_THROW(pow(Expression(0), -2), Error);
}

TEST(Expression, OfManyTermsIsNoDeepTree) {
  const SymbolPointer x = make_symbol("x");
  constexpr int terms = 200'000;
  for (const bool before : {false, true}) {
    Expression sum = x;
    for (int i = 1; i < terms; ++i) sum = before ? Expression(x) + sum : sum + Expression(x);
    EXPECT_EQ(sum.symbols(), std::vector<SymbolPointer>{x});
    Program program;
    EXPECT_EQ((program.lower(sum) - program.number(Number(terms)) * program.lower(Expression(x))).is_zero(), true);
  }
  EXPECT_EQ((Expression(x) + 1 + 2).to_string(), "((x + 1) + 2)") << "a short one stands as it was told";
}

TEST(Expression, IsPrintedAsAPersonWritesIt) {
  const Expression x = make_symbol("x"), t = make_symbol("t", "s"), one = Expression::quantity("1", "s");
  const auto text = [](const Expression& formula) { return formula.to_string(); };
  EXPECT_EQ(text(Expression::quantity("1", "m") * abs(sin(10 * (t / one)))), "abs(sin(10*t))");
  EXPECT_EQ(text(x - 1), "(x - 1)");
  EXPECT_EQ(text(x - 2 * x), "(x - 2*x)");
  EXPECT_EQ(text(x / (x + 1)), "x/(x + 1)");
  EXPECT_EQ(text(x / (x * x)), "x/(x*x)");
  EXPECT_EQ(text(1 / x), "1/x");
  EXPECT_EQ(text(x * Expression(-2)), "x*(-2)");
  EXPECT_EQ(text(pow(2 * x, 3) * pow(x, -2)), "(2*x)^3*x^(-2)");
  EXPECT_EQ(text(min(x + 1, 2 * x)), "min(x + 1, 2*x)");
  EXPECT_EQ(text(piecewise({{x < 1, 2 * x}, {x <= 3, x + 1}}, 4)), "piecewise(x < 1: 2*x, x <= 3: x + 1, 4)");
  EXPECT_EQ(text(piecewise({{x + 1 > 2 * x, x}}, 0)), "piecewise(2*x < x + 1: x, 0)");
}

TEST(Expression, RefusesOperationsWithinOneAnotherWithoutEnd) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
  GTEST_SKIP() << "what a sanitizer puts on a stack leaves no room for formulas as deep as this";
#endif
#endif
  Expression product = make_symbol("x");
  EXPECT_EQ(error_of([&] {
              for (int i = 0; i < 100'000; ++i) product = product * 2;
            }),
            "a formula has more than 20000 operations within one another: write powers as pow(x, n), and make products of parts "
            "of about the same length");
  EXPECT_EQ(product.symbols().size(), 1U);
}

TEST(Expression, IsASymbolOnlyWhenItIsNothingElse) {
  const SymbolPointer symbol = make_symbol("k");
  EXPECT_EQ(Expression(symbol).as_symbol(), symbol);
  EXPECT_EQ((-Expression(symbol)).as_symbol(), nullptr);
  EXPECT_EQ(Expression(2).as_symbol(), nullptr);
}

}  // namespace
}  // namespace torsor::expression_test
