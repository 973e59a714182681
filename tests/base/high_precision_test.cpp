// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/high_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"

// Stands for the head of a generated header, which declares this template; the specialisation below needs no more of
// it.
#define TORSOR_KERNEL_SUPPORT 1
namespace torsor {
template <class Scalar>
struct scalar_traits;
}

#include "torsor/generator/verification/real_scalar_traits.hpp"

namespace torsor::high_precision_test {
namespace {

// Digits written here come from tables (π, sin 1, cos 1, √2 to 60 places), not from the library under test.
constexpr const char* pi_60 = "3.14159265358979323846264338327950288419716939937510582097494";
constexpr const char* sin_1 = "0.841470984807896506652502321630298999622563060798371065672752";
constexpr const char* cos_1 = "0.540302305868139717400936607442976603732310420617922227670097";
constexpr const char* e_60 = "2.71828182845904523536028747135266249775724709369995957496697";
constexpr const char* log_2 = "0.693147180559945309417232121458176568075500134360255254120680";
constexpr const char* sqrt_2 = "1.41421356237309504880168872420969807856967187537694807317668";

/// 10^-digits, the bound of a difference that agrees to that many places.
Real place(int digits) { return Real(Number(10).pow(-digits), 60); }

void expect_near(const Real& value, const Real& expected, const Real& bound) {
  EXPECT_LE(abs(value - expected), bound) << value.to_string(60) << " instead of " << expected.to_string(60);
}

TEST(HighPrecision, IsNotMadeFromFloatingPointBySilentConversion) {
  static_assert(!std::is_constructible_v<Real, double> && !std::is_constructible_v<Real, float>);
  static_assert(std::is_constructible_v<Real, int> && !std::is_convertible_v<int, Real>);
  static_assert(!std::is_convertible_v<Number, Real>);
  EXPECT_EQ(Real::from_double(0.1).to_number(), Number(3602879701896397) / Number(2).pow(55));
}

TEST(HighPrecision, WorksAtTheLargerPrecisionOfItsOperands) {
  const Real coarse(Number::rational(1, 3), 30);
  const Real fine(Number::rational(1, 3), 90);
  EXPECT_GE(coarse.digits(), 30);
  EXPECT_GE(fine.digits(), 90);
  for (const Real& result : {coarse + fine, fine - coarse, coarse * fine, fine / coarse}) {
    EXPECT_EQ(result.digits(), fine.digits());
  }
  EXPECT_LT(coarse, coarse + fine.epsilon() * coarse.with_digits(90));
}

TEST(HighPrecision, AdoptsAPrecisionWhenDefaultConstructed) {
  const Real third(Number::rational(1, 3), 70);
  Real sum;
  EXPECT_EQ(sum.digits(), 0);
  EXPECT_TRUE(sum.is_zero());
  sum += third;
  EXPECT_EQ(sum.digits(), third.digits());
  EXPECT_EQ(sum, third);
  EXPECT_EQ((Real() * third).digits(), third.digits());
  EXPECT_EQ(Real() - third, -third);
  EXPECT_TRUE((third - third).is_zero());
  EXPECT_EQ((third - third).digits(), third.digits());
  EXPECT_EQ(cos(Real()), Real(1));
  EXPECT_EQ(exp(Real()), Real(1));
  EXPECT_EQ(cos(Real()).digits(), Real(1).digits());
}

TEST(HighPrecision, TakesItsPrecisionFromTheInnermostBlock) {
  const int before = Real::working_digits();
  {
    const WorkingDigits outer(100);
    EXPECT_EQ(Real::working_digits(), 100);
    EXPECT_GE(Real(1).digits(), 100);
    {
      const WorkingDigits inner(30);
      EXPECT_EQ(Real::working_digits(), 30);
    }
    EXPECT_EQ(Real::working_digits(), 100);
  }
  EXPECT_EQ(Real::working_digits(), before);
  EXPECT_THROW(WorkingDigits(0), UsageError);
  EXPECT_EQ(Real::working_digits(), before);
}

TEST(HighPrecision, MatchesTabulatedConstants) {
  // The tables are cut after 59 or 60 places.
  expect_near(Real::pi(60), Real::parse(pi_60, 60), place(58));
  expect_near(sin(Real(Number(1), 60)), Real::parse(sin_1, 60), place(59));
  expect_near(cos(Real(Number(1), 60)), Real::parse(cos_1, 60), place(59));
  expect_near(exp(Real(Number(1), 60)), Real::parse(e_60, 60), place(58));
  expect_near(log(Real(Number(2), 60)), Real::parse(log_2, 60), place(59));
  expect_near(sqrt(Real(Number(2), 60)), Real::parse(sqrt_2, 60), place(58));
  expect_near(Real(Number::sqrt2(), 60), Real::parse(sqrt_2, 60), place(58));
}

TEST(HighPrecision, KeepsTheIdentitiesOfItsFunctions) {
  std::mt19937_64 engine(4);
  std::uniform_int_distribution<long> part(-1000000, 1000000);
  for (int round = 0; round < 200; ++round) {
    const Real x(Number::rational(part(engine), 99991), 50);
    const Real y(Number::rational(part(engine), 99989), 50);
    // Each of the few operations is within some rounding units of values below 1 (of |x| + |y| < 21 for the angle).
    const Real bound = x.epsilon() * Real(100);
    Real sine, cosine;
    sincos(x, sine, cosine);
    EXPECT_EQ(sine, sin(x));
    EXPECT_EQ(cosine, cos(x));
    expect_near(sine * sine + cosine * cosine, Real(1), bound);
    expect_near(sin(x + y), sine * cos(y) + cosine * sin(y), bound);
    expect_near(sqrt(x * x), abs(x), bound * abs(x));
    expect_near(exp(x) * exp(y), exp(x + y), bound * exp(x + y));
    expect_near(log(exp(x)), x, bound);
    if (!y.is_zero()) expect_near(x / y * y, x, bound * abs(x));
    expect_near((x + y) * (x - y), x * x - y * y, bound * (x * x + y * y));
  }
}

TEST(HighPrecision, KeepsRelativeAccuracyOfSmallSines) {
  // sin x = x − x³/6 + ..., and x⁵ is far below the 50 digits at x = 10^-20.
  const Real x(Number(10).pow(-20), 50);
  expect_near(sin(x) / x, Real(1) - x * x / Real(6), x.epsilon() * Real(4));
}

TEST(HighPrecision, AllowsAnArgumentToBeAResult) {
  Real angle(Number(1), 50), cosine;
  sincos(angle, angle, cosine);
  EXPECT_EQ(angle, sin(Real(Number(1), 50)));
  EXPECT_EQ(cosine, cos(Real(Number(1), 50)));
  const Real& itself = angle;
  angle += itself;
  EXPECT_EQ(angle, Real(2) * sin(Real(Number(1), 50)));
  angle -= itself;
  EXPECT_TRUE(angle.is_zero());
}

TEST(HighPrecision, IsQuietlyUndefinedWhereMathematicsIs) {
  const Real nan = Real(1) / Real(0);
  for (const Real& value : {nan, sqrt(Real(-1)), log(Real(-1)), log(Real(0)), exp(nan), nan + Real(1), -nan,
                            nan * Real(0), sin(nan), abs(nan), pow(Real(0), -1)}) {
    EXPECT_TRUE(value.is_nan());
    EXPECT_FALSE(value == value);
    EXPECT_FALSE(value < Real(1));
    EXPECT_FALSE(value >= Real(1));
    EXPECT_TRUE(std::isnan(value.to_double()));
    EXPECT_EQ(value.to_string(5), "nan");
  }
  EXPECT_TRUE(Real::from_double(std::numeric_limits<double>::infinity()).is_nan());
  EXPECT_THROW(nan.to_number(), Error);
  Real sine, cosine;
  sincos(nan, sine, cosine);
  EXPECT_TRUE(sine.is_nan() && cosine.is_nan());
  EXPECT_TRUE(sqrt(Real(0)).is_zero());
}

TEST(HighPrecision, IsOrderedLikeItsValues) {
  EXPECT_LT(Real(-2), Real(1));
  EXPECT_GT(Real(3), Real());
  EXPECT_EQ(Real(), Real(0));
  EXPECT_LE(Real(2), Real(Number(2), 100));
  EXPECT_NE(Real(Number::rational(1, 3), 30), Real(Number::rational(1, 3), 60));
}

TEST(HighPrecision, RoundsAnExactNumberToTheNearestValue) {
  std::mt19937_64 engine(5);
  std::uniform_int_distribution<long> part(-1000000, 1000000);
  for (int round = 0; round < 300; ++round) {
    const Number exact = Number::rational(part(engine), 977) + Number::rational(part(engine), 971) * Number::sqrt2() +
                         Number::rational(part(engine), 967) * Number::sqrt3();
    const Real rounded(exact, 40);
    // Nearest: the error is at most half a unit in the last place, epsilon times the next power of two above.
    const Number error = (rounded.to_number() - exact).abs();
    EXPECT_LE(error, (rounded.epsilon().to_number() * exact).abs()) << exact.to_string();
  }
}

TEST(HighPrecision, GivesTheNearestDouble) {
  EXPECT_EQ(Real(Number::rational(1, 3), 50).to_double(), 1.0 / 3.0);
  EXPECT_EQ(Real::pi(50).to_double(), 3.14159265358979323846);
  EXPECT_EQ((-Real::parse("1e-400")).to_double(), 0.0);
  EXPECT_EQ(Real::parse("-1e400").to_double(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(Real::parse("5e-324").to_double(), 5e-324);
  EXPECT_EQ(Real().to_double(), 0.0);
  const Real huge = pow(Real(10), 100000000);
  EXPECT_EQ(huge.to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((Real(1) / huge).to_double(), 0.0);
  for (const double value : {0.1, -9.81, 1e-310, 1.7e308, 5e-324})
    EXPECT_EQ(Real::from_double(value).to_double(), value);
}

TEST(HighPrecision, IsPrintedToTheAskedDigits) {
  EXPECT_EQ(Real::parse("-0.083860420405").to_string(5), "-0.083860");
  EXPECT_EQ(Real::parse("-0.083860420405").to_string(12), "-0.0838604204050");
  EXPECT_EQ(Real(Number::rational(2, 3), 50).to_string(20), "0.66666666666666666667");
  EXPECT_EQ(Real::parse("9.9996").to_string(4), "10.00");
  EXPECT_EQ(Real(1234).to_string(4), "1234");
  EXPECT_EQ(Real(1234).to_string(6), "1234.00");
  EXPECT_EQ(Real(1234).to_string(2), "1.2e+3");
  EXPECT_EQ(Real::parse("1.5e-20").to_string(5), "1.5000e-20");
  EXPECT_EQ(Real(5).to_string(1), "5");
  EXPECT_EQ(Real().to_string(3), "0.00");
  EXPECT_THROW(Real(1).to_string(0), UsageError);
  std::mt19937_64 engine(6);
  std::uniform_int_distribution<long> part(-1000000000, 1000000000);
  std::uniform_int_distribution<int> exponent(-40, 40);
  for (int round = 0; round < 500; ++round) {
    const Real value(Number::rational(part(engine), 999983) * Number(10).pow(exponent(engine)), 50);
    const Number back = parse_decimal(value.to_string(30));
    // Half a unit of the 30th digit is at most 5e-30 of the value.
    EXPECT_LE((back - value.to_number()).abs(), (value.to_number() * 5).abs() * Number(10).pow(-30));
  }
}

TEST(HighPrecision, RefusesATextThatIsNoNumber) {
  EXPECT_THROW(Real::parse("1.5x"), Error);
  EXPECT_THROW(Real(Number(1), 0), UsageError);
}

TEST(HighPrecision, RaisesToIntegerPowers) {
  EXPECT_EQ(pow(Real(3), 5), Real(243));
  EXPECT_EQ(pow(Real(2), -3), Real(Number::rational(1, 8), 50));
  EXPECT_EQ(pow(Real(7), 0), Real(1));
}

TEST(RealScalarTraits, TakesConstantsFromTheExactTextAlone) {
  using Traits = scalar_traits<Real>;
  {
    const WorkingDigits digits(40);
    EXPECT_EQ(Traits::constant(99.0, 99.0f, "1/3"), Real(Number::rational(1, 3), 40));
    EXPECT_EQ(Traits::constant(99.0, 99.0f, "0;1/2;0;0"), Real(Number::sqrt2() / 2, 40));
  }
  {
    const WorkingDigits digits(80);  // the constants of 40 digits must not be found again
    EXPECT_EQ(Traits::constant(99.0, 99.0f, "1/3"), Real(Number::rational(1, 3), 80));
    EXPECT_EQ(Traits::constant(99.0, 99.0f, "1/3"), Real(Number::rational(1, 3), 80));
  }
  EXPECT_THROW(Real::constant("0.5"), Error);
}

TEST(RealScalarTraits, SelectsAndTellsRegularPivots) {
  using Traits = scalar_traits<Real>;
  EXPECT_EQ(Traits::select(true, Real(1), Real(2)), Real(1));
  EXPECT_EQ(Traits::select(false, Real(1), Real(2)), Real(2));
  EXPECT_TRUE(Traits::regular(Real(1), Real(-5)));
  EXPECT_FALSE(Traits::regular(Real(1).epsilon(), Real(2)));
  EXPECT_FALSE(Traits::regular(Real(0), Real(0)));
  EXPECT_FALSE(Traits::regular(Real(-1), Real(1)));
  EXPECT_TRUE(Traits::regular(Real::not_a_number(), Real(1))) << "results tell";
  EXPECT_TRUE(Traits::finite(Real(1)));
  EXPECT_FALSE(Traits::finite(Real::not_a_number()));
}

}  // namespace
}  // namespace torsor::high_precision_test
