// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace torsor::xacro {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Without the underscores that Python allows between digits; none when one stands elsewhere.
std::optional<std::string> without_underscores(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_') {
      plain += text[i];
    } else if (i == 0 || i + 1 == text.size() || !is_digit(text[i - 1]) || !is_digit(text[i + 1])) {
      return std::nullopt;
    }
  }
  return plain;
}

std::string in_quotes(const std::string& text) {
  const char quote = text.find('\'') != std::string::npos && text.find('"') == std::string::npos ? '"' : '\'';
  std::string result(1, quote);
  for (const char c : text) {
    if (c == '\\' || c == quote) result += '\\';
    result += c;
  }
  return result + quote;
}

}  // namespace

Value Value::list(List items, bool tuple) {
  Value value;
  value.content_ = std::make_shared<const Sequence>(Sequence{std::move(items), tuple});
  return value;
}

Value Value::dictionary(Dictionary entries) {
  Dictionary each_key_once;
  for (auto& [key, content] : entries) {
    const auto same = std::find_if(each_key_once.begin(), each_key_once.end(),
                                   [&k = key](const auto& other) { return other.first == k; });
    if (same != each_key_once.end()) {
      same->second = std::move(content);
    } else {
      each_key_once.emplace_back(std::move(key), std::move(content));
    }
  }
  Value value;
  value.content_ = std::make_shared<const Dictionary>(std::move(each_key_once));
  return value;
}

std::int64_t Value::integer(const std::string& user) const {
  if (is_bool()) return std::get<bool>(content_) ? 1 : 0;
  if (is_integer()) return std::get<std::int64_t>(content_);
  throw ExpressionError(fmt::format("{} needs an integer and got {} ({})", user, quoted(), kind()));
}

double Value::number(const std::string& user) const {
  if (is_float()) return std::get<double>(content_);
  if (is_whole()) return static_cast<double>(integer(user));
  throw ExpressionError(fmt::format("{} needs a number and got {} ({})", user, quoted(), kind()));
}

const char* Value::kind() const {
  static constexpr const char* names[] = {"None", "bool", "int", "float", "str", "list", "dict"};
  return is_tuple() ? "tuple" : names[content_.index()];
}

bool Value::truth() const {
  if (is_none()) return false;
  if (is_number()) return number("") != 0;
  if (is_string()) return !text().empty();
  return is_list() ? !items().empty() : !entries().empty();
}

std::string Value::to_string() const { return is_string() ? text() : quoted(); }

std::string Value::quoted() const {
  if (is_none()) return "None";
  if (is_bool()) return std::get<bool>(content_) ? "True" : "False";
  if (is_integer()) return std::to_string(std::get<std::int64_t>(content_));
  if (is_float()) return python_decimal(std::get<double>(content_));
  if (is_string()) return in_quotes(text());
  std::string inside;
  if (is_list()) {
    for (const Value& each : items()) inside += (inside.empty() ? "" : ", ") + each.quoted();
    if (is_tuple()) return "(" + inside + (items().size() == 1 ? ",)" : ")");
    return "[" + inside + "]";
  }
  for (const auto& [key, each] : entries()) {
    inside += (inside.empty() ? "" : ", ") + key.quoted() + ": " + each.quoted();
  }
  return "{" + inside + "}";
}

bool operator==(const Value& a, const Value& b) {
  if (a.is_number() && b.is_number()) {
    if (a.is_whole() && b.is_whole()) return a.integer("") == b.integer("");
    return a.number("") == b.number("");
  }
  if (a.content_.index() != b.content_.index()) return false;
  if (a.is_none()) return true;
  if (a.is_string()) return a.text() == b.text();
  if (a.is_list()) return a.is_tuple() == b.is_tuple() && a.items() == b.items();
  const auto in_b = [&b](const auto& entry) {
    const Value* other = b.find(entry.first);
    return other != nullptr && *other == entry.second;
  };
  return a.entries().size() == b.entries().size() && std::all_of(a.entries().begin(), a.entries().end(), in_b);
}

bool less(const Value& a, const Value& b) {
  if (a.is_whole() && b.is_whole()) return a.integer("") < b.integer("");
  if (a.is_number() && b.is_number()) return a.number("") < b.number("");
  if (a.is_string() && b.is_string()) return a.text() < b.text();
  if (a.is_list() && b.is_list()) {
    return std::lexicographical_compare(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(), less);
  }
  throw ExpressionError(fmt::format("{} ({}) and {} ({}) have no order", a.quoted(), a.kind(), b.quoted(), b.kind()));
}

const Value* Value::find(const Value& key) const {
  for (const auto& [each, value] : entries()) {
    if (each == key) return &value;
  }
  return nullptr;
}

std::string python_decimal(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  std::string text(buffer, end);  // -d.ddde+xx
  const std::size_t mark = text.find('e');
  const int exponent = std::stoi(text.substr(mark + 1));
  const std::string sign = text[0] == '-' ? "-" : "";
  std::string digits;
  for (const char c : text.substr(0, mark)) {
    if (is_digit(c)) digits += c;
  }
  if (exponent < -4 || exponent >= 16) {
    const std::string rest = digits.size() > 1 ? "." + digits.substr(1) : "";
    return fmt::format("{}{}{}e{}{:02}", sign, digits[0], rest, exponent < 0 ? '-' : '+', std::abs(exponent));
  }
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0') + ".0";
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::optional<std::int64_t> python_integer(std::string_view text) {
  const std::optional<std::string> plain = without_underscores(trimmed(text));
  if (!plain) return std::nullopt;
  std::string_view rest = *plain;
  const bool plus = !rest.empty() && rest[0] == '+';
  if (plus) rest.remove_prefix(1);
  const std::string_view digits = !plus && !rest.empty() && rest[0] == '-' ? rest.substr(1) : rest;
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (failure != std::errc() || end != rest.data() + rest.size()) return std::nullopt;
  return value;
}

std::optional<double> python_float(std::string_view text) {
  std::optional<std::string> plain = without_underscores(trimmed(text));
  if (!plain || plain->empty()) return std::nullopt;
  std::string_view rest = *plain;
  bool negated = false;
  if (rest[0] == '+' || rest[0] == '-') {
    negated = rest[0] == '-';
    rest.remove_prefix(1);
  }
  if (rest.empty() || rest[0] == '+' || rest[0] == '-') return std::nullopt;
  std::string word(rest);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  double value = 0;
  if (word == "inf" || word == "infinity") {
    value = std::numeric_limits<double>::infinity();
  } else if (word == "nan") {
    value = std::numeric_limits<double>::quiet_NaN();
  } else {
    if (!is_digit(rest[0]) && rest[0] != '.') return std::nullopt;
    const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (end != rest.data() + rest.size()) return std::nullopt;
    if (failure == std::errc::result_out_of_range) {
      value = word.find("e-") == std::string::npos ? std::numeric_limits<double>::infinity() : 0.0;
    } else if (failure != std::errc()) {
      return std::nullopt;
    }
  }
  return negated ? -value : value;
}

Value literal(const Value& value) {
  if (!value.is_string()) return value;
  const std::string& text = value.text();
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') return text.substr(1, text.size() - 2);
  // Python takes 1_2 as 12; in a name it is a text, and xacro keeps it as one.
  if (text.find('_') != std::string::npos) return value;
  if (const auto whole = python_integer(text)) return *whole;
  const std::string_view word = trimmed(text);
  const bool beyond_64_bits = !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
  if (beyond_64_bits) return value;  // Python's integers have any size: this one prints as it is written
  if (const auto real = python_float(text)) return *real;
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  return value;
}

bool condition(const Value& value) {
  if (!value.is_string()) return value.truth();
  if (value.text() == "true" || value.text() == "True") return true;
  if (value.text() == "false" || value.text() == "False") return false;
  if (const auto whole = python_integer(value.text())) return *whole != 0;
  throw ExpressionError(
      fmt::format("the condition is \"{}\"; write true, false, an integer or an expression ${{...}}", value.text()));
}

}  // namespace torsor::xacro
