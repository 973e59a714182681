// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/program/test_symbols.hpp"

namespace torsor::program_test {
namespace {

using namespace testing_symbols;
using namespace literals;

/// Three dimensionless symbols in a program of their own.
class ProgramTest : public ::testing::Test {
 protected:
  Value lower(const Expression& expression) { return program.lower(expression); }

  Program program;
  Expression x = make_symbol("x"), y = make_symbol("y"), z = make_symbol("z");
};

using ProgramSharing = ProgramTest;

TEST_F(ProgramSharing, GivesOneDefinitionToASumAndToItsOpposite) {
  const Value first = program.bind(lower(x - y));
  const std::size_t size = program.size();
  const Value second = program.bind(lower(y - x));
  EXPECT_EQ(program.size(), size);
  EXPECT_TRUE((first + second).is_zero());
  EXPECT_EQ(first.polynomial().terms()[0].monomial, second.polynomial().terms()[0].monomial);
}

TEST_F(ProgramSharing, GivesOneDefinitionToASumBuiltInAnyOrder) {
  const Value first = program.bind(lower(x * y + z + 2 * x));
  const std::size_t size = program.size();
  EXPECT_EQ(program.bind(lower(x + z + y * x + x)).polynomial(), first.polynomial());
  EXPECT_EQ(program.size(), size);
}

TEST_F(ProgramSharing, TakesPowersOfASumAndOfItsOppositeFromOneDefinition) {
  EXPECT_TRUE((lower(pow(x - y, -1)) + lower(pow(y - x, -1))).is_zero());
  EXPECT_TRUE((lower(pow(x - y, 2)) - lower(pow(y - x, 2))).is_zero());
  EXPECT_TRUE((lower(pow(x - y, 3)) + lower(pow(y - x, 3))).is_zero());
}

TEST_F(ProgramSharing, MakesNoDefinitionForASymbolItsOppositeOrANumber) {
  const Value symbol = lower(x);
  const std::size_t size = program.size();
  EXPECT_TRUE(program.bind(symbol).value_number());
  program.bind(-symbol);
  program.bind(program.number(Number(7)));
  EXPECT_EQ(program.size(), size);
}

TEST_F(ProgramSharing, KeepsDefinitionsFlat) {
  lower((x + y) * (y + z) * sin(x * (y - z) + 1));
  for (std::size_t k = 0; k < program.size(); ++k) {
    for (const Term& term : program[static_cast<ValueNumber>(k)].polynomial.terms()) {
      for (const Factor& factor : term.monomial) ASSERT_LT(factor.value_number, static_cast<ValueNumber>(k));
    }
    for (const ValueNumber argument : program[static_cast<ValueNumber>(k)].arguments)
      ASSERT_LT(argument, static_cast<ValueNumber>(k));
  }
}

TEST_F(ProgramSharing, ComesOutTheSameEachTime) {
  const auto text = [&] {
    Program again;
    again.bind(again.lower((x + y) * sin(x - y) / (z + sqrt(x * x + 1))));
    std::string all;
    for (std::size_t k = 0; k < again.size(); ++k) {
      all += std::to_string(k) + ": " + to_string(Value(again, again[static_cast<ValueNumber>(k)].polynomial, Unit())) +
             "\n";
    }
    return all;
  };
  EXPECT_EQ(text(), text());
}

using ProgramTrigonometry = ProgramTest;

TEST_F(ProgramTrigonometry, ReducesTheSumOfTheTwoSquares) {
  EXPECT_TRUE(lower(pow(sin(x), 2) + pow(cos(x), 2)).is_number(1));
  const Expression scaled = 3 * y * pow(sin(x), 2) + z + 3 * y * pow(cos(x), 2);
  EXPECT_TRUE((lower(scaled) - lower(3 * y + z)).is_zero());
  // Higher powers: s⁴ + s²c² = s².
  EXPECT_TRUE((lower(pow(sin(x), 4) + pow(sin(x), 2) * pow(cos(x), 2)) - lower(pow(sin(x), 2))).is_zero());
}

TEST_F(ProgramTrigonometry, LeavesSquaresOfDifferentAnglesOrCoefficientsAlone) {
  EXPECT_EQ(lower(pow(sin(x), 2) + pow(cos(y), 2)).polynomial().terms().size(), 2U);
  EXPECT_EQ(lower(pow(sin(x), 2) + 2 * pow(cos(x), 2)).polynomial().terms().size(), 2U);
  EXPECT_EQ(lower(pow(sin(x), 2) - pow(cos(x), 2)).polynomial().terms().size(), 2U);
}

TEST_F(ProgramTrigonometry, IsExactAtMultiplesOfATwelfthOfPi) {
  for (int k = -30; k <= 30; ++k) {
    const Expression angle = Number::rational(k, 12) * pi();
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(k));
    EXPECT_TRUE(lower(sin(angle)).is_constant());
    EXPECT_EQ(lower(sin(angle)).polynomial().constant(), sine) << k;
    EXPECT_EQ(lower(cos(angle)).polynomial().constant(), cosine) << k;
  }
}

TEST_F(ProgramTrigonometry, ShiftsAnAngleByTwelfthsOfPiExactly) {
  const WorkingDigits precision(50);
  const Real angle = rational(7, 10);
  for (int k = -30; k <= 30; ++k) {
    const Expression shifted = x + Number::rational(k, 12) * pi();
    const Value sine = lower(sin(shifted));
    const Value cosine = lower(cos(shifted));
    Evaluator<Real> evaluate(program, at({{"x", angle}}));
    const Real truth = angle + rational(k, 12) * Real::pi();
    // Angles below ten lose one digit of 50 in their reduction.
    EXPECT_LT(relative_difference(evaluate(sine), torsor::sin(truth)), 1e-47) << k;
    EXPECT_LT(relative_difference(evaluate(cosine), torsor::cos(truth)), 1e-47) << k;
  }
  // One pair of functions serves all 61 angles.
  std::size_t functions = 0;
  for (std::size_t k = 0; k < program.size(); ++k) functions += program[static_cast<ValueNumber>(k)].function ? 1U : 0U;
  EXPECT_EQ(functions, 2U);
}

TEST_F(ProgramTrigonometry, KnowsThatSineIsOddAndCosineEven) {
  EXPECT_TRUE((lower(sin(-x)) + lower(sin(x))).is_zero());
  EXPECT_TRUE((lower(cos(-x)) - lower(cos(x))).is_zero());
  EXPECT_TRUE((lower(sin(x - y)) + lower(sin(y - x))).is_zero());
  EXPECT_TRUE((lower(sin(pi() - x)) - lower(sin(x))).is_zero());
  EXPECT_TRUE((lower(cos(pi() / 2 - x)) - lower(sin(x))).is_zero());
}

using ProgramFolding = ProgramTest;

// |x| has a slope at 0, which sqrt(x^2) has not, and x^2 has one that is right. A parameter is a size: its square stays.
TEST_F(ProgramFolding, TakesTheRootOfASquareWithoutARoot) {
  const Expression size = x;
  x = TestCoordinate("x").q;
  y = TestCoordinate("y").q;
  z = TestCoordinate("z").q;
  const auto equal = [&](const Expression& root, const Expression& plain) {
    EXPECT_EQ(lower(root).polynomial(), lower(plain).polynomial()) << root.to_string();
  };
  equal(sqrt(x * x), abs(x));
  equal(sqrt(9 * pow(x + y, 2)), 3 * abs(x + y));
  equal(sqrt(pow(x - y, 4)), pow(x - y, 2));
  equal(sqrt(pow(x, 6)), abs(x) * x * x);
  equal(sqrt(x * x / (y * y) * pow(z, -4)), abs(x / y) / (z * z));
  equal(sqrt(2 * x * x), sqrt(Expression(2)) * abs(x));
  equal(sqrt(pow(exp(x), 2)), exp(x));
  EXPECT_NE(lower(sqrt(size * size)).polynomial(), lower(abs(size)).polynomial());
  const Expression length = make_symbol("l", "m");
  EXPECT_EQ(lower(sqrt(pow(length, 2))).unit(), units::metre);
  EXPECT_EQ(lower(sqrt(pow(length, 2) * pow(x, 2) * pow(length, 4))).unit(), units::metre.pow(3));
  const Value other = lower(sqrt(x * x * y));
  ASSERT_TRUE(other.value_number());
  EXPECT_EQ(program[*other.value_number()].function, Function::sqrt);
}

TEST_F(ProgramFolding, FoldsWhatHasAnExactValue) {
  EXPECT_EQ(lower(sqrt(4_r / 9)).polynomial().constant(), Number::rational(2, 3));
  EXPECT_EQ(lower(sqrt(Expression(2))).polynomial().constant(), Number::sqrt2());
  EXPECT_TRUE(lower(sin(Expression(0))).is_zero());
  EXPECT_TRUE(lower(cos(Expression(0))).is_number(1));
  EXPECT_TRUE(lower(exp(Expression(0))).is_number(1));
  EXPECT_TRUE(lower(pow(x - x + 3, 2)).is_number(9));
  EXPECT_TRUE(lower(x / x).is_number(1));
  EXPECT_TRUE(lower((x + y) / (x + y)).is_number(1));
}

TEST_F(ProgramFolding, KeepsAConstantWithoutExactValueAsADefinitionOfTheGenerationStage) {
  const Value sine = lower(sin(0.3_r));
  ASSERT_TRUE(sine.value_number());
  EXPECT_EQ(program.stage(sine), Stage::generation);
  EXPECT_TRUE((sine + lower(sin(-0.3_r))).is_zero());
  EXPECT_TRUE((lower(cos(0.3_r)) - lower(cos(-0.3_r))).is_zero());
  Evaluator<Real> evaluate(program, at({}));
  EXPECT_LT(relative_difference(evaluate(sine), torsor::sin(rational(3, 10))), 1e-48);
}

TEST_F(ProgramFolding, GivesTheRootsOfEqualNumbersTheirOwnUnits) {
  const Value length = lower(sqrt(Expression::quantity("5", "m^2")));
  const Value mass = lower(sqrt(Expression::quantity("5", "kg^2")));
  EXPECT_EQ(length.unit(), units::metre);
  EXPECT_EQ(mass.unit(), units::kilogram);
}

TEST_F(ProgramFolding, RefusesWhatHasNoRealValue) {
  EXPECT_THROW(lower(sqrt(Expression(-2))), Error);
  EXPECT_THROW(lower(log(Expression(0))), Error);
  EXPECT_THROW(lower(log(Expression(-1))), Error);
  EXPECT_THROW(lower(1 / (x - x)), Error);
}

TEST_F(ProgramFolding, HoldsADoubleAsADecimalFractionAndNeverAsAFloat) {
  const Value tenth = lower(Expression(0.1) * x);
  EXPECT_EQ(tenth.polynomial().terms()[0].coefficient, Number::rational(1, 10));
  lower(sin(0.1 * x + 0.7) * sqrt(y * 1e-3 + 2.5) / (z + 1.1));
  for (std::size_t k = 0; k < program.size(); ++k) {
    for (const Term& term : program[static_cast<ValueNumber>(k)].polynomial.terms()) {
      // A binary fraction in disguise would have a power of two of some fifty bits in its denominator.
      ASSERT_TRUE(term.coefficient.is_rational());
      ASSERT_TRUE((term.coefficient * Number(10000)).is_integer()) << term.coefficient.to_string();
    }
  }
}

using ProgramUnits = ProgramTest;

TEST_F(ProgramUnits, RefusesASumOfDifferentUnitsAndNamesBothTerms) {
  const Value mass = lower(Expression(make_symbol("mass", "kg")));
  const Value length = lower(Expression(make_symbol("length", "m")));
  EXPECT_EQ(error_of<UnitError>([&] { mass + length; }),
            "cannot add 1 mass [kg] and 1 length [m]: both terms of a sum need the same unit");
  EXPECT_EQ(error_of<UnitError>([&] { mass - length; }),
            "cannot add 1 mass [kg] and -1 length [m]: both terms of a sum need the same unit");
}

TEST_F(ProgramUnits, RefusesAFunctionOfAQuantityWithAUnitAndNamesIt) {
  const Value length = lower(Expression(make_symbol("length", "m")));
  EXPECT_EQ(error_of<UnitError>([&] { program.sin(length); }),
            "the argument of sin(1 length) has the unit m and must be dimensionless");
}

TEST_F(ProgramUnits, LetsZeroFitAnyUnit) {
  const Value length = lower(Expression(make_symbol("length", "m")));
  EXPECT_EQ((length + program.number(Number())).unit(), units::metre);
  EXPECT_EQ((program.number(Number()) + length).unit(), units::metre);
  EXPECT_EQ((Value() + length).unit(), units::metre);
  EXPECT_TRUE((Value() * length).is_zero());
}

TEST_F(ProgramUnits, RefusesToMixPrograms) {
  Program other;
  EXPECT_THROW(lower(x) + other.lower(x), Error);
}

using ProgramLife = ProgramTest;

TEST_F(ProgramLife, DropsDefinitionsThatNoOutputNeeds) {
  const Value wanted = program.bind(lower(sin(x + y)));
  const Value unwanted = program.bind(lower(cos(z) * (x + z)));
  std::vector<std::string> labels;
  for (const ValueNumber value_number : program.live({wanted})) labels.push_back(label(program, value_number));
  const std::string sum = label(program, program[*wanted.value_number()].arguments[0]);
  EXPECT_EQ(labels, (std::vector<std::string>{"x", "y", sum, "sin(" + sum + ")"}));
  const std::vector<ValueNumber> both = program.live({wanted, unwanted});
  EXPECT_TRUE(std::is_sorted(both.begin(), both.end()));
  EXPECT_GT(both.size(), 4U);
  EXPECT_TRUE(program.live({program.number(Number(3))}).empty());
}

TEST_F(ProgramLife, ComputesEachDefinitionAtTheEarliestStage) {
  const TestCoordinate q("q");
  const Expression t = make_symbol("t", "s", SymbolKind::time);
  const Expression u = make_symbol("u", "1", SymbolKind::input);
  EXPECT_EQ(program.stage(lower(Expression(2) * pi())), Stage::generation);
  EXPECT_EQ(program.stage(lower(x * y)), Stage::parameters);
  EXPECT_EQ(program.stage(lower(sin(x * Expression(q.q)))), Stage::configuration);
  EXPECT_EQ(program.stage(lower(t)), Stage::configuration);
  EXPECT_EQ(program.stage(program.bind(lower(Expression(q.v) * sin(x)))), Stage::state);
  EXPECT_EQ(program.stage(lower(Expression(q.a))), Stage::call);
  EXPECT_EQ(program.stage(lower(u * x)), Stage::call);
}

TEST(ProgramResolver, ReplacesSymbolsAndTheirRates) {
  const TestCoordinate q("q");
  const SymbolPointer t = make_symbol("t", "s", SymbolKind::time);
  const Expression law = pow(Expression(t) / Expression::quantity("1", "s"), 3);
  Program program([&](const SymbolPointer& symbol) -> std::optional<Expression> {
    if (symbol == q.q) return law;
    if (symbol == q.v) return rate(law);
    if (symbol == q.a) return rate(rate(law));
    return std::nullopt;
  });
  const Value twice = program.lower(rate(rate(Expression(q.q))));
  EXPECT_TRUE((twice - program.lower(6 * Expression(t) / Expression::quantity("1", "s^3"))).is_zero());
  EXPECT_TRUE((program.symbol(q.a) - twice).is_zero());
}

/// All that a program says of its definitions.
std::string written(Program& program) {
  std::string text;
  for (std::size_t k = 0; k < program.size(); ++k) {
    const auto value_number = static_cast<ValueNumber>(k);
    text += label(program, value_number) + " = " + to_string(Value(program, program[value_number].polynomial, Unit())) +
            "\n";
  }
  return text;
}

TEST_F(ProgramTest, ForgetsWhatItIsToldToForget) {
  program.bind(lower(x + y));
  program.sin(program.bind(lower(x + y)));
  const std::size_t kept = program.size();
  const auto derive = [this] {
    program.bind(lower(x * z + y));
    program.bind(lower(sin(z) * cos(x + y) + sqrt(z)));
    program.bind_apart(lower(x + z), "apart");
    program.argument(program[program.sin(-lower(z * x - y)).polynomial().terms()[0].monomial[0].value_number], 0);
    return written(program);
  };
  const std::string first = derive();
  ASSERT_GT(program.size(), kept);
  program.truncate(kept);
  EXPECT_EQ(program.size(), kept);
  EXPECT_FALSE(program.find(z.as_symbol()));
  // Something else first, and forgotten too: nothing of it is found again.
  program.bind(lower(z + x * y));
  program.cos(lower(z));
  program.truncate(kept);
  EXPECT_EQ(derive(), first);
  EXPECT_EQ(program.bind(lower(y + x)).value_number(), program.bind(lower(x + y)).value_number());
}

}  // namespace
}  // namespace torsor::program_test
