// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <cln/integer.h>
#include <cln/rational.h>

namespace torsor {

/// An exact constant a + b√2 + c√3 + d√6 with rational a, b, c, d: an element of the field Q(√2, √3), which holds the
/// sines and cosines of all multiples of π/12. 1, √2, √3, √6 are linearly independent over Q, hence a number is zero
/// exactly when its four parts are, and sign, order and rounding are decidable. No floating-point number ever enters:
/// construction from float or double does not compile; see decimal.hpp.
class Number {
 public:
  Number() = default;
  // Copying a part of CLN's counts a reference and never fails: vectors of terms move when they grow.
  Number(const Number&) noexcept = default;
  Number(Number&&) noexcept = default;
  Number& operator=(const Number&) noexcept = default;
  Number& operator=(Number&&) noexcept = default;
  ~Number() = default;
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) Number(Integer value) : parts_{cln::cl_RA(cln::cl_I(value)), 0, 0, 0} {}
  Number(const cln::cl_RA& value) : parts_{value, 0, 0, 0} {}
  template <std::floating_point Float>
  Number(Float) = delete;

  /// numerator / denominator, reduced. Throws Error when the denominator is zero.
  static Number rational(long numerator, long denominator);
  /// a + b√2 + c√3 + d√6.
  static Number from_parts(const cln::cl_RA& a, const cln::cl_RA& b, const cln::cl_RA& c, const cln::cl_RA& d);
  static Number sqrt2();
  static Number sqrt3();

  /// Coefficient of 1, √2, √3, √6 for index 0, 1, 2, 3.
  const cln::cl_RA& part(int index) const;

  bool is_zero() const { return is_small(parts_[0], 0) && is_rational(); }
  bool is_one() const { return is_small(parts_[0], 1) && is_rational(); }
  bool is_rational() const { return is_small(parts_[1], 0) && is_small(parts_[2], 0) && is_small(parts_[3], 0); }
  bool is_integer() const;
  /// -1, 0 or 1: the true sign, by enclosures of growing precision once the number is known not to be zero.
  int sign() const;
  Number abs() const;

  Number operator-() const;
  Number& operator+=(const Number& other);
  Number& operator-=(const Number& other);
  Number& operator*=(const Number& other);
  /// Throws Error when the divisor is zero.
  Number& operator/=(const Number& other);
  friend Number operator+(Number left, const Number& right) { return left += right; }
  friend Number operator-(Number left, const Number& right) { return left -= right; }
  friend Number operator*(Number left, const Number& right) { return left *= right; }
  friend Number operator/(Number left, const Number& right) { return left /= right; }

  /// Integer power by repeated squaring; pow(0) is 1. Throws Error for a negative power of zero.
  Number pow(int exponent) const;

  /// The non-negative root where it lies in Q(√2, √3) (4/9, 2, 3/4, 6, 2+√3, ...), nothing otherwise.
  std::optional<Number> square_root() const;

  /// Rational lower and upper bounds, at most 2^-bits apart; equal when the number is rational.
  std::pair<cln::cl_RA, cln::cl_RA> enclosure(int bits) const;

  /// Nearest double, ties to even, rounded once from the exact value (IEEE 754: subnormals are kept, beyond the largest
  /// finite value the result is infinite).
  double to_double() const;
  /// Nearest float, rounded once from the exact value, not by way of double.
  float to_float() const;

  /// For people: "3/4", "-2", "1/2*sqrt(2)", "1 - 1/2*sqrt(6)".
  std::string to_string() const;
  /// For generated headers: "num/den" when rational, else "a;b;c;d" for a + b√2 + c√3 + d√6, each part "num" or
  /// "num/den". A rational always carries its denominator ("2/1").
  std::string to_exact() const;
  /// Inverse of to_exact (a part without denominator is an integer). Throws Error naming a text it cannot read.
  static Number from_exact(std::string_view text);

  /// Equal numbers hash alike on every machine and run.
  std::size_t hash() const;

  friend bool operator==(const Number& left, const Number& right);
  friend std::strong_ordering operator<=>(const Number& left, const Number& right);

 private:
  // CLN keeps small integers in the word itself: zeros cost nothing, and to know one takes no call.
  static bool is_small(const cln::cl_RA& part, int value) { return part.word == cln::cl_combine(cl_FN_tag, value); }

  cln::cl_RA parts_[4];
};

/// Order by value: deterministic, and equal only for equal numbers.
std::strong_ordering compare(const Number& left, const Number& right);

/// Exact sine (first) and cosine (second) of twelfths·π/12; nothing when `twelfths` is not an integer.
std::optional<std::pair<Number, Number>> sin_cos_of_pi_twelfths(const Number& twelfths);

}  // namespace torsor

template <>
struct std::hash<torsor::Number> {
  std::size_t operator()(const torsor::Number& number) const { return number.hash(); }
};
