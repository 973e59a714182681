// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/function_values.hpp"
#include "torsor/generator/verification/emitted_sincos.hpp"

namespace torsor {

/// A number as a generated header computes it, with a bound of its error: running error analysis (Wilkinson 1986;
/// Higham, Accuracy and Stability of Numerical Algorithms, 3.3). Each rounding to nearest adds u|z|, u = ε/2, z the
/// result; a product or quotient that underflows, the least subnormal number. Errors of operands go through to all
/// orders, so that the bound holds without any "if errors are small"; it is infinite where a divisor may vanish.
///
/// Bounds are computed in double and rounded up: what an operation adds consists of at most 8 roundings of terms that
/// are not negative, 8 · 2^-53 < 2^-49. A fused multiply-add leaves out one of the roundings: the bound holds for it too.
template <class Float>
class Running {
 public:
  Running(Float value = 0, double bound = 0) : value_(value), bound_(bound) {}
  Running(int whole) : Running(static_cast<Float>(whole)) {}  ///< a small one: exact

  /// A literal of a header: the number rounded once.
  static Running of_number(const Number& number) {
    const Float value = rounded(number);
    const bool exact = std::isfinite(value) && Real::from_double(value, 40).to_number() == number;
    return Running(value, exact ? 0 : up(unit * size(value) + tiny));
  }
  /// A literal of a header whose exact value is not at hand.
  static Running rounded_literal(Float value) { return Running(value, up(unit * size(value) + tiny)); }

  Float value() const { return value_; }
  double bound() const { return bound_; }

  Running operator-() const { return Running(-value_, bound_); }
  friend Running operator+(const Running& a, const Running& b) { return sum(a.value_ + b.value_, a, b); }
  friend Running operator-(const Running& a, const Running& b) { return sum(a.value_ - b.value_, a, b); }
  friend Running operator*(const Running& a, const Running& b) {
    const Float z = a.value_ * b.value_;
    return Running(z, up(size(a.value_) * b.bound_ + size(b.value_) * a.bound_ + a.bound_ * b.bound_ + unit * size(z) +
                         tiny));
  }
  friend Running operator/(const Running& a, const Running& b) {
    const Float z = a.value_ / b.value_;
    const double least = size(b.value_) - b.bound_;  // of the exact divisor
    if (!(least > 0)) return Running(z, std::numeric_limits<double>::infinity());
    const double rounding = up(unit * size(z) + tiny);
    // â/b̂ - a/b = ((â - a) - (â/b̂)(b̂ - b))/b, and |â/b̂| <= |z| + its rounding
    return Running(z, up((a.bound_ + (size(z) + rounding) * b.bound_) / (least * (1 - 0x1p-52)) + rounding));
  }

  friend Running sin(const Running& x) { return turned(x, true); }
  friend Running cos(const Running& x) { return turned(x, false); }
  friend Running sqrt(const Running& x) {
    const Float z = std::sqrt(x.value_);
    const double lower = std::max(0.0, (size(x.value_) - x.bound_) * (1 - 0x1p-52));
    // √â - √a = (â - a)/(√â + √a), and at most √|â - a|
    const double slope = (1 - 4 * unit) * size(z) + std::sqrt(lower) * (1 - 0x1p-52);
    const double through = x.bound_ == 0 ? 0 : std::min(x.bound_ / slope, std::sqrt(x.bound_) * (1 + 0x1p-52));
    return Running(z, up(through + unit * size(z)));
  }
  // The C library's own error is 1 ulp, ulp <= 2 u |z|; twice that is allowed.
  friend Running exp(const Running& x) {
    const Float z = std::exp(x.value_);
    const double library = 4 * unit * size(z) + tiny;
    return Running(z, up((size(z) + library) * std::expm1(x.bound_) * (1 + 0x1p-50) + library));
  }
  friend Running log(const Running& x) {
    const Float z = std::log(x.value_);
    const double least = size(x.value_) - x.bound_;
    if (!(least > 0)) return Running(z, std::numeric_limits<double>::infinity());
    return Running(z, up(x.bound_ / (least * (1 - 0x1p-52)) + 4 * unit * size(z) + tiny));
  }
  friend Running abs(const Running& x) { return Running(std::abs(x.value_), x.bound_); }
  // |max(a, b) - max(a', b')| <= max(|a - a'|, |b - b'|)
  friend Running maximum(const Running& a, const Running& b) {
    return Running(torsor::maximum(a.value_, b.value_), std::max(a.bound_, b.bound_));
  }
  // Where the errors leave it open which form is the exact one, the other is as far away as both are apart.
  friend Running sign(const Running& x) {
    return Running(torsor::sign(x.value_), x.bound_ == 0 || size(x.value_) > x.bound_ ? 0 : 2);
  }
  friend Running select(const Running& condition, const Running& a, const Running& b) {
    const Running& taken = condition.value_ < 0 ? b : a;
    if (condition.bound_ == 0 || size(condition.value_) > condition.bound_) return taken;
    const double apart = std::abs(static_cast<double>(a.value_) - static_cast<double>(b.value_));
    return Running(taken.value_, up(apart + std::max(a.bound_, b.bound_)));
  }
  // A vector of length r that moves by d < r turns by asin(d/r) <= (pi/2) d/r, and by a whole turn more across the cut;
  // the header's own error is 2 ulp.
  friend Running atan2(const Running& y, const Running& x) {
    const Float z = emitted_arctangent(y.value_, x.value_);
    const double own = up(4 * unit * size(z) + tiny);
    const double moved = up(std::hypot(x.bound_, y.bound_));
    const double length = std::hypot(size(x.value_), size(y.value_)) * (1 - 0x1p-50);
    const bool cut = moved > 0 && size(y.value_) <= y.bound_ && static_cast<double>(x.value_) - x.bound_ < 0;
    if (cut || (moved > 0 && !(moved < length))) return Running(z, 6.2832 + own);
    return Running(z, up(moved == 0 ? own : 1.5708 * moved / length + own));
  }

 private:
  static constexpr double unit = static_cast<double>(std::numeric_limits<Float>::epsilon()) / 2;
  static constexpr double tiny = static_cast<double>(std::numeric_limits<Float>::denorm_min());

  static double size(Float value) { return std::abs(static_cast<double>(value)); }
  static double up(double bound) {
    // Also beyond what was lost by underflow of the bound's own terms.
    if (std::isnan(bound)) return std::numeric_limits<double>::infinity();  // of infinite terms
    return bound == 0 ? 0 : bound * (1 + 0x1p-49) + 16 * std::numeric_limits<double>::denorm_min();
  }
  static Float rounded(const Number& number) {
    if constexpr (std::is_same_v<Float, float>) {
      return number.to_float();
    } else {
      return number.to_double();
    }
  }
  static Running sum(Float z, const Running& a, const Running& b) {
    return Running(z, up(a.bound_ + b.bound_ + unit * size(z)));
  }
  /// |sin(x + e) - sin(x)| <= |cos x| e + e²/2 and <= 2; the header's own error is 1 ulp.
  static Running turned(const Running& x, bool sine) {
    Float s = 0, c = 0;
    emitted_sincos(x.value_, s, c);
    if (!sine) std::swap(s, c);
    const double own = 2 * unit * size(s) + tiny;
    const double slope = size(c) * (1 + 4 * unit) + tiny;
    return Running(s, up(std::min(2.0, slope * x.bound_ + x.bound_ * x.bound_ / 2) + own));
  }

  Float value_;
  double bound_;
};

}  // namespace torsor
