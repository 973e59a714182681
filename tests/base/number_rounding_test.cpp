// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/number.hpp"

namespace torsor::number_rounding_test {
namespace {

/// The exact value of a finite float, from its mantissa and exponent alone (independent of the rounding under test).
template <class Float>
Number exact(Float value) {
  int exponent = 0;
  const Float fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<long>(std::ldexp(fraction, std::numeric_limits<Float>::digits));
  return Number(mantissa) * Number(2).pow(exponent - std::numeric_limits<Float>::digits);
}

template <class Float>
bool has_even_mantissa(Float value) {
  const Number units = exact(value) / exact(std::numeric_limits<Float>::denorm_min());
  int exponent = 0;
  std::frexp(value, &exponent);
  const int shift = std::max(0, exponent - std::numeric_limits<Float>::min_exponent);
  return (units / Number(2).pow(shift + 1)).is_integer();
}

/// No neighbour is nearer, and one that is as near has an odd mantissa: the definition of rounding to nearest, even.
template <class Float>
void expect_nearest(const Number& number, Float rounded) {
  ASSERT_TRUE(std::isfinite(rounded)) << number.to_string();
  const Number distance = (number - exact(rounded)).abs();
  for (const Float direction : {-std::numeric_limits<Float>::infinity(), std::numeric_limits<Float>::infinity()}) {
    const Float neighbour = std::nextafter(rounded, direction);
    if (!std::isfinite(neighbour)) continue;
    const Number other = (number - exact(neighbour)).abs();
    EXPECT_LE(distance, other) << number.to_string();
    if (distance == other) {
      EXPECT_TRUE(has_even_mantissa(rounded)) << number.to_string();
    }
  }
}

TEST(NumberRounding, IsNearestForRandomRationals) {
  std::mt19937_64 engine(7);
  std::uniform_int_distribution<long> part(1, std::numeric_limits<long>::max());
  std::uniform_int_distribution<int> bits(0, 62);
  std::uniform_int_distribution<int> scale(-60, 60);
  for (int round = 0; round < 10000; ++round) {
    // Operands of every length, so that short quotients and halfway cases occur as well as long ones.
    Number number = Number::rational(part(engine) >> bits(engine), (part(engine) >> bits(engine)) + 1);
    if (round % 2 == 1) number = -number;
    if (round % 3 == 1) number *= Number(2).pow(scale(engine));
    expect_nearest(number, number.to_double());
    expect_nearest(number, number.to_float());
  }
}

TEST(NumberRounding, IsNearestForRandomIrrationals) {
  std::mt19937_64 engine(8);
  std::uniform_int_distribution<long> part(-1000000, 1000000);
  for (int round = 0; round < 1000; ++round) {
    const Number number = Number::rational(part(engine), 997) + Number::rational(part(engine), 991) * Number::sqrt2() +
                          Number::rational(part(engine), 983) * Number::sqrt3();
    expect_nearest(number, number.to_double());
    expect_nearest(number, number.to_float());
  }
  // Cancellation: 1e40 (√6 − its 60-digit decimal).
  const Number root = Number::sqrt2() * Number::sqrt3();
  const Number rest =
      Number(10).pow(40) * (root - parse_decimal("2.44948974278317809819728407470589139196594748065667012843269"));
  expect_nearest(rest, rest.to_double());
}

TEST(NumberRounding, ResolvesTiesToEven) {
  const Number unit = Number(2).pow(-52);
  for (const int odd : {1, 3, 5, 7}) {
    const Number tie = 1 + unit * Number::rational(odd, 2);
    expect_nearest(tie, tie.to_double());
    EXPECT_EQ(exact(tie.to_double()), 1 + unit * (odd % 4 == 1 ? (odd - 1) / 2 : (odd + 1) / 2));
    EXPECT_EQ((-tie).to_double(), -tie.to_double());
    // A hair off the tie goes to the near side.
    EXPECT_EQ(exact((tie + Number(2).pow(-500)).to_double()), 1 + unit * ((odd + 1) / 2));
    EXPECT_EQ(exact((tie - Number(2).pow(-500)).to_double()), 1 + unit * ((odd - 1) / 2));
  }
}

TEST(NumberRounding, RoundsAFloatOnceAndNotByWayOfDouble) {
  // Just above halfway between two floats: rounding to double first lands on the tie and then goes the wrong way.
  const Number number = 1 + Number(2).pow(-24) + Number(2).pow(-60);
  EXPECT_EQ(exact(number.to_float()), 1 + Number(2).pow(-23));
  EXPECT_EQ(exact(static_cast<float>(number.to_double())), 1);
}

TEST(NumberRounding, KeepsSubnormalsAndOverflowsToInfinity) {
  const Number least = Number(2).pow(-1074);
  EXPECT_EQ(least.to_double(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ((least / 2).to_double(), 0.0);
  EXPECT_EQ((least * Number::rational(51, 100)).to_double(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ((least * Number::rational(3, 2)).to_double(), 2 * std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(Number(10).pow(-400).to_double(), 0.0);
  EXPECT_EQ(Number(2).pow(-149).to_float(), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(Number(10).pow(-50).to_float(), 0.0f);

  const Number largest = (2 - Number(2).pow(-52)) * Number(2).pow(1023);
  EXPECT_EQ(largest.to_double(), std::numeric_limits<double>::max());
  const Number half_unit = Number(2).pow(970);
  EXPECT_EQ((largest + half_unit - 1).to_double(), std::numeric_limits<double>::max());
  EXPECT_EQ((largest + half_unit).to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((-Number(10).pow(400)).to_double(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(Number(10).pow(39).to_float(), std::numeric_limits<float>::infinity());
  std::mt19937_64 engine(9);
  std::uniform_int_distribution<long> part(1, 1L << 40);
  for (int round = 0; round < 1000; ++round) {
    const Number number = Number(part(engine)) * Number(2).pow(-1100);  // from nothing to well above 2^-1074
    expect_nearest(number, number.to_double());
    const Number small = Number(part(engine)) * Number(2).pow(-175);
    expect_nearest(small, small.to_float());
  }
}

TEST(NumberRounding, GivesBackTheDoubleThatADecimalCameFrom) {
  std::mt19937_64 engine(10);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-1070, 1020);
  for (int round = 0; round < 2000; ++round) {
    const double value = std::ldexp(mantissa(engine), exponent(engine));
    EXPECT_EQ(from_double(value).to_double(), value);
  }
}

TEST(NumberRounding, EnclosesWithinTheAskedWidth) {
  const Number number =
      Number::rational(1, 3) - 1000 * Number::sqrt2() + Number::sqrt3() / 7 - 5 * Number::sqrt2() * Number::sqrt3();
  for (const int bits : {10, 64, 300}) {
    const auto [lower, upper] = number.enclosure(bits);
    EXPECT_LT(Number(lower), number);
    EXPECT_GT(Number(upper), number);
    EXPECT_LE(Number(upper) - Number(lower), Number(2).pow(-bits));
  }
}

}  // namespace
}  // namespace torsor::number_rounding_test
