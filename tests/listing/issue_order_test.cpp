// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/issue_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/program/test_symbols.hpp"

namespace torsor::issue_order_test {
namespace {

using namespace testing_symbols;

std::vector<ValueNumber> operands(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
  if (definition.function) return definition.arguments;
  std::vector<ValueNumber> all;
  for (const Term& term : definition.polynomial.terms()) {
    for (const Factor& factor : term.monomial) all.push_back(factor.value_number);
  }
  return all;
}

std::size_t place(const std::vector<ValueNumber>& order, ValueNumber value_number) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), value_number) - order.begin());
}

/// The most results that stand between their definition and their last use.
int most_live(const Program& program, const std::vector<ValueNumber>& order) {
  std::vector<std::size_t> last_use(order.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const ValueNumber operand : operands(program, order[k])) {
      const std::size_t at = place(order, operand);
      if (at < order.size()) last_use[at] = std::max(last_use[at], k);
    }
  }
  int most = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    int live = 0;
    for (std::size_t i = 0; i <= k; ++i) live += last_use[i] > k ? 1 : 0;
    most = std::max(most, live);
  }
  return most;
}

class IssueOrder : public ::testing::Test {
 protected:
  Value coordinate(const std::string& name) { return program.symbol(TestCoordinate(name).q); }
  ValueNumber define(const Value& value) { return *program.bind(value).value_number(); }
  Value value(ValueNumber value_number) { return program.value_of_number(value_number); }
  Program program;
  Value a = coordinate("a"), b = coordinate("b"), c = coordinate("c");
};

TEST_F(IssueOrder, BeginsWithWhatTheResultsWaitForLongest) {
  const ValueNumber sum = define(a + b), product = define(a * c);
  const ValueNumber root = *program.sqrt(value(product)).value_number();
  const ValueNumber result = define(value(root) + b);
  EXPECT_EQ(issue_order(program, EarliestStarts(program), {sum, product, root, result}),
            (std::vector<ValueNumber>{product, sum, root, result}));
}

TEST_F(IssueOrder, KeepsTheProgramsOrderWhereNothingIsMoreUrgent) {
  const std::vector<ValueNumber> definitions{define(a + b), define(a + c), define(b + c)};
  EXPECT_EQ(issue_order(program, EarliestStarts(program), definitions), definitions);
  EXPECT_TRUE(issue_order(program, EarliestStarts(program), {}).empty());
}

TEST_F(IssueOrder, PutsWhatDoesNotDependOnTheStateFirst) {
  const Value p = program.symbol(make_symbol("p")), r = program.symbol(make_symbol("r"));
  const ValueNumber at_each_state = define(a * b), once = define(p * r);
  EXPECT_EQ(issue_order(program, EarliestStarts(program), {at_each_state, once}),
            (std::vector<ValueNumber>{once, at_each_state}));
}

TEST_F(IssueOrder, IsTheProgramsWithoutThePass) {
  Passes passes;
  passes.scheduling = false;
  Program plain({}, passes);
  const Value x = plain.symbol(TestCoordinate("x").q), y = plain.symbol(TestCoordinate("y").q);
  const ValueNumber sum = *plain.bind(x + y).value_number(), product = *plain.bind(x * y).value_number();
  const std::vector<ValueNumber> definitions{sum, product, *plain.sqrt(plain.value_of_number(product)).value_number()};
  EXPECT_EQ(issue_order(plain, EarliestStarts(plain), definitions), definitions);
}

// Sixty products, each used once: all of them are more urgent than any of their users.
TEST_F(IssueOrder, HoldsNoMoreValuesThanRegistersDo) {
  std::vector<ValueNumber> definitions, users;
  for (int k = 0; k < 60; ++k) {
    definitions.push_back(define(coordinate("x" + std::to_string(k)) * b));
    users.push_back(define(value(definitions.back()) * c));
  }
  definitions.insert(definitions.end(), users.begin(), users.end());
  EXPECT_EQ(most_live(program, definitions), 60);
  EXPECT_LE(most_live(program, issue_order(program, EarliestStarts(program), definitions)), 20);
}

TEST_F(IssueOrder, ComputesEveryDefinitionOnceBehindItsOperandsAndNearItsPlace) {
  std::mt19937 random(7);
  std::vector<Value> values{a, b, c};
  while (values.size() < 1000) {
    const std::size_t recent = std::min<std::size_t>(values.size(), 300);
    const Value& x = values[values.size() - 1 - random() % recent];
    const Value& y = values[random() % values.size()];
    const Value next = random() % 2U == 0 ? x + y : x * y;
    values.push_back(random() % 10U == 0 ? program.sqrt(next) : program.bind(next));
  }
  std::vector<ValueNumber> definitions;
  for (std::size_t k = 0; k < program.size(); ++k) {
    if (!program[static_cast<ValueNumber>(k)].symbol) definitions.push_back(static_cast<ValueNumber>(k));
  }
  const std::vector<ValueNumber> order = issue_order(program, EarliestStarts(program), definitions);
  ASSERT_TRUE(std::is_permutation(order.begin(), order.end(), definitions.begin(), definitions.end()));
  EXPECT_NE(order, definitions);
  std::vector<bool> known(program.size(), false);
  std::size_t first = 0;
  for (std::size_t k = 0; k < program.size(); ++k) known[k] = program[static_cast<ValueNumber>(k)].symbol != nullptr;
  for (const ValueNumber value_number : order) {
    for (const ValueNumber operand : operands(program, value_number))
      ASSERT_TRUE(known[static_cast<std::size_t>(operand)]) << value_number;
    while (known[static_cast<std::size_t>(definitions[first])]) ++first;
    EXPECT_LT(place(definitions, value_number), first + 60);
    known[static_cast<std::size_t>(value_number)] = true;
  }
}

}  // namespace
}  // namespace torsor::issue_order_test
