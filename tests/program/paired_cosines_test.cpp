// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/paired_cosines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::paired_cosines_test {
namespace {

struct Angles {
  Scene scene{"symbols"};
  Program program;
  Expression m = scene.parameter("m", "1"), k = scene.parameter("k", "1"), x = scene.coordinate("x", "rad"),
             y = scene.coordinate("y", "rad"), z = scene.coordinate("z", "rad");

  Value paired(const Expression& formula) { return with_paired_cosines(program, program.lower(formula)); }
  bool is_kept(const Expression& formula) {
    return paired(formula).polynomial() == program.lower(formula).polynomial();
  }
  double at(const Value& value, double x_value, double y_value) {
    return Evaluator<double>(program, [&](const SymbolPointer& symbol) {
      return symbol->name == "x" ? x_value : symbol->name == "y" ? y_value : 3.0;
    })(value);
  }
};

TEST(PairedCosines, EqualTheSumInEverySign) {
  Angles of;
  for (const int a : {1, -1}) {
    for (const int b : {1, -1}) {
      const Expression cosines = a * of.m * cos(of.x) + b * of.m * cos(of.y);
      const Expression sines = a * of.m * sin(of.x) + b * of.m * sin(of.y);
      const Expression beside_one = a * of.m * of.z + b * of.m * of.z * cos(of.x);
      for (const Expression& each : {cosines, sines, cosines + sines, cosines + of.k * cos(of.x) + of.z, beside_one}) {
        const Value paired = of.paired(each), given = of.program.lower(each);
        EXPECT_FALSE(paired.polynomial() == given.polynomial());
        EXPECT_TRUE(identically_zero(paired - given)) << a << b;
      }
    }
  }
}

// cos x + cos y = 2 cos((x + y)/2) cos((x − y)/2) at x = 1e-6, y = π is some −5e-13, of which the sum, rounded to
// 1e-16, keeps four digits. The halves of sum and difference, rounded to 2.2e-16, are off by that over 5e-7 from a
// quarter turn.
TEST(PairedCosines, KeepTheDigitsWhereBothAreNearlyOne) {
  Angles of;
  const Expression sum = of.m * cos(of.x) + of.m * cos(of.y);
  const double x = 1e-6, y = std::acos(-1.0), rest = 1.2246467991473532e-16;  // π − y
  const double exact = 3 * 2 * std::sin((x - rest) / 2) * -std::sin((x + rest) / 2);
  const double paired = of.at(of.paired(sum), x, y), plain = of.at(of.program.lower(sum), x, y);
  EXPECT_NEAR(paired / exact, 1, 1e-9);
  EXPECT_GT(std::abs(plain / exact - 1), 1e-6);
}

TEST(PairedCosines, LeaveWhatStaysWithTheLargerOne) {
  Angles of;
  const Value paired = of.paired(Expression(Number::rational(1000001, 1000000)) * cos(of.x) + cos(of.y));
  EXPECT_EQ(paired.polynomial().terms().size(), 2U) << to_string(paired);
  EXPECT_FALSE(of.is_kept(of.x * cos(of.x) + of.x * cos(of.y)));
}

// 2 cos x + cos y does not vanish where both rates do; nor do sums of different parameters, as far as is known.
TEST(PairedCosines, KeepOtherSumsAsTheyStand) {
  Angles of;
  EXPECT_TRUE(of.is_kept(2 * cos(of.x) + cos(of.y)));
  EXPECT_TRUE(of.is_kept(of.m * cos(of.x) + of.k * cos(of.y)));
  EXPECT_TRUE(of.is_kept(cos(of.x) + sin(of.y)));
  EXPECT_TRUE(of.is_kept(cos(of.x) * cos(of.y) + cos(of.z) * cos(of.y)));
  EXPECT_TRUE(of.is_kept(of.x + of.y));
  EXPECT_TRUE(of.is_kept(of.m + of.m * sin(of.x)));
  EXPECT_TRUE(of.is_kept(Expression(3)));
}

}  // namespace
}  // namespace torsor::paired_cosines_test
