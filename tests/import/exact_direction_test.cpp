// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/exact_direction.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/high_precision.hpp"

namespace torsor::exact_direction_test {
namespace {

const Number tolerance = Number::rational(1, 1000000000);

Real real(const Number& value) { return Real(value, 60); }

TEST(ExactAngle, TakesWhatLiesWithinTheToleranceForAMultipleOfPiOverTwelve) {
  EXPECT_EQ(twelfths_of_pi(parse_decimal("1.5707963267948966"), tolerance), Number(6));
  EXPECT_EQ(twelfths_of_pi(parse_decimal("-1.57079633"), Number::rational(1, 100000000)), Number(-6));
  EXPECT_EQ(twelfths_of_pi(parse_decimal("0"), Number()), Number(0));
  EXPECT_EQ(twelfths_of_pi(parse_decimal("6.283185307179586"), tolerance), Number(24));
  EXPECT_EQ(twelfths_of_pi(parse_decimal("1.5708"), tolerance), std::nullopt);
  EXPECT_EQ(twelfths_of_pi(parse_decimal("1.5708"), parse_decimal("1e-5")), Number(6));
  // π/12 = 0.26179938779914943654: on either side of 10⁻⁹ from it.
  EXPECT_EQ(twelfths_of_pi(parse_decimal("0.26179938879914943"), tolerance), Number(1));
  EXPECT_EQ(twelfths_of_pi(parse_decimal("0.26179938879914944"), tolerance), std::nullopt);
}

TEST(ExactAngle, LiesOnTheUnitCircleExactlyAndWithinTwoInTenToTheEighteen) {
  const WorkingDigits precision(60);
  for (const char* text : {"0.3", "-0.2", "1.5707", "1.571", "3", "-3.1", "4", "100.25", "1e-8", "-0.78", "0.7853"}) {
    SCOPED_TRACE(text);
    const Number given = parse_decimal(text);
    const ExactAngle angle = exact_angle(given, tolerance);
    EXPECT_FALSE(angle.twelfths);
    EXPECT_TRUE((angle.sine * angle.sine + angle.cosine * angle.cosine).is_one());
    EXPECT_TRUE(angle.sine.is_rational());
    // Both within the error of the angle; relative to the angle where it is small.
    const double size = std::min(1.0, given.abs().to_double());
    EXPECT_LE(abs(real(angle.sine) - sin(real(given))).to_double(), 2e-18 * size);
    EXPECT_LE(abs(real(angle.cosine) - cos(real(given))).to_double(), 2e-18 * size);
    // Short: t has a denominator of some ten digits, cosine and sine its square.
    EXPECT_LE(angle.cosine.to_exact().size(), 90U);
  }
}

TEST(ExactDirection, KeepsZerosAndUnitLength) {
  struct Case {
    std::array<const char*, 3> given;
    bool changed;
  };
  for (const Case& each : std::vector<Case>{{{"0", "0", "1"}, false},
                                            {{"0", "-3", "0"}, false},
                                            {{"1", "6e-17", "0"}, true},
                                            {{"0.6", "0.8", "0"}, false},
                                            {{"1", "1", "0"}, false},
                                            {{"0.7071067811865475", "0", "-0.7071067811865476"}, true},
                                            {{"0.8660254037844386", "0.5", "0"}, true},
                                            {{"1", "1", "1"}, false},
                                            {{"0.57735026919", "-0.57735026919", "0.57735026918"}, true},
                                            {{"1", "2", "2"}, false},
                                            {{"1", "2", "3"}, false},
                                            {{"0", "2", "-3"}, false},
                                            {{"-0.01", "0.5", "-0.2"}, false},
                                            {{"1e-200", "2e-200", "-3e-200"}, false}}) {
    SCOPED_TRACE(each.given[0] + std::string(" ") + each.given[1] + " " + each.given[2]);
    const std::array<Number, 3> v{parse_decimal(each.given[0]), parse_decimal(each.given[1]),
                                  parse_decimal(each.given[2])};
    const ExactDirection direction = exact_direction(v, tolerance);
    const auto& n = direction.components;
    EXPECT_TRUE((n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).is_one());
    EXPECT_EQ(direction.changed, each.changed);
    const Real norm = sqrt(real(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    // What is changed stays within the tolerance; the rational point is good to 10⁻¹⁸.
    const double bound = each.changed ? 2e-9 : 4e-18;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(abs(real(n[i]) - real(v[i]) / norm).to_double(), bound);
      EXPECT_TRUE(n[i].is_zero() || !v[i].is_zero());
    }
  }
  EXPECT_EQ(exact_direction({Number(1), Number(1), Number()}, tolerance).components[0], Number::sqrt2() / Number(2));
  EXPECT_TRUE(exact_direction({Number(1), parse_decimal("6e-17"), Number()}, tolerance).components[1].is_zero());
}

TEST(ExactDirection, IsTheThirdColumnOfTheRotationToIt) {
  for (const std::array<int, 3>& v : std::vector<std::array<int, 3>>{{0, 0, 1},
                                                                     {1, 0, 0},
                                                                     {0, 1, 0},
                                                                     {0, 0, -1},
                                                                     {-1, 0, 0},
                                                                     {0, -1, 0},
                                                                     {1, 2, 2},
                                                                     {1, 2, 3},
                                                                     {-3, 0, -4},
                                                                     {1, 1, 1}}) {
    const auto n = exact_direction({Number(v[0]), Number(v[1]), Number(v[2])}, tolerance).components;
    const Rotation rotation = rotation_to(n);  // refuses what is no rotation
    for (int i = 0; i < 3; ++i) EXPECT_EQ(rotation(i, 2), n[static_cast<std::size_t>(i)]);
  }
  EXPECT_TRUE(rotation_to({Number(), Number(), Number(1)}).is_identity());
}

}  // namespace
}  // namespace torsor::exact_direction_test
