// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// A set [m - r, m + r] that surely contains a number: ball arithmetic, every operation with its own rounding counted
/// (Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, 2017). Works with as many bits
/// as Real::working_digits() takes. Where torsor was built without Arb there are none: available() tells.
class Ball {
 public:
  static bool available();

  Ball(int value = 0);
  static Ball from_double(double value);       ///< exactly
  static Ball of_number(const Number& number);  ///< enclosed
  static Ball pi();

  Ball operator-() const;
  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b);
  friend Ball operator*(const Ball& a, const Ball& b);
  friend Ball operator/(const Ball& a, const Ball& b);  ///< the whole line where b contains 0
  friend Ball sin(const Ball& x);
  friend Ball cos(const Ball& x);
  friend Ball sqrt(const Ball& x);
  friend Ball exp(const Ball& x);
  friend Ball log(const Ball& x);
  friend Ball atan2(const Ball& y, const Ball& x);
  friend Ball abs(const Ball& x);
  /// Where the argument's sign is open, a ball around all that they may be.
  friend Ball sign(const Ball& x);
  friend Ball maximum(const Ball& a, const Ball& b);
  friend Ball select(const Ball& condition, const Ball& a, const Ball& b);

  /// The largest |x| of the ball, rounded up; infinite or not a number where nothing is known.
  double largest() const;
  /// The same of its radius.
  double radius() const;

 private:
  struct Storage;
  explicit Ball(std::shared_ptr<Storage> storage) : storage_(std::move(storage)) {}
  template <class Operation>
  static Ball result(const Operation& operation);

  std::shared_ptr<const Storage> storage_;
};

}  // namespace torsor
