// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "torsor/generator/base/error.hpp"

namespace torsor::ball_test {
namespace {

TEST(Ball, IsAbsentWithAWordWhereItWasNotBuilt) {
  if (Ball::available()) GTEST_SKIP() << "it was";
  EXPECT_THROW(Ball(1), Error);
}

/// (√2)² - 2, sin² + cos² - 1, exp(log 3) - 3: balls around zero, as small as the digits allow and never empty.
TEST(Ball, EnclosesIdentities) {
  if (!Ball::available()) GTEST_SKIP() << "built without Arb";
  for (const int digits : {30, 90}) {
    const WorkingDigits precision(digits);
    const Ball root = Ball::of_number(Number::sqrt2()), third = Ball::of_number(Number::rational(1, 3));
    const Ball x = sin(third), y = cos(third), three = exp(log(Ball(3)));
    for (const Ball& zero : {root * root - Ball(2), x * x + y * y - Ball(1), three - Ball(3),
                             sqrt(third * third) - third, sin(Ball::pi())}) {
      EXPECT_LE(zero.largest(), std::pow(10.0, 2 - digits));
      EXPECT_GT(zero.radius(), 0.0);
      EXPECT_LE(zero.largest(), 2.01 * zero.radius());  // 0 lies inside
    }
  }
}

TEST(Ball, TakesDoublesExactlyAndKnowsNothingOfAQuotientByZero) {
  if (!Ball::available()) GTEST_SKIP() << "built without Arb";
  const Ball x = Ball::from_double(0x1.23456789abcdfp-40);
  EXPECT_EQ(x.radius(), 0.0);
  EXPECT_EQ((x - x).largest(), 0.0);
  const Ball zero = sin(Ball::pi());
  EXPECT_FALSE(std::isfinite((Ball(1) / zero).largest()));
}

// √3 √6 = 3 √2 and √2 √3 = √6, from the parts of numbers.
TEST(Ball, TakesEachPartOfANumberUnderItsRoot) {
  if (!Ball::available()) GTEST_SKIP() << "built without Arb";
  const Ball two = Ball::of_number(Number::sqrt2()), three = Ball::of_number(Number::sqrt3());
  const Ball six = Ball::of_number(Number::sqrt2() * Number::sqrt3());
  for (const Ball& zero : {two * two - Ball(2), three * three - Ball(3), two * three - six}) {
    EXPECT_LE(zero.largest(), 1e-14);
  }
}

/// A condition of which the sign is not known leaves both branches open: 1, 5 and all between.
TEST(Ball, HoldsBothBranchesOfAChoiceThatIsNotDecided) {
  if (!Ball::available()) GTEST_SKIP() << "built without Arb";
  const Ball about_zero = sin(Ball::pi());
  for (const Ball& open : {select(about_zero, Ball(1), Ball(5)), select(about_zero, Ball(5), Ball(1))}) {
    EXPECT_GE(open.largest(), 5);
    EXPECT_NEAR(open.radius(), 2, 1e-6);
  }
  EXPECT_NEAR(select(Ball(-1), Ball(1), Ball(5)).largest(), 5, 1e-6);
  EXPECT_NEAR(select(Ball(0), Ball(1), Ball(5)).largest(), 1, 1e-6);
}

}  // namespace
}  // namespace torsor::ball_test
