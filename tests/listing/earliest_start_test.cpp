// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/earliest_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/program/test_symbols.hpp"

namespace torsor::earliest_start_test {
namespace {

using namespace testing_symbols;

/// Terms with their signs, factors side by side.
std::string text(const Program& program, const Formula& formula) {
  if (formula.kind == Formula::Kind::value_number) return label(program, formula.value_number.value());
  std::string joined;
  for (std::size_t i = 0; i < formula.children.size(); ++i) {
    if (formula.kind == Formula::Kind::sum)
      joined += formula.negative[i] ? "-" : "+";
    else if (i > 0)
      joined += " ";
    joined += text(program, formula.children[i]);
  }
  return joined;
}

class EarliestStart : public ::testing::Test {
 protected:
  Value coordinate(const std::string& name) { return program.symbol(TestCoordinate(name).q); }
  int of(const Value& value) { return starts(starts.scheduled(value.polynomial())); }
  std::string order(const Value& value) { return text(program, starts.scheduled(value.polynomial())); }
  Program program;
  EarliestStarts starts{program};
  Value a = coordinate("a"), late = program.sin(a);  // known 45 cycles after the others
  Value b = coordinate("b"), c = coordinate("c"), d = coordinate("d"), e = coordinate("e"), f = coordinate("f"),
        g = coordinate("g");
};

TEST_F(EarliestStart, AddsTheLatenciesOfWhatFollowsOneAnother) {
  EXPECT_EQ(of(a), 0);
  EXPECT_EQ(of(b + c), Latency::addition);
  EXPECT_EQ(of(b * c), Latency::multiplication);
  EXPECT_EQ(of(b * c * d), 2 * Latency::multiplication);
  EXPECT_EQ(of(b / c), Latency::division);
  EXPECT_EQ(of(program.sqrt(b)), Latency::square_root);
  EXPECT_EQ(of(late), Latency::sine_cosine);
  EXPECT_EQ(of(late * b), Latency::sine_cosine + Latency::multiplication);
}

TEST_F(EarliestStart, FusesAProductWithTheSumItStandsIn) {
  EXPECT_EQ(of(b * c + d), Latency::fused);
  EXPECT_EQ(of(b * c + d * e), Latency::multiplication + Latency::fused);
}

TEST_F(EarliestStart, OfADefinitionIsKeptWithIt) {
  const Value bound = program.bind(late * b);
  EXPECT_EQ(starts(*bound.value_number()), Latency::sine_cosine + Latency::multiplication);
  EXPECT_EQ(of(bound + c), Latency::sine_cosine + Latency::multiplication + Latency::addition);
  const Value once = program.bind(program.symbol(make_symbol("p")) * program.symbol(make_symbol("r")));
  EXPECT_EQ(starts(*once.value_number()), 0);  // computed before any state is there
}

TEST_F(EarliestStart, PutsTheTermThatIsKnownLastAtTheEnd) {
  EXPECT_EQ(order(late + b + c), "+b+c+sin(a)");
  EXPECT_EQ(of(late + b + c), Latency::sine_cosine + Latency::addition);
}

TEST_F(EarliestStart, LeavesTermsAsTheyStandWhereNoOrderIsBetter) {
  EXPECT_EQ(order(b + c + d), "+b+c+d");
  EXPECT_EQ(order(b * c + d * e), "+b c+d e");
}

TEST_F(EarliestStart, DoesNotBeginWithASubtractionWhereThereIsAnotherTerm) {
  EXPECT_EQ(order(b + c - late), "+b+c-sin(a)");
  EXPECT_EQ(order(late - b - c), "+sin(a)-b-c");
  EXPECT_EQ(order(-b - c), "-b-c");
}

// First, the single term saves an instruction, worth eight cycles. Last, it saves what the others take beyond one
// multiplication less one cycle: five cycles for two products, nine for three.
TEST_F(EarliestStart, BeginsWithTheTermThatIsNoProductUnlessTheSumWaitsForIt) {
  EXPECT_EQ(order(b * c + d * e + f), "+f+b c+d e");
  EXPECT_EQ(order(late + b * c + d * e), "+sin(a)+b c+d e");
  EXPECT_EQ(order(late + b * c + d * e + f * g), "+b c+d e+f g+sin(a)");
}

TEST_F(EarliestStart, IsLeftOutWithItsPass) {
  Passes passes;
  passes.scheduling = false;
  Program plain({}, passes);
  const Value first = plain.sin(plain.symbol(TestCoordinate("a").q));
  const Value second = plain.symbol(TestCoordinate("b").q), third = plain.symbol(TestCoordinate("c").q);
  EXPECT_EQ(text(plain, formula(plain, (first + second + third).polynomial())), "+sin(a)+b+c");
}

// A result is there when the last of its operands has come all the way.
TEST_F(EarliestStart, IsTheLongestOfAllDelays) {
  program.sqrt(program.bind(late * b));
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    Polynomial polynomial;
    const int terms = 1 + static_cast<int>(random() % 9U);
    for (int k = 0; k < terms; ++k) {
      Monomial monomial;
      for (std::size_t value_number = 0; value_number < program.size(); ++value_number) {
        const int exponent = std::max(static_cast<int>(random() % 8U) - 5, -1);
        if (exponent != 0) monomial.push_back({static_cast<ValueNumber>(value_number), exponent});
      }
      polynomial.add({monomial, Number::rational(static_cast<long>(random() % 9U) - 4, 3)});
    }
    const Formula tree = starts.scheduled(polynomial);
    int longest = 0;
    starts.for_each_delay(tree, [&](ValueNumber value_number, int cycles) {
      longest = std::max(longest, starts(value_number) + cycles);
    });
    ASSERT_EQ(longest, starts(tree)) << trial << ": " << text(program, tree);
  }
}

}  // namespace
}  // namespace torsor::earliest_start_test
