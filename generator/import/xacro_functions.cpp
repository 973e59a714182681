// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "torsor/generator/import/xacro_expression.hpp"
#include "torsor/generator/import/xacro_letters.hpp"
#include "torsor/generator/import/xacro_rounding.hpp"

namespace torsor::xacro {
namespace {

using Arguments = std::vector<Value>;

void require_count(const std::string& name, const Arguments& given, std::size_t least, std::size_t most) {
  if (given.size() >= least && given.size() <= most) return;
  throw ExpressionError(
      least == most ? fmt::format("{} takes {} argument{} and got {}", name, least, least == 1 ? "" : "s", given.size())
                    : fmt::format("{} takes {} to {} arguments and got {}", name, least, most, given.size()));
}

/// Python refuses what leaves the reals: sqrt(-1), log(0), acos(2).
double real(const std::string& name, const Arguments& given, double value) {
  if (std::isfinite(value)) return value;
  for (const Value& each : given) {
    if (!std::isfinite(each.number(name))) return value;
  }
  std::string list;
  for (const Value& each : given) list += (list.empty() ? "" : ", ") + each.quoted();
  throw ExpressionError(fmt::format("{}({}) is no finite number", name, list));
}

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

// Products with the constants that Python uses.
double as_radians(double x) { return x * (std::numbers::pi / 180.0); }
double as_degrees(double x) { return x * (180.0 / std::numbers::pi); }

const std::map<std::string, OfOne>& functions_of_one() {
  static const std::map<std::string, OfOne> table{
      {"sin", std::sin},      {"cos", std::cos},     {"tan", std::tan},     {"asin", std::asin},
      {"acos", std::acos},    {"atan", std::atan},   {"sinh", std::sinh},   {"cosh", std::cosh},
      {"tanh", std::tanh},    {"sqrt", std::sqrt},   {"exp", std::exp},     {"log10", std::log10},
      {"log2", std::log2},    {"fabs", std::fabs},   {"asinh", std::asinh}, {"acosh", std::acosh},
      {"atanh", std::atanh},  {"expm1", std::expm1}, {"log1p", std::log1p}, {"radians", as_radians},
      {"degrees", as_degrees}};
  return table;
}

const std::map<std::string, OfTwo>& functions_of_two() {
  static const std::map<std::string, OfTwo> table{
      {"atan2", std::atan2}, {"pow", std::pow}, {"fmod", std::fmod}, {"copysign", std::copysign}};
  return table;
}

Value range(const Arguments& given) {
  const std::int64_t begin = given.size() == 1 ? 0 : given[0].integer("range");
  const std::int64_t end = given.size() == 1 ? given[0].integer("range") : given[1].integer("range");
  const std::int64_t step = given.size() == 3 ? given[2].integer("range") : 1;
  if (step == 0) throw ExpressionError("range(a, b, 0) never ends");
  Value::List items;
  for (std::int64_t i = begin; step > 0 ? i < end : i > end; i += step) {
    items.emplace_back(i);
    if (items.size() > 100000) throw ExpressionError("range has more than 100000 items");
  }
  return Value::list(std::move(items));
}

Value::List items_of(const std::string& name, const Value& of) {
  if (of.is_list()) return of.items();
  Value::List all;
  if (of.is_dictionary()) {
    for (const auto& [key, value] : of.entries()) all.push_back(key);
  } else if (of.is_string()) {
    for (std::string& letter : letters(of.text())) all.emplace_back(std::move(letter));
  } else {
    throw ExpressionError(fmt::format("{} needs a list and got {} ({})", name, of.quoted(), of.kind()));
  }
  return all;
}

Value extreme(const std::string& name, const Arguments& given) {
  const Value::List all = given.size() == 1 ? items_of(name, given[0]) : given;
  if (all.empty()) throw ExpressionError(name + " of nothing");
  Value best = all[0];
  for (const Value& each : all) {
    if (name == "min" ? less(each, best) : less(best, each)) best = each;
  }
  return best;
}

Value as_integer(const Value& value) {
  if (value.is_whole()) return value.integer("int");
  if (value.is_float()) return whole("int", std::trunc(value.number("int")));
  if (value.is_string()) {
    if (const auto read = python_integer(value.text())) return *read;
  }
  throw ExpressionError(fmt::format("int({}) is no integer", value.quoted()));
}

Value as_float(const Value& value) {
  if (value.is_number()) return value.number("float");
  if (value.is_string()) {
    if (const auto read = python_float(value.text())) return *read;
  }
  throw ExpressionError(fmt::format("float({}) is no number", value.quoted()));
}

/// dict(x) of a dictionary or of pairs.
Value as_dictionary(const Value& value) {
  if (value.is_dictionary()) return value;
  Value::Dictionary entries;
  for (const Value& each : items_of("dict", value)) {
    const Value::List pair = items_of("dict", each);
    if (pair.size() != 2) throw ExpressionError(fmt::format("dict takes pairs of a key and a value and got {}", each.quoted()));
    entries.emplace_back(pair[0], pair[1]);
  }
  return Value::dictionary(std::move(entries));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  if (from.empty()) throw ExpressionError("replace('', ...) has nothing to look for");
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

Value::List split(const std::string& text, const Value& separator) {
  Value::List parts;
  if (separator.is_none()) {
    constexpr const char* blanks = " \t\r\n";
    for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string::npos;) {
      const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
      parts.emplace_back(text.substr(begin, end - begin));
      begin = text.find_first_not_of(blanks, end);
    }
    return parts;
  }
  const std::string& mark = separator.is_string() ? separator.text() : std::string();
  if (mark.empty()) throw ExpressionError("split(...) takes a text that is not empty");
  std::size_t begin = 0;
  for (std::size_t end = text.find(mark); end != std::string::npos; end = text.find(mark, begin)) {
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + mark.size();
  }
  parts.emplace_back(text.substr(begin));
  return parts;
}

std::string in_case(std::string text, char first, char last, int shift) {
  for (char& c : text) {
    if (c >= first && c <= last) c = static_cast<char>(c + shift);
  }
  return text;
}

std::string stripped(const std::string& text, bool left, bool right) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = left ? text.find_first_not_of(blanks) : 0;
  if (begin == std::string::npos) return "";
  const std::size_t end = right ? text.find_last_not_of(blanks) + 1 : text.size();
  return text.substr(begin, end - begin);
}

std::string text_argument(const std::string& name, const Arguments& given, std::size_t i) {
  if (!given[i].is_string()) {
    throw ExpressionError(fmt::format("{} needs a text and got {} ({})", name, given[i].quoted(), given[i].kind()));
  }
  return given[i].text();
}

std::optional<Value> text_method(const std::string& text, const std::string& name, const Arguments& given) {
  const auto count = [&](std::size_t least, std::size_t most) { require_count("." + name, given, least, most); };
  if (name == "lower" || name == "upper" || name == "strip" || name == "lstrip" || name == "rstrip") {
    count(0, 0);
    if (!is_ascii(text) && (name == "lower" || name == "upper")) {
      throw ExpressionError(
          fmt::format("'{}'.{}(): only letters of ASCII change their case here; write the text itself", text, name));
    }
    if (name == "lower") return in_case(text, 'A', 'Z', 'a' - 'A');
    if (name == "upper") return in_case(text, 'a', 'z', 'A' - 'a');
    return stripped(text, name != "rstrip", name != "lstrip");
  }
  if (name == "split") {
    count(0, 1);
    return Value::list(split(text, given.empty() ? Value() : given[0]));
  }
  if (name == "replace") {
    count(2, 2);
    return replaced(text, text_argument(name, given, 0), text_argument(name, given, 1));
  }
  if (name == "startswith" || name == "endswith") {
    count(1, 1);
    const std::string part = text_argument(name, given, 0);
    return name == "startswith" ? text.starts_with(part) : text.ends_with(part);
  }
  if (name == "join") {
    count(1, 1);
    std::string all;
    bool first = true;
    for (const Value& each : items_of(name, given[0])) {
      if (!first) all += text;
      first = false;
      all += text_argument(name, {each}, 0);
    }
    return all;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Value> constant(const std::string& name) {
  if (name == "pi") return std::numbers::pi;
  if (name == "e") return std::numbers::e;
  if (name == "tau") return 2 * std::numbers::pi;
  if (name == "inf") return std::numeric_limits<double>::infinity();
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

std::optional<Value> call_function(const std::string& name, const Arguments& given) {
  const auto count = [&](std::size_t least, std::size_t most) { require_count(name, given, least, most); };
  if (const auto found = functions_of_one().find(name); found != functions_of_one().end()) {
    count(1, 1);
    return real(name, given, found->second(given[0].number(name)));
  }
  if (const auto found = functions_of_two().find(name); found != functions_of_two().end()) {
    count(2, 2);
    return real(name, given, found->second(given[0].number(name), given[1].number(name)));
  }
  constexpr std::size_t any = 100000;
  if (name == "hypot") {
    count(2, 2);
    return std::hypot(given[0].number(name), given[1].number(name));
  }
  if (name == "log") {
    count(1, 2);
    const double value = std::log(given[0].number(name));
    return real(name, given, given.size() == 1 ? value : value / std::log(given[1].number(name)));
  }
  if (name == "floor" || name == "ceil" || name == "trunc") {
    count(1, 1);
    if (given[0].is_whole()) return given[0].integer(name);
    const double x = given[0].number(name);
    return whole(name, name == "floor" ? std::floor(x) : name == "ceil" ? std::ceil(x) : std::trunc(x));
  }
  if (name == "abs") {
    count(1, 1);
    if (given[0].is_whole()) return given[0].integer(name) < 0 ? negative(given[0]) : Value(given[0].integer(name));
    return std::abs(given[0].number(name));
  }
  if (name == "min" || name == "max") {
    count(1, any);
    return extreme(name, given);
  }
  if (name == "sum") {
    count(1, 1);
    Value total(std::int64_t{0});
    for (const Value& each : items_of(name, given[0])) total = add(total, each);
    return total;
  }
  if (name == "round") {
    count(1, 2);
    return rounded(given);
  }
  if (name == "range") {
    count(1, 3);
    return range(given);
  }
  if (name == "len") {
    count(1, 1);
    return static_cast<std::int64_t>(items_of(name, given[0]).size());
  }
  if (name == "int" || name == "float" || name == "str" || name == "bool") {
    count(1, 1);
    if (name == "int") return as_integer(given[0]);
    if (name == "float") return as_float(given[0]);
    if (name == "str") return given[0].to_string();
    return given[0].truth();
  }
  if (name == "list" || name == "tuple" || name == "sorted") {
    count(0, 1);
    Value::List all = given.empty() ? Value::List() : items_of(name, given[0]);
    if (name == "sorted") std::stable_sort(all.begin(), all.end(), less);
    return Value::list(std::move(all), name == "tuple");
  }
  if (name == "dict") {
    count(0, 1);
    return given.empty() ? Value::dictionary({}) : as_dictionary(given[0]);
  }
  return std::nullopt;
}

std::optional<Value> call_method(const Value& object, const std::string& name, const Arguments& given) {
  if (object.is_string()) return text_method(object.text(), name, given);
  if (!object.is_dictionary()) return std::nullopt;
  if (name == "get") {
    require_count(".get", given, 1, 2);
    if (const Value* found = object.find(given[0])) return *found;
    return given.size() == 2 ? given[1] : Value();
  }
  if (name != "keys" && name != "values" && name != "items") return std::nullopt;
  require_count("." + name, given, 0, 0);
  Value::List all;
  for (const auto& [key, value] : object.entries()) {
    all.push_back(name == "keys" ? key : name == "values" ? value : Value::list({key, value}, true));
  }
  return Value::list(std::move(all));
}

}  // namespace torsor::xacro
