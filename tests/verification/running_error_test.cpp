// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/running_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace torsor::running_error_test {
namespace {

/// The same chain of operations on any scalar.
template <class Scalar>
Scalar chain(const Scalar& a, const Scalar& b, const Scalar& third, int shape) {
  const Scalar sum = a + b * third, difference = a * a - b * b;
  switch (shape) {
    case 0: return sum * difference - third;
    case 1: return difference / (a - b);
    case 2: return sqrt(sum * sum + difference * difference) - sum;
    case 3: return sin(sum) * cos(difference) - third;
    case 4: return log(exp(sin(a)) + sqrt(third)) / sum;
    default: return -(difference - sum) / (sum * sum);
  }
}

template <class Float>
void expect_bounded() {
  const WorkingDigits digits(60);
  std::mt19937_64 random(5);
  int finite = 0;
  for (int k = 0; k < 600; ++k) {
    const auto draw = [&] {
      const double size = std::ldexp(static_cast<double>(random() >> 11U) * 0x1p-53, static_cast<int>(random() % 9) - 4);
      return static_cast<Float>(random() % 2 == 0 ? size : -size);
    };
    const Float x = draw();
    const Float y = k % 3 == 0 ? x * (1 + 7 * std::numeric_limits<Float>::epsilon()) : draw();  // a - b cancels
    using R = Running<Float>;
    const R computed = chain(R(x), R(y), R::of_number(Number::rational(1, 3)), k % 6);
    const Real exact = chain(Real::from_double(static_cast<double>(x)), Real::from_double(static_cast<double>(y)),
                             Real(Number::rational(1, 3), 60), k % 6);
    if (!std::isfinite(computed.bound())) continue;
    ++finite;
    const Real error = abs(Real::from_double(static_cast<double>(computed.value())) - exact);
    EXPECT_LE(error, Real::from_double(computed.bound())) << "state " << k;
  }
  EXPECT_GT(finite, 550);
}

TEST(RunningError, BoundsTheErrorInDouble) { expect_bounded<double>(); }
TEST(RunningError, BoundsTheErrorInFloat) { expect_bounded<float>(); }

TEST(RunningError, KnowsExactLiteralsAndInfiniteQuotients) {
  using R = Running<double>;
  EXPECT_EQ(R::of_number(Number::rational(3, 8)).bound(), 0.0);
  // 1/3 is rounded by 2^-54 of 2/3
  EXPECT_GE(R::of_number(Number::rational(1, 3)).bound(), 1.0 / 3 * 0x1p-54);
  EXPECT_LE(R::of_number(Number::rational(1, 3)).bound(), 1.0 / 3 * 0x1p-52);
  const R third = R::of_number(Number::rational(1, 3));
  EXPECT_TRUE(std::isinf((R(1) / (third - R(1.0 / 3))).bound()));
  EXPECT_EQ(sqrt(R(0)).bound(), 0.0);
  EXPECT_EQ((R(2) + R(0.5)).bound() > 0, true);  // it does not know that this sum is exact
}

/// Products of the least numbers underflow: what is lost is less than the least of them.
TEST(RunningError, CountsUnderflow) {
  using R = Running<float>;
  const R product = R(1e-30F) * R(1e-30F);
  EXPECT_EQ(product.value(), 0.0F);
  EXPECT_GE(product.bound(), 1e-60);
  EXPECT_LE(product.bound(), 1e-44);
}

}  // namespace
}  // namespace torsor::running_error_test
