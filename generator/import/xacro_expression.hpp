// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// What an expression may use besides constants and functions of mathematics.
struct Surroundings {
  /// The property or argument of that name; none for an unknown one.
  std::function<std::optional<Value>(const std::string&)> value;
  /// Functions that look outside: load_yaml, arg, find, env. None for an unknown one; the arguments are evaluated.
  std::function<std::optional<Value>(const std::string&, const std::vector<Value>&)> call;
};

/// The value of an expression as people write them in ${...}: numbers, texts, lists, dictionaries, properties;
/// + − * / // % **, comparisons also in chains, and, or, not, in, is, `a if c else b`, [e for x in list if c];
/// items a[i], a[i:j], a.key; the functions of Python's math and abs, min, max, sum, round, len, range, int, float,
/// str, bool, list, dict, sorted; methods of texts (split, join, strip, lower, upper, replace, startswith, endswith)
/// and of dictionaries (get, keys, values, items). Numbers are doubles rounded as Python rounds. Throws
/// ExpressionError.
Value evaluate(std::string_view expression, const Surroundings& surroundings);

/// The constant of mathematics of that name: pi, e, tau, inf, nan.
std::optional<Value> constant(const std::string& name);
/// A function that needs its arguments only; none when the name is unknown.
std::optional<Value> call_function(const std::string& name, const std::vector<Value>& arguments);
/// A method of a text or a dictionary; none when the name is unknown.
std::optional<Value> call_method(const Value& object, const std::string& name, const std::vector<Value>& arguments);

}  // namespace torsor::xacro
