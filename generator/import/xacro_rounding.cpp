// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_rounding.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace torsor::xacro {
namespace {

/// A size to the nearest multiple of 10^zeros, halves to even; `more` says that it is a part of one larger.
std::uint64_t rounded_to_tens(std::uint64_t size, std::int64_t zeros, bool more) {
  constexpr std::int64_t most = 19;  // 10^19 is the largest power in 64 bits
  if (zeros > most) return 0;
  std::uint64_t unit = 1;
  for (std::int64_t i = 0; i < zeros; ++i) unit *= 10;
  const std::uint64_t rest = size % unit, missing = unit - rest;
  const bool up = rest > missing || (rest == missing && (more || (size / unit) % 2 == 1));
  return up ? size + missing : size - rest;
}

/// Python's round of an integer, which stays one.
Value rounded_integer(std::int64_t value, std::int64_t digits) {
  if (digits >= 0) return value;
  const auto bits = static_cast<std::uint64_t>(value);
  const std::uint64_t size = value < 0 ? std::uint64_t{0} - bits : bits;
  const std::uint64_t result = rounded_to_tens(size, -std::max<std::int64_t>(digits, -100), false);
  if (result > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    throw ExpressionError(fmt::format("round({}, {}) is no integer of 64 bits", value, digits));
  }
  return value < 0 ? -static_cast<std::int64_t>(result) : static_cast<std::int64_t>(result);
}

}  // namespace

Value whole(const std::string& name, double value) {
  if (!(std::abs(value) < 9.2e18))
    throw ExpressionError(fmt::format("{}({}) is no integer of 64 bits", name, python_decimal(value)));
  return static_cast<std::int64_t>(value);
}

Value rounded(const std::vector<Value>& given) {
  const bool to_whole = given.size() == 1 || given[1].is_none();
  const std::int64_t digits = to_whole ? 0 : given[1].integer("round");
  if (given[0].is_whole()) return rounded_integer(given[0].integer("round"), digits);
  const double value = given[0].number("round");
  if (to_whole) return whole("round", std::nearbyint(value));
  if (!std::isfinite(value) || digits > 323) return value;
  if (digits < 0) {
    const double size = std::trunc(std::abs(value));
    if (!(size < 9.2e18)) {
      throw ExpressionError(fmt::format("round({}, {}) takes numbers below 9.2e18", python_decimal(value), digits));
    }
    const std::uint64_t tens =
        rounded_to_tens(static_cast<std::uint64_t>(size), -std::max<std::int64_t>(digits, -100), std::abs(value) > size);
    return std::copysign(static_cast<double>(tens), value);
  }
  // Not by the C library, whose decimal point is that of the process.
  const std::string text = fmt::format("{:.{}f}", value, digits);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

}  // namespace torsor::xacro
