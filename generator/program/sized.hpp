// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// A number with what its terms come to without their signs: what cancels is told from what is small.
struct Sized {
  Real value, size;

  Sized() = default;
  /// Sizes that multiply along a long elimination leave even CLN's exponents; nothing asks how far beyond one they are.
  Sized(Real v, Real s) : value(std::move(v)), size(huge() < s ? huge() : std::move(s)) {}
  explicit Sized(const Real& v) : value(v), size(abs(v)) {}
  static Sized of_number(const Number& number) { return Sized(Real(number, Real::working_digits())); }
  static const Real& huge() {
    static const Real number(Number(10).pow(1000), 60);
    return number;
  }

  Sized operator-() const { return {-value, size}; }
  friend Sized operator+(const Sized& a, const Sized& b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator-(const Sized& a, const Sized& b) { return {a.value - b.value, a.size + b.size}; }
  friend Sized operator*(const Sized& a, const Sized& b) { return {a.value * b.value, a.size * b.size}; }
  friend Sized operator/(const Sized& a, const Sized& b) { return {a.value / b.value, a.size / abs(b.value)}; }
  friend Sized sin(const Sized& x) { return {sin(x.value), x.size < Real(1) ? x.size : Real(1)}; }
  friend Sized cos(const Sized& x) { return {cos(x.value), Real(1)}; }
  friend Sized sqrt(const Sized& x) { return {sqrt(x.value), sqrt(x.size)}; }
  friend Sized exp(const Sized& x) { return Sized(exp(x.value)); }
  friend Sized log(const Sized& x) { return {log(x.value), Real(1) + abs(log(x.value))}; }
  friend Sized atan2(const Sized& y, const Sized& x) { return Sized(atan2(y.value, x.value)); }
  friend Sized abs(const Sized& x) { return {abs(x.value), x.size}; }
  friend Sized sign(const Sized& x) { return Sized(sign(x.value)); }
  friend Sized maximum(const Sized& a, const Sized& b) { return a.value >= b.value ? a : b; }
  friend Sized select(const Sized& c, const Sized& a, const Sized& b) { return c.value >= Real(0) ? a : b; }

  /// Whether nothing but rounding is left of the terms: decimals whose sum is 0 are not exact in binary.
  bool cancels() const {
    return abs(value) <= Real(1'000'000) * Real(1).epsilon() * size;
  }
  bool is_number() const { return !value.is_nan() && !size.is_nan(); }
};

}  // namespace torsor
