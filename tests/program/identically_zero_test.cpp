// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/identically_zero.hpp"

#include <gtest/gtest.h>

#include "tests/program/test_symbols.hpp"

namespace torsor::identically_zero_test {
namespace {

using namespace testing_symbols;
using namespace literals;

TEST(Vanishes, RecognisesIdentitiesThatNoTermByTermComparisonSees) {
  Program program;
  const Expression x = make_symbol("x");
  const Expression y = make_symbol("y");
  const auto zero = [&](const Expression& f) { return identically_zero(program.lower(f)); };
  EXPECT_TRUE(zero(sin(2 * x) - 2 * sin(x) * cos(x)));
  EXPECT_TRUE(zero((x + y) * (x - y) - (x * x - y * y)));
  EXPECT_TRUE(zero(exp(x + y) - exp(x) * exp(y)));
  EXPECT_TRUE(zero(x - x));
  EXPECT_TRUE(zero(pow(sin(0.3_r), 2) + pow(cos(0.3_r), 2) - 1));
}

// Next to nothing at all times but some milliseconds. It was taken for zero, and a cart with that law had no acceleration.
TEST(Vanishes, IsNotFooledByWhatActsForAMillisecond) {
  Program program;
  const Expression x = make_symbol("x"), since = (x - 1 / 2_r) / Expression(1 / 1000_r);
  const auto zero = [&](const Expression& f) { return identically_zero(program.lower(f)); };
  EXPECT_FALSE(zero(exp(-since) / pow(1 + exp(-since), 2)));
  EXPECT_FALSE(zero(exp(-since * since)));
  EXPECT_FALSE(zero(3 * x + exp(-since * since) - 3 * x));
  EXPECT_TRUE(zero(exp(-since * since) * exp(since * since) - 1));
  EXPECT_TRUE(zero(log(exp(-since)) + since));
  EXPECT_TRUE(zero(exp(x - since * since) - exp(-since * since) * exp(x)));
}

TEST(Vanishes, IsNotFooledBySmallOrUndefinedValues) {
  Program program;
  const Expression x = make_symbol("x");
  const auto zero = [&](const Expression& f) { return identically_zero(program.lower(f)); };
  EXPECT_FALSE(zero(sin(x) - x));
  EXPECT_FALSE(zero(x * Expression(Number(10).pow(-30))));
  EXPECT_FALSE(zero(Expression(Number(10).pow(-90))));
  EXPECT_FALSE(zero(sqrt(-x - 1)));  // not a number anywhere
}

TEST(Vanishes, LooksAtBothSignsOfWhatMoves) {
  Program program;
  const Expression x = TestCoordinate("x").q;
  const Expression length = make_symbol("length");
  EXPECT_FALSE(identically_zero(program.lower(sqrt(x * x) - x)));
  EXPECT_FALSE(identically_zero(program.lower(sqrt(x * x) + x)));
  EXPECT_TRUE(identically_zero(program.lower(sqrt(x * x) * sqrt(x * x) - x * x)));
  EXPECT_TRUE(identically_zero(program.lower(sqrt(length * length) - length)));  // parameters are taken for sizes
}

TEST(Vanishes, AnswersForManyValuesAtOnce) {
  Program program;
  const Expression x = make_symbol("x");
  const std::vector<Value> values{program.lower(sin(2 * x) - 2 * sin(x) * cos(x)), Value(), program.lower(x),
                                  program.lower(3), program.lower(exp(x) * exp(-x) - 1)};
  EXPECT_EQ(identically_zero_entries(values), (std::vector<bool>{true, true, false, false, true}));
  EXPECT_EQ(identically_zero_entries({}), std::vector<bool>{});
  EXPECT_EQ(identically_zero_entries({Value()}), std::vector<bool>{true});
}

TEST(Vanishes, FollowsTermsThatGrowBeyondAllExponents) {
  Program program;
  const Expression x = make_symbol("x");
  const Value one = program.bind(program.lower(x + 2)) - program.bind(program.lower(x + 1));
  Value power = program.bind(one);  // of terms larger than 3: those of its power 2^80 are more than 10^(10^23)
  for (int k = 0; k < 80; ++k) power = program.bind(power * power);
  EXPECT_TRUE(identically_zero(power - one));
  EXPECT_FALSE(identically_zero(power + one));
}

TEST(Vanishes, TellsWhatIsSmallFromWhatCancels) {
  Program program;
  const Expression x = TestCoordinate("x").q;
  const Expression tiny(Number(10).pow(-47));
  EXPECT_FALSE(identically_zero(program.lower(tiny * cos(x))));  // the moment of inertia of a molecule, in kg m^2
  EXPECT_FALSE(identically_zero(program.lower(tiny * x - 2 * tiny * x * cos(x))));
  EXPECT_TRUE(identically_zero(program.lower(tiny * (sin(2 * x) - 2 * sin(x) * cos(x)))));
}

TEST(Vanishes, FindsWhatActsInOneRegionOnly) {
  Program program;
  const Expression x = TestCoordinate("x").q;
  const Expression wall = exp(1000 * (x - 2)), beyond = x - 2, before = -x - 2;
  EXPECT_FALSE(identically_zero(program.lower(wall)));
  EXPECT_FALSE(identically_zero(program.lower(wall + sin(2 * x) - 2 * sin(x) * cos(x))));
  EXPECT_FALSE(identically_zero(program.lower((beyond + sqrt(beyond * beyond)) / 2)));  // a stop at 2, and one at -2
  EXPECT_FALSE(identically_zero(program.lower((before + sqrt(before * before)) / 2)));
  EXPECT_TRUE(
      identically_zero(program.lower(sqrt(2 - x * x) * sqrt(2 - x * x) - 2 + x * x)));  // undefined far from zero
}

}  // namespace
}  // namespace torsor::identically_zero_test
