// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "torsor/generator/base/error.hpp"

namespace torsor::xacro {

/// What is wrong with an expression; who reads the file adds the place and makes it a FileError.
class ExpressionError : public Error {
 public:
  using Error::Error;
};

/// No text and no list of a robot is longer; who doubles one in every property would fill the memory.
inline constexpr std::size_t longest_text = 1000000;

/// A value of a xacro expression, which are those of Python: numbers are doubles or integers, and print as Python does.
class Value {
 public:
  using List = std::vector<Value>;
  using Dictionary = std::vector<std::pair<Value, Value>>;  ///< in the order in which it was written

  Value() = default;                                          ///< None
  Value(bool value) : content_(value) {}                      // NOLINT(google-explicit-constructor)
  Value(std::int64_t value) : content_(value) {}              // NOLINT(google-explicit-constructor)
  Value(double value) : content_(value) {}                    // NOLINT(google-explicit-constructor)
  Value(std::string value) : content_(std::move(value)) {}    // NOLINT(google-explicit-constructor)
  Value(const char* value) : content_(std::string(value)) {}  // NOLINT(google-explicit-constructor)
  static Value list(List items, bool tuple = false);
  /// Of equal keys the last value counts, where the first one stood.
  static Value dictionary(Dictionary entries);

  bool is_none() const { return std::holds_alternative<std::monostate>(content_); }
  bool is_bool() const { return std::holds_alternative<bool>(content_); }
  bool is_integer() const { return std::holds_alternative<std::int64_t>(content_); }
  bool is_float() const { return std::holds_alternative<double>(content_); }
  bool is_string() const { return std::holds_alternative<std::string>(content_); }
  bool is_list() const { return std::holds_alternative<SharedList>(content_); }
  bool is_dictionary() const { return std::holds_alternative<SharedDictionary>(content_); }
  /// A bool counts as 0 or 1, as in Python.
  bool is_number() const { return is_bool() || is_integer() || is_float(); }
  bool is_whole() const { return is_bool() || is_integer(); }

  const std::string& text() const { return std::get<std::string>(content_); }
  const List& items() const { return std::get<SharedList>(content_)->items; }
  bool is_tuple() const { return is_list() && std::get<SharedList>(content_)->tuple; }
  const Dictionary& entries() const { return *std::get<SharedDictionary>(content_); }
  /// Throw ExpressionError naming `user` when the value is of another kind.
  std::int64_t integer(const std::string& user) const;
  double number(const std::string& user) const;

  /// "float", "str", ... as Python names the kind.
  const char* kind() const;
  /// Python's truth: not None, not zero, not empty.
  bool truth() const;
  /// str(value): a double as the shortest decimal that reads back, 0.1 and 1e-05 and 2.0.
  std::string to_string() const;
  /// repr(value): as str, strings in quotes.
  std::string quoted() const;

  friend bool operator==(const Value& a, const Value& b);
  /// The entry of that key, none when there is none.
  const Value* find(const Value& key) const;

 private:
  struct Sequence {
    List items;
    bool tuple = false;
  };
  using SharedList = std::shared_ptr<const Sequence>;
  using SharedDictionary = std::shared_ptr<const Dictionary>;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, SharedList, SharedDictionary> content_;
};

/// a < b. Throws ExpressionError for kinds that have no order.
bool less(const Value& a, const Value& b);

/// A double as Python prints it.
std::string python_decimal(double value);
/// int(text) and float(text) of Python, blanks around allowed; none where Python would refuse. An integer beyond 64
/// bits is none.
std::optional<std::int64_t> python_integer(std::string_view text);
std::optional<double> python_float(std::string_view text);

/// What xacro makes of the text of a property or a parameter: 'text' in single quotes is that text, otherwise an
/// integer, a double or a boolean (true, True, false, False) where it reads as one.
Value literal(const Value& value);
/// Whether a condition holds: true, false, True, False or an integer as text, otherwise the truth of the value.
bool condition(const Value& value);

/// The operators of Python on values. Throw ExpressionError for kinds that do not fit, division by zero and integers
/// beyond 64 bits.
Value add(const Value& a, const Value& b);
Value subtract(const Value& a, const Value& b);
Value multiply(const Value& a, const Value& b);
Value divide(const Value& a, const Value& b);
Value floor_divide(const Value& a, const Value& b);
Value modulo(const Value& a, const Value& b);
Value power(const Value& a, const Value& b);
Value negative(const Value& a);
/// item of a list, a dictionary or a text.
Value item(const Value& of, const Value& key);
bool contains(const Value& in, const Value& what);
/// of[from:to] of a list or a text; None is no bound.
Value part_of(const Value& of, const Value& from, const Value& to);
/// a is b. Throws ExpressionError for equal values of which Python may have one object or two.
bool identical(const Value& a, const Value& b);

}  // namespace torsor::xacro
