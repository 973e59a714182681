// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/shared_products.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "torsor/generator/listing/earliest_start.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::shared_products_test {
namespace {

using namespace testing_symbols;

int operations(const Program& program, const std::vector<Value>& values, Occasion occasion = Occasion::state) {
  return count(program, values, occasion).total();
}

int known_in(const Program& program, const Value& value) {
  const EarliestStarts starts(program);
  return starts(starts.scheduled(value.polynomial()));
}

class SharedProducts : public ::testing::Test {
 protected:
  Value coordinate(const std::string& name) { return program.symbol(TestCoordinate(name).q); }
  Value parameter(const std::string& name) { return program.symbol(make_symbol(name)); }
  std::vector<Value> shared(const std::vector<Value>& values) { return with_shared_products(program, values); }

  Program program;
  Value a = coordinate("a"), b = coordinate("b"), c = coordinate("c"), d = coordinate("d"), e = coordinate("e");
};

TEST_F(SharedProducts, AreComputedOnce) {
  const std::vector<Value> plain = {a * b * c + d, a * b * d - e};
  EXPECT_EQ(operations(program, plain), 6);
  EXPECT_EQ(operations(program, shared(plain)), 5);
}

TEST_F(SharedProducts, AreTakenWhereADefinitionHasThem) {
  const Value product = program.bind(a * b);
  const std::vector<Value> plain = {product, a * b * c + d};
  EXPECT_EQ(operations(program, plain), 4);
  EXPECT_EQ(operations(program, shared(plain)), 3);
}

TEST_F(SharedProducts, AreLeftWhereEachIsFusedWithASum) {
  const std::vector<Value> plain = {a * b + c, a * b + d};
  EXPECT_EQ(shared(plain)[0].polynomial(), plain[0].polynomial());
  EXPECT_EQ(shared(plain)[1].polynomial(), plain[1].polynomial());
}

TEST_F(SharedProducts, OfANumberAreComputedOnce) {
  const std::vector<Value> plain = {Number(3) * a * b + d, Number(3) * a * c - Number(2) * d};
  EXPECT_EQ(operations(program, plain), 7);
  EXPECT_EQ(operations(program, shared(plain)), 6);
}

TEST_F(SharedProducts, AreSquaresOfHigherPowers) {
  EXPECT_EQ(operations(program, {pow(a, 4)}), 3);
  EXPECT_EQ(operations(program, shared({pow(a, 4)})), 2);
  EXPECT_EQ(operations(program, shared({pow(a, 8) + b})), 4);
}

TEST_F(SharedProducts, OfParametersAreComputedBefore) {
  const Value m = parameter("m"), l = parameter("l");
  const std::vector<Value> plain = {m * l * a + b}, after = shared(plain);
  EXPECT_EQ(operations(program, plain), 3);
  EXPECT_EQ(operations(program, after), 2);
  EXPECT_EQ(operations(program, after, Occasion::parameters), 1);
}

TEST_F(SharedProducts, KeepResultsThatAreEqualUpToSignEqual) {
  const Value sum = a * b * c + d;
  const std::vector<Value> after = shared({sum, -sum, a * b * d - e});
  EXPECT_EQ(after[0].polynomial(), (-after[1]).polynomial());
  EXPECT_EQ(operations(program, after), 5);
}

TEST_F(SharedProducts, MakeNoResultLater) {
  // The sine is multiplied last: a product with it comes too late for the others.
  const Value late = program.sin(a);
  const std::vector<Value> plain = {late * b * c + d, late * b * e - d}, after = shared(plain);
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_LE(known_in(program, after[i]), known_in(program, plain[i]));
}

// The second is what it was: were it left where it stands, it would come before the first, which is another now.
TEST_F(SharedProducts, LeaveDefinitionsInTheirOrder) {
  const Value first = program.bind(a * b * c - e, "first"), second = program.bind(c + d, "second");
  const Value third = program.bind(a * b * d + first * second, "third");
  const std::vector<Value> plain = {third}, after = shared(plain);
  EXPECT_LT(operations(program, after), operations(program, plain));
  std::vector<std::string> names;
  for (const ValueNumber value_number : program.live(after)) {
    if (!program[value_number].name.empty()) names.push_back(program[value_number].name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"first", "second", "third"}));
}

// Sums that are equal once they have the product are computed once, as they are from the start where they have it.
TEST_F(SharedProducts, MakeDefinitionsOneThatBecomeEqual) {
  const Value product = program.bind(a * b);
  const Value first = program.bind(a * b * c + d), second = program.bind(product * c + d);
  const std::vector<Value> after = shared({first * e + c, second * a + b, product});
  EXPECT_EQ(operations(program, after), 1 + 2 + 2 + 2);
}

// (1 - c) a² keeps the digits of 1 - c: the sum is not turned into c (1 - a²), although that costs no more.
TEST_F(SharedProducts, LeaveWhatIsFactoredOut) {
  const Value cosine = program.cos(c), square = a * a;
  const Value turned = cosine + square - square * cosine;
  const std::vector<Value> after = shared({turned, square * b * d + e, square * b * e + d});
  EXPECT_EQ(after[0].polynomial(), turned.polynomial());
}

// What was tried or taken is found by nobody, who then gives it its name; products of parameters are, by all.
TEST_F(SharedProducts, AreNotFoundByOthers) {
  shared({a * b + c, a * b + d});
  shared({c * d * a + b, c * d * b + a});
  EXPECT_EQ(program[*program.bind(a * b, "left").value_number()].name, "left");
  EXPECT_EQ(program[*program.bind(c * d, "taken").value_number()].name, "taken");
}

// Two thousand terms, each with a product of parameters, are left as they are.
TEST_F(SharedProducts, LeaveVeryLongSums) {
  Value sum;
  for (int k = 0; k < 2000; ++k) {
    const Value m = parameter("m" + std::to_string(k)), l = parameter("l" + std::to_string(k));
    sum += m * l * (k % 2 == 0 ? a : b);
  }
  EXPECT_EQ(shared({sum})[0].polynomial(), sum.polynomial());
}

// Where two definitions turn out to be equal, nothing may be left of a third.
TEST_F(SharedProducts, MayShowThatASumVanishes) {
  const Value product = program.bind(a * b), first = program.bind(Number(3) * product);
  const Value second = program.bind(Number(3) * a * b), nothing = program.bind(first - second);
  const std::vector<Value> plain = {nothing * c + d, first * c + e, second * d - e, program.cos(nothing)};
  const std::vector<Value> after = shared(plain);
  EXPECT_EQ(after[0].polynomial(), d.polynomial());
  EXPECT_TRUE(after[3].is_number(1));
}

// Numbers with units make a length a pure number without an operation.
TEST_F(SharedProducts, KeepFunctionsOfWhatWasMadeAPureNumber) {
  const Value x = program.symbol(TestCoordinate("x", Unit::parse("m")).q);
  const Value sine = program.sin(program.number(Number(1), Unit::parse("m^-1")) * x);
  const std::vector<Value> after = shared({sine + pow(a, 4)});
  EXPECT_EQ(operations(program, after), 2 + 1 + 2);
}

/// Sums of products of symbols and of at most one definition before them, divided by a symbol at times; of some a
/// function of what has no unit.
std::vector<Value> random_values(Program& program, const std::vector<Value>& symbols, std::mt19937& random) {
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::vector<Value> definitions = symbols, values;
  for (int k = 0; k < 14; ++k) {
    Value sum;
    for (std::size_t terms = 1 + below(4); terms > 0; --terms) {
      const Number coefficient = Number::rational(static_cast<long>(below(7)) - 3, 2);  // drawn first, by any compiler
      Value product = coefficient * definitions[below(definitions.size())];
      for (std::size_t factors = below(4); factors > 0; --factors) product = product * symbols[below(symbols.size())];
      if (below(4) == 0) product = product / symbols[below(symbols.size())];
      // Of any unit: a number takes it away.
      if (!product.is_zero()) product = product * program.number(Number(1), Unit() / product.unit());
      sum += product;
    }
    if (sum.is_zero()) continue;
    const std::size_t what = below(8);
    if (what == 0) definitions.push_back(program.sin(sum));
    if (what == 1) definitions.push_back(program.sqrt(program.bind(sum * sum) + program.number(Number(1))));
    if (what > 1) definitions.push_back(program.bind(sum));
    if (below(3) == 0) values.push_back(below(2) == 0 ? -sum : definitions.back());
  }
  values.push_back(definitions.back());
  return values;
}

// Whatever was taken out: the same values to the last of 50 digits, their units, and no operation more; a second kernel
// of the same program too, and with other passes.
TEST(SharedProductsOfRandomPrograms, ChangeNoValueAndCostNoMore) {
  const WorkingDigits digits(80);
  std::mt19937 random(20);
  int saved = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Passes passes;
    passes.factoring = trial % 3 != 1;
    passes.hoisting = trial % 5 != 2;
    passes.scheduling = trial % 7 != 3;
    Program program({}, passes);
    std::vector<Value> symbols;
    Point point;
    const auto add = [&](const SymbolPointer& symbol) {
      symbols.push_back(program.symbol(symbol));
      point.emplace(symbol->name, rational(1 + static_cast<long>(random() % 17U), 10));
    };
    for (const char* name : {"a", "b", "c"}) add(TestCoordinate(name).q);
    add(TestCoordinate("x", Unit::parse("m")).q);
    for (const char* name : {"m", "l"}) add(make_symbol(name));
    Evaluator<Real> evaluate(program, at(point));
    for (int kernel = 0; kernel < 2; ++kernel) {
      const std::vector<Value> plain = random_values(program, symbols, random);
      const std::vector<Value> after = with_shared_products(program, plain);
      ASSERT_EQ(after.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_LE(relative_difference(evaluate(after[i]), evaluate(plain[i])), 1e-50) << trial;
        ASSERT_TRUE(plain[i].is_zero() || after[i].unit() == plain[i].unit()) << trial;
      }
      const int before = operations(program, plain), now = operations(program, after);
      ASSERT_LE(now, before) << trial;
      saved += before - now;
    }
  }
  EXPECT_GT(saved, 400);
}

}  // namespace
}  // namespace torsor::shared_products_test
