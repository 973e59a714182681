// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/function_values.hpp"

namespace torsor {

/// A number with its derivatives along some directions, carried by the chain rule (forward differentiation: Griewank &
/// Walther, Evaluating Derivatives, 3.1). `Slopes` holds the derivatives; all zero when default-constructed;
/// `combination(x, a, y, b)` is x a + y b.
template <class Scalar, class Slopes>
class Differential {
 public:
  Differential(Scalar value = 0, Slopes slopes = {}) : value_(value), slopes_(std::move(slopes)) {}

  /// A constant, in `long double` to its last bit.
  static Differential of_number(const Number& number) {
    const double high = number.to_double();
    if constexpr (std::is_same_v<Scalar, double>) {
      return Differential(high);
    } else {
      const Real rest = Real(number, 40) - Real::from_double(high, 40);
      return Differential(static_cast<Scalar>(high) + static_cast<Scalar>(rest.to_double()));
    }
  }

  Scalar value() const { return value_; }
  const Slopes& slopes() const { return slopes_; }

  Differential operator-() const { return chain(-value_, -1); }
  friend Differential operator+(const Differential& a, const Differential& b) {
    return combine(a.value_ + b.value_, {a, 1}, {b, 1});
  }
  friend Differential operator-(const Differential& a, const Differential& b) {
    return combine(a.value_ - b.value_, {a, 1}, {b, -1});
  }
  friend Differential operator*(const Differential& a, const Differential& b) {
    return combine(a.value_ * b.value_, {a, b.value_}, {b, a.value_});
  }
  friend Differential operator/(const Differential& a, const Differential& b) {
    const Scalar quotient = a.value_ / b.value_;
    return combine(quotient, {a, 1 / b.value_}, {b, -quotient / b.value_});
  }

  friend Differential sin(const Differential& x) { return x.chain(std::sin(x.value_), std::cos(x.value_)); }
  friend Differential cos(const Differential& x) { return x.chain(std::cos(x.value_), -std::sin(x.value_)); }
  friend Differential exp(const Differential& x) { return x.chain(std::exp(x.value_), std::exp(x.value_)); }
  friend Differential log(const Differential& x) { return x.chain(std::log(x.value_), 1 / x.value_); }
  friend Differential sqrt(const Differential& x) {
    const Scalar root = std::sqrt(x.value_);
    return x.chain(root, Scalar(0.5) / root);
  }
  friend Differential abs(const Differential& x) { return x.value_ < 0 ? -x : x; }
  friend Differential sign(const Differential& x) { return Differential(torsor::sign(x.value_)); }
  friend Differential maximum(const Differential& a, const Differential& b) { return select(a - b, a, b); }
  friend Differential select(const Differential& condition, const Differential& a, const Differential& b) {
    return condition.value_ >= 0 ? a : condition.value_ < 0 ? b : condition;
  }
  friend Differential atan2(const Differential& y, const Differential& x) {
    const Scalar square = x.value_ * x.value_ + y.value_ * y.value_;
    return combine(std::atan2(y.value_, x.value_), {y, x.value_ / square}, {x, -y.value_ / square});
  }

 private:
  Differential chain(Scalar value, Scalar slope) const {
    return Differential(value, combination(slope, slopes_, Scalar(0), Slopes()));
  }
  /// An argument, and the slope of a value along it.
  struct Along {
    const Differential& argument;
    Scalar slope;
  };
  static Differential combine(Scalar value, const Along& a, const Along& b) {
    return Differential(value, combination(a.slope, a.argument.slopes_, b.slope, b.argument.slopes_));
  }

  Scalar value_;
  Slopes slopes_;
};

}  // namespace torsor
