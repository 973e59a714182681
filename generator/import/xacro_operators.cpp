// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/import/xacro_format.hpp"
#include "torsor/generator/import/xacro_letters.hpp"
#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {
namespace {

[[noreturn]] void refuse(const char* symbol, const Value& a, const Value& b) {
  throw ExpressionError(
      fmt::format("{} {} {}: {} and {} do not go together", a.quoted(), symbol, b.quoted(), a.kind(), b.kind()));
}

[[noreturn]] void overflow(const char* symbol, const Value& a, const Value& b) {
  throw ExpressionError(
      fmt::format("{} {} {} is an integer beyond 64 bits; write one as a decimal", a.quoted(), symbol, b.quoted()));
}

void require_nonzero(const char* symbol, const Value& a, const Value& b) {
  if (b.number("") == 0) throw ExpressionError(fmt::format("{} {} {} divides by zero", a.quoted(), symbol, b.quoted()));
}

bool both_whole(const Value& a, const Value& b) { return a.is_whole() && b.is_whole(); }
bool both_numbers(const Value& a, const Value& b) { return a.is_number() && b.is_number(); }

Value repeated(const Value& what, const Value& times, const char* symbol) {
  const std::int64_t count = std::max<std::int64_t>(0, times.integer(symbol));
  const std::size_t size = what.is_string() ? what.text().size() : what.items().size();
  if (count > 100000 || size * static_cast<std::size_t>(count) > longest_text) {
    throw ExpressionError(fmt::format("{} repetitions are too many", count));
  }
  if (what.is_string()) {
    std::string text;
    for (std::int64_t i = 0; i < count; ++i) text += what.text();
    return text;
  }
  Value::List items;
  for (std::int64_t i = 0; i < count; ++i) items.insert(items.end(), what.items().begin(), what.items().end());
  return Value::list(std::move(items), what.is_tuple());
}

/// Python's remainder, whose sign is the divisor's.
double remainder_of(double a, double b) {
  double rest = std::fmod(a, b);
  if (rest != 0) {
    if ((b < 0) != (rest < 0)) rest += b;
  } else {
    rest = std::copysign(0.0, b);
  }
  return rest;
}

std::size_t position(const Value& of, const Value& key, std::size_t size) {
  const std::int64_t given = key.integer(fmt::format("an index of {}", of.kind()));
  const std::int64_t index = given < 0 ? given + static_cast<std::int64_t>(size) : given;
  if (index < 0 || index >= static_cast<std::int64_t>(size)) {
    throw ExpressionError(fmt::format("index {} of {}, which has {}", given, of.quoted(), size));
  }
  return static_cast<std::size_t>(index);
}

}  // namespace

Value add(const Value& a, const Value& b) {
  if (both_whole(a, b)) {
    std::int64_t sum = 0;
    if (__builtin_add_overflow(a.integer("+"), b.integer("+"), &sum)) overflow("+", a, b);
    return sum;
  }
  if (both_numbers(a, b)) return a.number("+") + b.number("+");
  if (a.is_string() && b.is_string()) {
    if (a.text().size() + b.text().size() > longest_text) throw ExpressionError("a text grows without end");
    return a.text() + b.text();
  }
  if (a.is_list() && b.is_list() && a.is_tuple() == b.is_tuple()) {
    if (a.items().size() + b.items().size() > longest_text) throw ExpressionError("a list grows without end");
    Value::List items = a.items();
    items.insert(items.end(), b.items().begin(), b.items().end());
    return Value::list(std::move(items), a.is_tuple());
  }
  if (a.is_string() || b.is_string()) {
    throw ExpressionError(fmt::format("{} + {}: {} and {} do not go together; str(...) makes a text of a number",
                                      a.quoted(), b.quoted(), a.kind(), b.kind()));
  }
  refuse("+", a, b);
}

Value subtract(const Value& a, const Value& b) {
  if (both_whole(a, b)) {
    std::int64_t difference = 0;
    if (__builtin_sub_overflow(a.integer("-"), b.integer("-"), &difference)) overflow("-", a, b);
    return difference;
  }
  if (!both_numbers(a, b)) refuse("-", a, b);
  return a.number("-") - b.number("-");
}

Value multiply(const Value& a, const Value& b) {
  if (both_whole(a, b)) {
    std::int64_t product = 0;
    if (__builtin_mul_overflow(a.integer("*"), b.integer("*"), &product)) overflow("*", a, b);
    return product;
  }
  if (both_numbers(a, b)) return a.number("*") * b.number("*");
  if ((a.is_string() || a.is_list()) && b.is_whole()) return repeated(a, b, "*");
  if ((b.is_string() || b.is_list()) && a.is_whole()) return repeated(b, a, "*");
  refuse("*", a, b);
}

Value divide(const Value& a, const Value& b) {
  if (!both_numbers(a, b)) refuse("/", a, b);
  require_nonzero("/", a, b);
  return a.number("/") / b.number("/");
}

Value floor_divide(const Value& a, const Value& b) {
  if (!both_numbers(a, b)) refuse("//", a, b);
  require_nonzero("//", a, b);
  if (both_whole(a, b)) {
    const std::int64_t x = a.integer("//"), y = b.integer("//");
    if (x == INT64_MIN && y == -1) overflow("//", a, b);
    return x / y - ((x % y != 0) && ((x < 0) != (y < 0)) ? 1 : 0);
  }
  const double x = a.number("//"), y = b.number("//");
  const double whole = (x - remainder_of(x, y)) / y;
  double below = std::floor(whole);
  if (whole - below > 0.5) below += 1;
  return whole == 0 ? std::copysign(0.0, x / y) : below;
}

Value modulo(const Value& a, const Value& b) {
  if (a.is_string()) return percent_format(a.text(), b);
  if (!both_numbers(a, b)) refuse("%", a, b);
  require_nonzero("%", a, b);
  if (both_whole(a, b)) {
    const std::int64_t x = a.integer("%"), y = b.integer("%");
    if (y == -1) return std::int64_t{0};
    const std::int64_t rest = x % y;
    return rest != 0 && ((rest < 0) != (y < 0)) ? rest + y : rest;
  }
  return remainder_of(a.number("%"), b.number("%"));
}

Value power(const Value& a, const Value& b) {
  if (!both_numbers(a, b)) refuse("**", a, b);
  if (both_whole(a, b) && b.integer("**") >= 0) {
    std::int64_t result = 1, base = a.integer("**");
    for (std::int64_t n = b.integer("**"); n > 0; n /= 2) {
      if (n % 2 == 1 && __builtin_mul_overflow(result, base, &result)) overflow("**", a, b);
      if (n > 1 && __builtin_mul_overflow(base, base, &base)) overflow("**", a, b);
    }
    return result;
  }
  const double x = a.number("**"), y = b.number("**");
  if (x == 0 && y < 0) throw ExpressionError(fmt::format("{} ** {} divides by zero", a.quoted(), b.quoted()));
  if (x < 0 && std::floor(y) != y) {
    throw ExpressionError(fmt::format("{} ** {} is no real number", a.quoted(), b.quoted()));
  }
  return std::pow(x, y);
}

Value negative(const Value& a) {
  if (a.is_whole()) return subtract(std::int64_t{0}, a);
  return -a.number("-");
}

Value item(const Value& of, const Value& key) {
  if (of.is_dictionary()) {
    if (const Value* found = of.find(key)) return *found;
    std::string known;
    for (const auto& [each, value] : of.entries()) known += (known.empty() ? "" : ", ") + each.quoted();
    throw ExpressionError(fmt::format("there is no {}; the keys are {}", key.quoted(), known));
  }
  if (of.is_list()) return of.items()[position(of, key, of.items().size())];
  if (of.is_string()) return part_of_letters(of.text(), position(of, key, letter_count(of.text())), 1);
  throw ExpressionError(fmt::format("{} is {} and has no items", of.quoted(), of.kind()));
}

bool contains(const Value& in, const Value& what) {
  if (in.is_dictionary()) return in.find(what) != nullptr;
  if (in.is_list()) {
    for (const Value& each : in.items()) {
      if (each == what) return true;
    }
    return false;
  }
  if (in.is_string() && what.is_string()) return in.text().find(what.text()) != std::string::npos;
  refuse("in", what, in);
}

Value part_of(const Value& of, const Value& from, const Value& to) {
  if (!of.is_list() && !of.is_string()) {
    throw ExpressionError(fmt::format("{} is {} and has no part [a:b]", of.quoted(), of.kind()));
  }
  const auto size = static_cast<std::int64_t>(of.is_string() ? letter_count(of.text()) : of.items().size());
  const auto bound = [size](const Value& given, std::int64_t otherwise) {
    if (given.is_none()) return otherwise;
    const std::int64_t index = given.integer("[a:b]");
    return std::clamp<std::int64_t>(index < 0 ? index + size : index, 0, size);
  };
  const std::int64_t begin = bound(from, 0);
  const std::int64_t end = std::max(begin, bound(to, size));
  if (of.is_string()) {
    return part_of_letters(of.text(), static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  }
  return Value::list({of.items().begin() + begin, of.items().begin() + end}, of.is_tuple());
}

bool identical(const Value& a, const Value& b) {
  if (std::string_view(a.kind()) != b.kind() || !(a == b)) return false;
  if (a.is_none() || a.is_bool() || (a.is_string() && a.text().empty())) return true;
  if (a.is_integer() && a.integer("is") >= -5 && a.integer("is") <= 256) return true;  // those Python has once
  throw ExpressionError(
      fmt::format("{} is {}: Python does not say whether that is one object; write ==", a.quoted(), b.quoted()));
}

}  // namespace torsor::xacro
