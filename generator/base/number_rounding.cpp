// SPDX-License-Identifier: GPL-3.0-or-later
// Correct rounding of exact numbers to binary floating point.
#include <algorithm>
#include <cmath>
#include <limits>

#include "torsor/generator/base/number.hpp"

namespace torsor {
namespace {

/// Nearest Float to a positive rational: the quotient is cut after the bits the format has at that magnitude, and the
/// remainder decides the rounding, ties to even (IEEE 754-2019, 4.3.1).
template <class Float>
Float round_positive(const cln::cl_RA& value) {
  using Limits = std::numeric_limits<Float>;
  cln::cl_I numerator = cln::numerator(value);
  cln::cl_I denominator = cln::denominator(value);
  const long exponent =  // 2^(exponent-1) < value < 2^(exponent+1)
      static_cast<long>(cln::integer_length(numerator)) - static_cast<long>(cln::integer_length(denominator));
  if (exponent > Limits::max_exponent + 1) return Limits::infinity();
  if (exponent < Limits::min_exponent - Limits::digits - 2) return Float(0);
  const long smallest_unit = Limits::min_exponent - Limits::digits;  // exponent of the smallest subnormal
  const auto reaches = [&](long power) {                             // value >= 2^power
    return power >= 0 ? numerator >= (denominator << power) : (numerator << -power) >= denominator;
  };
  const long top = reaches(exponent) ? exponent : exponent - 1;  // 2^top <= value < 2^(top+1)
  const long unit = std::max(top - Limits::digits + 1, smallest_unit);
  if (unit > 0) {
    denominator = denominator << unit;
  } else {
    numerator = numerator << -unit;
  }
  const cln::cl_I_div_t division = cln::floor2(numerator, denominator);
  cln::cl_I mantissa = division.quotient;
  const auto half = cln::compare(division.remainder << 1, denominator);
  if (half > 0 || (half == 0 && cln::oddp(mantissa))) mantissa = mantissa + 1;
  // The mantissa is at most 2^digits and the unit no smaller than that of subnormals: exact, or infinite.
  return std::ldexp(static_cast<Float>(cln::cl_I_to_long(mantissa)), static_cast<int>(unit));
}

template <class Float>
Float round_rational(const cln::cl_RA& value) {
  if (cln::zerop(value)) return Float(0);
  return cln::minusp(value) ? -round_positive<Float>(-value) : round_positive<Float>(value);
}

/// An irrational number is never halfway between two floats: a narrow enough enclosure has both ends on one side.
template <class Float>
Float round_number(const Number& number) {
  if (number.is_rational()) return round_rational<Float>(number.part(0));
  for (int bits = 128;; bits *= 2) {
    const auto [lower, upper] = number.enclosure(bits);
    const Float low = round_rational<Float>(lower);
    const Float high = round_rational<Float>(upper);
    if (low == high && (low != 0 || std::signbit(low) == std::signbit(high))) return low;
  }
}

}  // namespace

std::pair<cln::cl_RA, cln::cl_RA> Number::enclosure(int bits) const {
  if (is_rational()) return {parts_[0], parts_[0]};
  // Whole units of 2^-shift: rational bounds would spend their time on common divisors. Eight guard bits and those of
  // the largest coefficient keep the sum of the widths, each |coefficient| + 2 units at most, below 2^-bits.
  long magnitude = 0;
  for (const cln::cl_RA& part : parts_) {
    magnitude = std::max(magnitude, static_cast<long>(cln::integer_length(cln::numerator(part))) -
                                        static_cast<long>(cln::integer_length(cln::denominator(part))) + 1);
  }
  const long shift = bits + 8L + magnitude;
  constexpr int radicands[] = {1, 2, 3, 6};
  cln::cl_I lower = 0;
  cln::cl_I upper = 0;
  for (int index = 0; index < 4; ++index) {
    const cln::cl_I numerator = cln::numerator(parts_[index]);
    if (cln::zerop(numerator)) continue;
    const cln::cl_I denominator = cln::denominator(parts_[index]);
    const cln::cl_I below = cln::isqrt(cln::cl_I(radicands[index]) << (2 * shift));
    const cln::cl_I above = index == 0 ? below : below + 1;
    const bool negative = cln::minusp(numerator);
    lower = lower + cln::floor1(numerator * (negative ? above : below), denominator);
    upper = upper + cln::ceiling1(numerator * (negative ? below : above), denominator);
  }
  const cln::cl_I scale = cln::cl_I(1) << shift;
  return {lower / scale, upper / scale};
}

double Number::to_double() const { return round_number<double>(*this); }
float Number::to_float() const { return round_number<float>(*this); }

}  // namespace torsor
