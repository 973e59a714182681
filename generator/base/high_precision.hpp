// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <string>
#include <string_view>

#include <cln/float.h>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// Floating-point number of a fixed precision chosen at construction (decimal digits, at least 20). An operation works
/// at the larger precision of its operands; a default-constructed zero has none of its own and adopts the other's.
/// Construction from float or double does not compile (no double hides in a high-precision computation): use
/// from_double where a double is what is meant.
///
/// Undefined results (division by zero, root of a negative number) are a quiet NaN as in IEEE 754, because generated
/// kernels are noexcept: every comparison with it is false, to_double gives NaN. CLN's exponents have 64 bits: there
/// is no overflow in practice.
class Real {
 public:
  /// Zero that adopts the precision of whatever it meets.
  Real() = default;
  /// Exact integer at the working precision.
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) explicit Real(Integer value) : Real(Number(value), working_digits()) {}
  template <std::floating_point Float>
  Real(Float) = delete;
  /// Nearest value of that precision, rounded once.
  Real(const Number& value, int digits);
  explicit Real(const cln::cl_F& value) : value_(value) {}

  /// The double, exactly (NaN for a double that is not finite).
  static Real from_double(double value, int digits = working_digits());
  /// Nearest value to a decimal text or quotient as read by parse_decimal. Throws Error naming the text.
  static Real parse(std::string_view text, int digits = working_digits());
  /// Nearest value, at the working precision, to a text of the form of Number::to_exact; remembered per thread, since a
  /// generated kernel asks for the same few constants at every call.
  static Real constant(std::string_view exact);
  static Real not_a_number();
  /// π at that precision.
  static Real pi(int digits = working_digits());

  /// Precision used where none is given: 50 unless a WorkingDigits of this thread says otherwise.
  static int working_digits() noexcept;

  bool is_nan() const { return nan_; }
  bool is_zero() const { return !nan_ && cln::zerop(value_); }
  /// Decimal digits this value is guaranteed to carry; 0 for a default-constructed zero.
  int digits() const;
  /// The same value rounded (or extended by zeros) to that precision.
  Real with_digits(int digits) const;
  /// Relative rounding unit of this value's precision.
  Real epsilon() const;
  const cln::cl_F& raw() const { return value_; }

  Real operator-() const;
  Real& operator+=(const Real& other) { return *this = *this + other; }
  Real& operator-=(const Real& other) { return *this = *this - other; }
  Real& operator*=(const Real& other) { return *this = *this * other; }
  Real& operator/=(const Real& other) { return *this = *this / other; }
  friend Real operator+(const Real& left, const Real& right);
  friend Real operator-(const Real& left, const Real& right);
  friend Real operator*(const Real& left, const Real& right);
  friend Real operator/(const Real& left, const Real& right);

  friend bool operator==(const Real& left, const Real& right) { return (left <=> right) == 0; }
  friend std::partial_ordering operator<=>(const Real& left, const Real& right);

  /// Nearest double, ties to even.
  double to_double() const;
  /// Decimal text of that many significant digits, rounded to nearest from the binary value: "-0.083860", "1.5000e-20".
  /// parse_decimal reads it back.
  std::string to_string(int digits) const;
  /// The exact binary value. Throws Error for NaN.
  Number to_number() const;

 private:
  cln::cl_F value_ = cln::cl_F();  // CLN's short-float zero: lies in the word itself, shorter than any other format
  bool nan_ = false;
};

Real abs(const Real& x);
Real sqrt(const Real& x);
Real exp(const Real& x);
Real log(const Real& x);  ///< not a number unless x > 0
Real sin(const Real& angle);
Real cos(const Real& angle);
/// The angle of (x, y) in (−π, π]; 0 of (0, 0).
Real atan2(const Real& y, const Real& x);
/// Both at once, for the cost of little more than one.
void sincos(const Real& angle, Real& sine, Real& cosine);
/// x to an integer power by repeated squaring.
Real pow(const Real& x, int exponent);

/// Sets Real::working_digits() of this thread until the end of the block; blocks may be nested.
class WorkingDigits {
 public:
  explicit WorkingDigits(int digits);
  ~WorkingDigits();
  WorkingDigits(const WorkingDigits&) = delete;
  WorkingDigits& operator=(const WorkingDigits&) = delete;

 private:
  int previous_;
};

}  // namespace torsor
