// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

constexpr int largest_exponent = 10000;

[[noreturn]] void refuse(std::string_view text, const char* reason) {
  throw Error("cannot read \"" + std::string(text) + "\" as a number: " + reason);
}

bool is_digit(char character) { return character >= '0' && character <= '9'; }

/// Takes the digits at the front of `rest`.
std::string take_digits(std::string_view& rest) {
  std::size_t count = 0;
  while (count < rest.size() && is_digit(rest[count])) ++count;
  std::string digits(rest.substr(0, count));
  rest.remove_prefix(count);
  return digits;
}

bool take(std::string_view& rest, char character) {
  if (rest.empty() || rest.front() != character) return false;
  rest.remove_prefix(1);
  return true;
}

/// Takes a sign; true when it is a minus.
bool take_sign(std::string_view& rest) {
  if (take(rest, '-')) return true;
  take(rest, '+');
  return false;
}

int take_exponent(std::string_view& rest, std::string_view whole) {
  if (!take(rest, 'e') && !take(rest, 'E')) return 0;
  const bool negative = take_sign(rest);
  const std::string digits = take_digits(rest);
  if (digits.empty()) refuse(whole, "digits are missing after the exponent's e");
  int value = 0;
  const auto status = std::from_chars(digits.data(), digits.data() + digits.size(), value).ec;
  if (status != std::errc() || value > largest_exponent) refuse(whole, "the exponent is beyond 10000");
  return negative ? -value : value;
}

template <class Float>
std::string shortest_text(Float value) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

}  // namespace

Number parse_decimal(std::string_view text) {
  std::string_view rest = text;
  const bool negative = take_sign(rest);
  std::string digits = take_digits(rest);
  cln::cl_RA value;
  if (!digits.empty() && take(rest, '/')) {
    const std::string divisor_digits = take_digits(rest);
    if (divisor_digits.empty()) refuse(text, "an integer is missing after the /");
    const cln::cl_I divisor(divisor_digits.c_str());
    if (cln::zerop(divisor)) refuse(text, "the denominator is zero");
    value = cln::cl_RA(cln::cl_I(digits.c_str())) / divisor;
  } else {
    std::string decimals;
    if (take(rest, '.')) decimals = take_digits(rest);
    digits += decimals;
    if (digits.empty()) refuse(text, "write a decimal such as -1.5e-3 or a quotient such as 3/4");
    const long exponent = take_exponent(rest, text) - static_cast<long>(decimals.size());
    const cln::cl_I power = cln::expt_pos(cln::cl_I(10), cln::cl_I(exponent == 0 ? 1 : std::abs(exponent)));
    value = cln::cl_I(digits.c_str());
    if (exponent > 0) value = value * power;
    if (exponent < 0) value = value / power;
  }
  if (!rest.empty()) refuse(text, "write a decimal such as -1.5e-3 or a quotient such as 3/4, and nothing after it");
  return negative ? -value : value;
}

Number from_double(double value) {
  if (!std::isfinite(value)) {
    throw Error("the value " + shortest(value) + " is not a finite number: give a finite one");
  }
  return parse_decimal(shortest(value));
}

std::string shortest(double value) { return shortest_text(value); }
std::string shortest(float value) { return shortest_text(value); }

}  // namespace torsor
