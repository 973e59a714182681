// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>

#ifndef TORSOR_KERNEL_SUPPORT
#error "include a generated header before tests/batch/bounded.hpp"
#endif

/// A value with a bound of what rounding may have done to it (running error analysis; Higham, Accuracy and Stability of
/// Numerical Algorithms, 3.3): with u = 2^-53 or 2^-24 for every operation, fused or not, and an ulp for sines and
/// cosines. Kept in double: values of float kernels are computed here with errors of 2^-53, far below their bound.
template <bool in_float>
struct Bounded {
  static constexpr double unit = in_float ? 0x1p-24 : 0x1p-53;
  double value = 0, bound = 0;

  static Bounded rounded(double value, double bound) { return {value, (bound + unit * std::abs(value)) * (1 + 1e-10)}; }
  friend Bounded operator+(Bounded a, Bounded b) { return rounded(a.value + b.value, a.bound + b.bound); }
  friend Bounded operator-(Bounded a, Bounded b) { return rounded(a.value - b.value, a.bound + b.bound); }
  friend Bounded operator*(Bounded a, Bounded b) {
    return rounded(a.value * b.value, std::abs(a.value) * b.bound + a.bound * std::abs(b.value) + a.bound * b.bound);
  }
  friend Bounded operator/(Bounded a, Bounded b) {
    const double quotient = a.value / b.value;
    return rounded(quotient, (a.bound + std::abs(quotient) * b.bound) / (std::abs(b.value) - b.bound));
  }
  friend Bounded operator-(Bounded a) { return {-a.value, a.bound}; }
};

namespace torsor {

template <bool in_float>
struct scalar_traits<Bounded<in_float>> {
  using Scalar = Bounded<in_float>;
  static Scalar constant(double in_double, float, const char*) noexcept { return Scalar::rounded(in_double, 0); }
  static void sincos(const Scalar& angle, Scalar& sine, Scalar& cosine) noexcept {
    sine = {std::sin(angle.value), angle.bound + 2 * Scalar::unit};
    cosine = {std::cos(angle.value), angle.bound + 2 * Scalar::unit};
  }
  static bool regular(const Scalar& pivot, const Scalar& diagonal) noexcept {
    return !(pivot.value <= 2 * Scalar::unit * std::abs(diagonal.value));
  }
  static bool finite(const Scalar& x) noexcept { return std::isfinite(x.value); }
};

}  // namespace torsor
