// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/high_precision.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <unordered_map>

#include <cln/integer_io.h>
#include <cln/real.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

constexpr int least_digits = 20;  // CLN's short formats overflow easily; its long format starts here
constexpr int most_digits = 1000000;

thread_local int digits_at_work = 50;

cln::float_format_t format_for(int digits) {
  if (digits < 1 || digits > most_digits) {
    throw UsageError("a precision of " + std::to_string(digits) + " decimal digits is not available: ask for 1 to " +
                     std::to_string(most_digits));
  }
  return cln::float_format(static_cast<unsigned>(std::max(digits, least_digits)));
}

/// Nearest value of the format. CLN rounds one rational correctly; an irrational is never halfway between two values,
/// so that a narrow enough enclosure rounds to one value.
cln::cl_F round_to(const Number& number, cln::float_format_t format) {
  if (number.is_rational()) return cln::cl_float(number.part(0), format);
  for (int bits = static_cast<int>(format) + 64;; bits *= 2) {
    const auto [lower, upper] = number.enclosure(bits);
    const cln::cl_F low = cln::cl_float(lower, format);
    if (low == cln::cl_float(upper, format)) return low;
  }
}

/// Brings both operands to the larger of their two formats (CLN by itself falls back to the smaller).
class Matched {
 public:
  Matched(const cln::cl_F& left, const cln::cl_F& right) : left_(left), right_(right) {
    const cln::float_format_t left_format = cln::float_format(left);
    const cln::float_format_t right_format = cln::float_format(right);
    if (left_format < right_format) left_ = cln::cl_float(left, right_format);
    if (right_format < left_format) right_ = cln::cl_float(right, left_format);
  }
  const cln::cl_F& left() const { return left_; }
  const cln::cl_F& right() const { return right_; }

 private:
  cln::cl_F left_;
  cln::cl_F right_;
};

/// An elementary function of a default-constructed zero has to have some precision: the working one.
cln::cl_F with_own_precision(const cln::cl_F& value) {
  if (cln::float_format(value) >= cln::float_format_lfloat_min) return value;
  return cln::cl_float(value, format_for(digits_at_work));
}

struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

}  // namespace

Real::Real(const Number& value, int digits) : value_(round_to(value, format_for(digits))) {}

Real Real::from_double(double value, int digits) {
  if (!std::isfinite(value)) return not_a_number();
  // By its mantissa of 53 bits: CLN's own conversion throws on subnormals.
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(value, &exponent), 53));
  return Real(cln::scale_float(cln::cl_float(cln::cl_I(mantissa), format_for(digits)), exponent - 53));
}

Real Real::parse(std::string_view text, int digits) { return Real(parse_decimal(text), digits); }

Real Real::constant(std::string_view exact) {
  thread_local std::unordered_map<std::string, Real, TextHash, std::equal_to<>> known;
  thread_local int known_digits = 0;
  if (known_digits != digits_at_work) {
    known.clear();
    known_digits = digits_at_work;
  }
  if (const auto found = known.find(exact); found != known.end()) return found->second;
  return known.emplace(std::string(exact), Real(Number::from_exact(exact), digits_at_work)).first->second;
}

Real Real::not_a_number() {
  Real result;
  result.nan_ = true;
  return result;
}

int Real::working_digits() noexcept { return digits_at_work; }

int Real::digits() const {
  const auto bits = static_cast<int>(cln::float_format(value_));
  if (bits < static_cast<int>(cln::float_format_lfloat_min)) return 0;
  return static_cast<int>(std::floor((bits - 1) * 0.30102999566398119));  // log10(2)
}

Real Real::with_digits(int digits) const { return nan_ ? *this : Real(cln::cl_float(value_, format_for(digits))); }

Real Real::epsilon() const {
  const auto format = cln::float_format(with_own_precision(value_));
  return Real(cln::scale_float(cln::cl_float(cln::cl_I(1), format), -static_cast<long>(format)));
}

Real Real::operator-() const { return nan_ ? *this : Real(-value_); }

Real operator+(const Real& left, const Real& right) {
  if (left.nan_ || right.nan_) return Real::not_a_number();
  const Matched operands(left.value_, right.value_);
  return Real(operands.left() + operands.right());
}

Real operator-(const Real& left, const Real& right) {
  if (left.nan_ || right.nan_) return Real::not_a_number();
  const Matched operands(left.value_, right.value_);
  return Real(operands.left() - operands.right());
}

Real operator*(const Real& left, const Real& right) {
  if (left.nan_ || right.nan_) return Real::not_a_number();
  const Matched operands(left.value_, right.value_);
  return Real(operands.left() * operands.right());
}

Real operator/(const Real& left, const Real& right) {
  if (left.nan_ || right.nan_ || cln::zerop(right.value_)) return Real::not_a_number();
  const Matched operands(left.value_, right.value_);
  return Real(operands.left() / operands.right());
}

std::partial_ordering operator<=>(const Real& left, const Real& right) {
  if (left.nan_ || right.nan_) return std::partial_ordering::unordered;
  const Matched operands(left.value_, right.value_);
  return cln::compare(operands.left(), operands.right()) <=> 0;
}

Number Real::to_number() const {
  if (nan_) throw Error("a high-precision result is not a number: look for a division by zero or a root below zero");
  return cln::rational(value_);
}

double Real::to_double() const {
  if (nan_) return std::numeric_limits<double>::quiet_NaN();
  if (cln::zerop(value_)) return 0.0;
  const double sign = cln::minusp(value_) ? -1.0 : 1.0;
  // Far outside the range of double the exact rational would only be a waste of memory.
  const auto exponent = cln::float_exponent(value_);
  if (exponent > 1100) return sign * std::numeric_limits<double>::infinity();
  if (exponent < -1200) return sign * 0.0;
  return Number(cln::rational(value_)).to_double();
}

std::string Real::to_string(int digits) const {
  if (digits < 1)
    throw UsageError("cannot print a number with " + std::to_string(digits) + " digits: ask for 1 or more");
  if (nan_) return "nan";
  if (cln::zerop(value_)) return digits > 1 ? "0." + std::string(static_cast<std::size_t>(digits - 1), '0') : "0";
  const cln::cl_RA magnitude = cln::rational(cln::abs(value_));
  const auto rounded = [&magnitude, digits](long exponent) {  // magnitude / 10^(exponent + 1 - digits), ties to even
    const long shift = exponent + 1 - digits;
    const cln::cl_I power = shift == 0 ? 1 : cln::expt_pos(cln::cl_I(10), cln::cl_I(std::abs(shift)));
    return cln::round1(shift > 0 ? magnitude / power : magnitude * power);
  };
  // The estimate of the decimal exponent is off by one at most; the number of digits obtained corrects it.
  auto exponent =
      static_cast<long>(std::floor(static_cast<double>(cln::float_exponent(value_) - 1) * 0.30102999566398119));
  std::string text;
  for (;;) {
    std::ostringstream stream;
    cln::fprint(stream, rounded(exponent));
    text = stream.str();
    const long excess = static_cast<long>(text.size()) - digits;
    if (excess == 0) break;
    exponent += excess > 0 ? 1 : -1;
  }
  const std::string sign = cln::minusp(value_) ? "-" : "";
  if (exponent >= digits || exponent < -5) {
    if (digits > 1) text.insert(1, ".");
    return sign + text + (exponent < 0 ? "e-" : "e+") + std::to_string(std::abs(exponent));
  }
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text;
  if (exponent + 1 < digits) text.insert(static_cast<std::size_t>(exponent + 1), ".");
  return sign + text;
}

Real abs(const Real& x) { return x.is_nan() ? x : Real(cln::abs(x.raw())); }

Real sqrt(const Real& x) {
  if (x.is_nan() || cln::minusp(x.raw())) return Real::not_a_number();
  return cln::zerop(x.raw()) ? x : Real(cln::sqrt(x.raw()));
}

Real sin(const Real& angle) { return angle.is_nan() ? angle : Real(cln::sin(with_own_precision(angle.raw()))); }

Real cos(const Real& angle) { return angle.is_nan() ? angle : Real(cln::cos(with_own_precision(angle.raw()))); }

void sincos(const Real& angle, Real& sine, Real& cosine) {
  if (angle.is_nan()) {
    sine = cosine = Real::not_a_number();
    return;
  }
  const cln::cl_F argument = with_own_precision(angle.raw());
  const cln::cos_sin_t both = cln::cos_sin(argument);
  sine = Real(cln::cl_float(both.sin, cln::float_format(argument)));
  cosine = Real(cln::cl_float(both.cos, cln::float_format(argument)));
}

Real exp(const Real& x) { return x.is_nan() ? x : Real(cln::exp(with_own_precision(x.raw()))); }

Real log(const Real& x) {
  if (x.is_nan() || !(cln::plusp(x.raw()))) return Real::not_a_number();
  return Real(cln::ln(with_own_precision(x.raw())));
}

Real atan2(const Real& y, const Real& x) {
  if (y.is_nan() || x.is_nan()) return Real::not_a_number();
  if (y.is_zero() && x.is_zero()) return y;
  // The precision of the quotient, in which the smaller component is over the larger: |atan| <= pi/4.
  const int digits = std::max({y.digits(), x.digits(), least_digits});
  const Real pi = Real::pi(digits), half(Number::rational(1, 2), digits);
  const auto of_quotient = [](const Real& quotient) {
    return quotient.is_zero() ? quotient : Real(cln::the<cln::cl_F>(cln::atan(with_own_precision(quotient.raw()))));
  };
  if (abs(y) > abs(x)) {
    const Real rest = of_quotient(x / y);
    return (y > Real(0) ? half * pi : -(half * pi)) - rest;
  }
  const Real angle = of_quotient(y / x);
  if (x > Real(0)) return angle;
  return y < Real(0) ? angle - pi : angle + pi;
}

Real Real::pi(int digits) { return Real(cln::pi(format_for(digits))); }

Real pow(const Real& x, int exponent) {
  Real result(Number(1), std::max(x.digits(), least_digits));
  Real square = x;
  for (unsigned remaining = exponent < 0 ? 0u - static_cast<unsigned>(exponent) : static_cast<unsigned>(exponent);
       remaining != 0; remaining >>= 1) {
    if (remaining & 1u) result *= square;
    if (remaining > 1) square *= square;
  }
  return exponent < 0 ? Real(Number(1), std::max(x.digits(), least_digits)) / result : result;
}

WorkingDigits::WorkingDigits(int digits) : previous_(digits_at_work) {
  format_for(digits);
  digits_at_work = digits;
}

WorkingDigits::~WorkingDigits() { digits_at_work = previous_; }

}  // namespace torsor
