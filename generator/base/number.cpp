// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include <cln/integer_io.h>
#include <cln/rational_io.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

constexpr std::array<int, 4> radicands{1, 2, 3, 6};

/// Root of a rational as r√s with s in {1, 2, 3, 6}: the only rationals whose root lies in the field.
std::optional<Number> root_of_rational(const cln::cl_RA& value) {
  if (cln::minusp(value)) return std::nullopt;
  for (std::size_t index = 0; index < radicands.size(); ++index) {
    cln::cl_RA root;
    if (!cln::sqrtp(value / cln::cl_I(radicands[index]), &root)) continue;
    std::array<cln::cl_RA, 4> parts{0, 0, 0, 0};
    parts[index] = root;
    return Number::from_parts(parts[0], parts[1], parts[2], parts[3]);
  }
  return std::nullopt;
}

/// u + v·surd, surd² = radicand.
struct InExtension {
  Number u, v, radicand, surd;
};

/// r with r² = u + v·surd, sought as r = p + q·surd. From p² + radicand q² = u and 2pq = v follows p² = (u ± w)/2, where
/// w² = u² − radicand v². u, v, p, q, w lie in one field, whose roots `subfield_root` finds.
template <class Root>
std::optional<Number> root_in_extension(const InExtension& value, Root subfield_root) {
  const auto& [u, v, radicand, surd] = value;
  if (v.is_zero()) {
    if (const auto root = subfield_root(u)) return root;
    if (const auto root = subfield_root(u / radicand)) return *root * surd;
    return std::nullopt;
  }
  const auto norm_root = subfield_root(u * u - radicand * v * v);
  if (!norm_root) return std::nullopt;
  for (const Number& w : {*norm_root, -*norm_root}) {
    const auto p = subfield_root((u + w) / 2);
    if (p && !p->is_zero()) return *p + v / (*p * 2) * surd;
  }
  return std::nullopt;
}

std::optional<Number> root_in_q(const Number& value) {
  cln::cl_RA root;
  if (cln::minusp(value.part(0)) || !cln::sqrtp(value.part(0), &root)) return std::nullopt;
  return Number(root);
}

std::optional<Number> root_in_q_sqrt2(const Number& value) {
  return root_in_extension({.u = value.part(0), .v = value.part(1), .radicand = 2, .surd = Number::sqrt2()}, root_in_q);
}

std::string rational_text(const cln::cl_RA& value) {
  std::ostringstream text;
  cln::fprint(text, cln::numerator(value));
  if (const cln::cl_I denominator = cln::denominator(value); denominator != 1) {
    text << '/';
    cln::fprint(text, denominator);
  }
  return text.str();
}

[[noreturn]] void refuse_exact(std::string_view text) {
  throw Error("cannot read \"" + std::string(text) + "\" as an exact number: write num/den or a;b;c;d");
}

cln::cl_I read_integer(std::string_view digits, std::string_view whole) {
  const bool negative = !digits.empty() && digits.front() == '-';
  const std::string magnitude(digits.substr(negative ? 1 : 0));
  if (magnitude.empty() || magnitude.find_first_not_of("0123456789") != std::string::npos) refuse_exact(whole);
  const cln::cl_I value(magnitude.c_str());
  return negative ? -value : value;
}

cln::cl_RA read_rational(std::string_view text, std::string_view whole) {
  const std::size_t slash = text.find('/');
  const cln::cl_I numerator = read_integer(text.substr(0, slash), whole);
  if (slash == std::string_view::npos) return numerator;
  const cln::cl_I denominator = read_integer(text.substr(slash + 1), whole);
  if (cln::zerop(denominator)) refuse_exact(whole);
  return cln::cl_RA(numerator) / cln::cl_RA(denominator);
}

/// One step of the 64-bit mixing function splitmix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t state, std::uint64_t value) {
  state += value + 0x9e3779b97f4a7c15u;
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return state ^ (state >> 31);
}

std::uint64_t mix(std::uint64_t state, const cln::cl_I& value) {
  const bool negative = cln::minusp(value);
  const cln::cl_I magnitude = negative ? -value : value;
  state = mix(state, static_cast<std::uint64_t>(negative ? 1 : 0));
  const std::size_t length = cln::integer_length(magnitude);
  std::size_t begin = 0;
  do {  // pieces of 32 bits: the same on machines of another word length
    state = mix(state, static_cast<std::uint64_t>(cln::cl_I_to_uint(cln::ldb(magnitude, cln::cl_byte(32, begin)))));
    begin += 32;
  } while (begin < length);
  return state;
}

}  // namespace

Number Number::rational(long numerator, long denominator) {
  if (denominator == 0) {
    throw Error("the fraction " + std::to_string(numerator) + "/0 has no value: give a denominator other than zero");
  }
  return cln::cl_RA(numerator) / cln::cl_RA(denominator);
}

Number Number::from_parts(const cln::cl_RA& a, const cln::cl_RA& b, const cln::cl_RA& c, const cln::cl_RA& d) {
  Number result(a);
  result.parts_[1] = b;
  result.parts_[2] = c;
  result.parts_[3] = d;
  return result;
}

Number Number::sqrt2() { return from_parts(0, 1, 0, 0); }
Number Number::sqrt3() { return from_parts(0, 0, 1, 0); }

const cln::cl_RA& Number::part(int index) const { return parts_[index]; }

bool Number::is_integer() const { return is_rational() && cln::denominator(parts_[0]) == 1; }

int Number::sign() const {
  if (is_rational()) return cln::zerop(parts_[0]) ? 0 : cln::minusp(parts_[0]) ? -1 : 1;
  // Doubles decide unless the terms nearly cancel: each is off by a few units in its 53 bits. A NaN decides nothing.
  constexpr double roots[] = {1, 1.4142135623730951, 1.7320508075688772, 2.449489742783178};
  double sum = 0;
  double size = 0;
  for (int index = 0; index < 4; ++index) {
    const double term = cln::double_approx(parts_[index]) * roots[index];
    sum += term;
    size += std::fabs(term);
  }
  if (size > 1e-200 && std::fabs(sum) > 1e-12 * size) return sum < 0 ? -1 : 1;
  for (int bits = 64;; bits *= 2) {
    const auto [lower, upper] = enclosure(bits);
    if (cln::plusp(lower)) return 1;
    if (cln::minusp(upper)) return -1;
  }
}

Number Number::abs() const { return sign() < 0 ? -*this : *this; }

Number Number::operator-() const {
  Number result;
  for (int index = 0; index < 4; ++index) {
    if (!is_small(parts_[index], 0)) result.parts_[index] = -parts_[index];
  }
  return result;
}

Number& Number::operator+=(const Number& other) {
  for (int index = 0; index < 4; ++index) {
    if (!is_small(other.parts_[index], 0)) parts_[index] = parts_[index] + other.parts_[index];
  }
  return *this;
}

Number& Number::operator-=(const Number& other) {
  for (int index = 0; index < 4; ++index) {
    if (!is_small(other.parts_[index], 0)) parts_[index] = parts_[index] - other.parts_[index];
  }
  return *this;
}

Number& Number::operator*=(const Number& other) {
  if (other.is_one()) return *this;
  if (is_one()) return *this = other;
  if (other.is_rational()) {
    const cln::cl_RA factor = other.parts_[0];  // a copy: `other` may be this number
    for (cln::cl_RA& part : parts_) {
      if (!is_small(part, 0)) part = part * factor;
    }
    return *this;
  }
  if (is_rational()) return *this = Number(other) *= *this;
  const auto& [a, b, c, d] = parts_;
  const auto& [e, f, g, h] = other.parts_;
  return *this = from_parts(a * e + 2 * (b * f) + 3 * (c * g) + 6 * (d * h), a * f + b * e + 3 * (c * h + d * g),
                            a * g + c * e + 2 * (b * h + d * f), a * h + d * e + b * g + c * f);
}

Number& Number::operator/=(const Number& other) {
  if (other.is_zero()) throw Error("division of " + to_string() + " by zero: the divisor must not vanish");
  if (other.is_rational()) {
    const cln::cl_RA divisor = other.parts_[0];
    for (cln::cl_RA& part : parts_) part = part / divisor;
    return *this;
  }
  // Multiply by the conjugates: √3 → −√3 leaves a norm in Q(√2), then √2 → −√2 one in Q.
  const auto& [a, b, c, d] = other.parts_;
  const Number conjugate3 = from_parts(a, b, -c, -d);
  const Number norm3 = other * conjugate3;
  const Number conjugate2 = from_parts(norm3.parts_[0], -norm3.parts_[1], 0, 0);
  const Number norm = norm3 * conjugate2;
  *this *= conjugate3 * conjugate2;
  return *this /= norm;
}

namespace {

/// Of 10^±80000 and beyond nothing is computed: the largest exponent of a decimal is 10000, and its square is needed.
constexpr long most_bits = 266000;

}  // namespace

Number Number::pow(int exponent) const {
  long bits = 0;
  for (const cln::cl_RA& part : parts_) {
    for (const cln::cl_I& integer : {cln::numerator(part), cln::denominator(part)}) {
      bits = std::max(bits, static_cast<long>(cln::integer_length(integer)));
    }
  }
  if (!is_rational()) bits += 2;  // (1 + √2)^n grows although its parts are small
  if (bits > 1 && bits > most_bits / std::max(1L, std::abs(static_cast<long>(exponent)))) {
    throw Error("a number of " + std::to_string(bits) + " bits to the power " + std::to_string(exponent) +
                " is beyond 10^80000: write smaller numbers");
  }
  if (exponent < 0 && is_zero()) {
    throw Error("zero to the power " + std::to_string(exponent) + " has no value: the base must not vanish");
  }
  Number result = 1;
  Number square = exponent < 0 ? Number(1) / *this : *this;
  for (unsigned remaining = exponent < 0 ? 0u - static_cast<unsigned>(exponent) : static_cast<unsigned>(exponent);
       remaining != 0; remaining >>= 1) {
    if (remaining & 1u) result *= square;
    if (remaining > 1) square *= square;
  }
  return result;
}

std::optional<Number> Number::square_root() const {
  if (is_rational()) return root_of_rational(parts_[0]);
  if (sign() < 0) return std::nullopt;
  const auto root = root_in_extension({.u = from_parts(parts_[0], parts_[1], 0, 0),
                                       .v = from_parts(parts_[2], parts_[3], 0, 0),
                                       .radicand = 3,
                                       .surd = sqrt3()},
                                      root_in_q_sqrt2);
  if (!root) return std::nullopt;
  return root->abs();
}

std::string Number::to_string() const {
  if (is_zero()) return "0";
  std::string text;
  for (int index = 0; index < 4; ++index) {
    const cln::cl_RA& coefficient = parts_[index];
    if (cln::zerop(coefficient)) continue;
    const bool negative = cln::minusp(coefficient);
    if (text.empty()) {
      text = negative ? "-" : "";
    } else {
      text += negative ? " - " : " + ";
    }
    const cln::cl_RA magnitude = cln::abs(coefficient);
    if (index == 0 || magnitude != 1) text += rational_text(magnitude);
    if (index > 0) {
      if (magnitude != 1) text += '*';
      text += "sqrt(" + std::to_string(radicands[static_cast<std::size_t>(index)]) + ")";
    }
  }
  return text;
}

std::string Number::to_exact() const {
  if (is_rational()) return is_integer() ? rational_text(parts_[0]) + "/1" : rational_text(parts_[0]);
  return rational_text(parts_[0]) + ';' + rational_text(parts_[1]) + ';' + rational_text(parts_[2]) + ';' +
         rational_text(parts_[3]);
}

Number Number::from_exact(std::string_view text) {
  if (text.find(';') == std::string_view::npos) return read_rational(text, text);
  std::array<cln::cl_RA, 4> parts{0, 0, 0, 0};
  std::string_view rest = text;
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const std::size_t end = rest.find(';');
    if ((end == std::string_view::npos) != (index == parts.size() - 1)) refuse_exact(text);
    parts[index] = read_rational(rest.substr(0, end), text);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return from_parts(parts[0], parts[1], parts[2], parts[3]);
}

std::size_t Number::hash() const {
  std::uint64_t state = 0;
  const int part_count = is_rational() ? 1 : 4;
  for (int index = 0; index < part_count; ++index) {
    state = mix(state, cln::numerator(parts_[index]));
    state = mix(state, cln::denominator(parts_[index]));
  }
  return static_cast<std::size_t>(state);
}

bool operator==(const Number& left, const Number& right) {
  for (int index = 0; index < 4; ++index) {
    const cln::cl_RA& a = left.parts_[index];
    const cln::cl_RA& b = right.parts_[index];
    if (a.word == b.word) continue;
    if (!a.pointer_p() || !b.pointer_p() || a != b) return false;
  }
  return true;
}

std::strong_ordering operator<=>(const Number& left, const Number& right) { return compare(left, right); }

std::strong_ordering compare(const Number& left, const Number& right) {
  if (left.is_rational() && right.is_rational()) return cln::compare(left.part(0), right.part(0)) <=> 0;
  return (left - right).sign() <=> 0;
}

std::optional<std::pair<Number, Number>> sin_cos_of_pi_twelfths(const Number& twelfths) {
  if (!twelfths.is_integer()) return std::nullopt;
  const Number s2 = Number::sqrt2(), s3 = Number::sqrt3(), s6 = s2 * s3;
  const std::array<Number, 7> quarter{0, (s6 - s2) / 4, Number::rational(1, 2), s2 / 2, s3 / 2, (s6 + s2) / 4, 1};
  const auto sine = [&quarter](int k) {  // 0 <= k < 24
    const int half = k % 12;
    const Number& value = quarter[static_cast<std::size_t>(half <= 6 ? half : 12 - half)];
    return k < 12 ? value : -value;
  };
  const int k = cln::cl_I_to_int(cln::mod(cln::numerator(twelfths.part(0)), 24));
  return std::pair(sine(k), sine((k + 6) % 24));
}

}  // namespace torsor
