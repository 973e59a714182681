// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/text_of_file.hpp"
#include "torsor/generator/import/xacro_expander.hpp"
#include "torsor/generator/import/xacro_expression.hpp"
#include "torsor/generator/import/xacro_text.hpp"
#include "torsor/generator/import/yaml_subset.hpp"

namespace torsor::xacro {
namespace {

namespace fs = std::filesystem;

/// Properties in one another.
constexpr int deepest_evaluations = 300;

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  const Value all = *call_method(text, "split", {});
  for (const Value& word : all.items()) words.push_back(word.text());
  return words;
}

/// What $(eval) makes of an argument: a number or a boolean where it reads as one.
Value converted(const std::string& text) {
  if (const auto whole = python_integer(text)) return *whole;
  if (const auto real = python_float(text)) return *real;
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  return text;
}

std::optional<std::string> environment(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

}  // namespace

Value Expander::value(const Node& node, const std::string& text, Scope& scope) {
  try {
    return evaluate_text(text, scope);
  } catch (const ExpressionError& error) {
    node.fail(error.what());
  }
}

std::string Expander::text(const Node& node, const std::string& attribute, Scope& scope) {
  return value(node, required(node, attribute), scope).to_string();
}

Value Expander::evaluate_text(const std::string& text, Scope& scope) {
  if (text.find('$') == std::string::npos) return text;
  return text_value(
      text, [&](const std::string& expression) { return evaluate_expression(expression, scope); },
      [&](const std::string& command) { return evaluate_command(command, scope); });
}

Value Expander::evaluate_expression(const std::string& expression, Scope& scope) {
  if (++evaluations_ > deepest_evaluations) {
    --evaluations_;
    throw ExpressionError(fmt::format("${{{}}}: properties need one another too deeply", expression));
  }
  const auto evaluate_in = [this](const std::string& text, Scope& inner) { return evaluate_text(text, inner); };
  const Surroundings surroundings{[&](const std::string& name) -> std::optional<Value> {
                                    const std::size_t dot = name.find('.');
                                    if (dot == std::string::npos) return scope.find(name, evaluate_in);
                                    Scope* space = scope.find_namespace(name.substr(0, dot));
                                    if (space == nullptr) return std::nullopt;
                                    return space->find(name.substr(dot + 1), evaluate_in);
                                  },
                                  [&](const std::string& name, const std::vector<Value>& arguments) {
                                    return call_outside(name, arguments, scope);
                                  }};
  try {
    // $(arg x) inside an expression is its text.
    Value result = evaluate(evaluate_text(expression, scope).to_string(), surroundings);
    --evaluations_;
    return result;
  } catch (const ExpressionError& error) {
    --evaluations_;
    const std::string message = error.what();
    if (message.starts_with("${")) throw;  // of a property that this one needs
    throw ExpressionError(fmt::format("${{{}}}: {}", expression, message));
  }
}

std::optional<Value> Expander::call_outside(const std::string& name, const std::vector<Value>& arguments,
                                            Scope& scope) {
  const auto text_argument = [&](std::size_t i) {
    if (arguments.size() <= i || !arguments[i].is_string()) throw ExpressionError(name + "(...) takes a text");
    return arguments[i].text();
  };
  if (name == "load_yaml") {
    const std::string path = resolved(text_argument(0));
    std::error_code none;
    if (!fs::is_regular_file(path, none)) throw ExpressionError(fmt::format("load_yaml: there is no file '{}'", path));
    return yaml_value(read(path), path);
  }
  if (name == "arg") return converted(argument_value(text_argument(0)).to_string());
  if (name == "find") return package(text_argument(0));
  if (name == "env") return evaluate_command("env " + text_argument(0), scope);
  if (name == "abs_filename") return resolved(text_argument(0));
  if (name == "dotify") return arguments.empty() ? Value() : arguments[0];
  if (name == "warning" || name == "message" || name == "print_location") return Value("");
  if (name == "fatal" || name == "error") {
    std::string all;
    for (const Value& each : arguments) all += (all.empty() ? "" : " ") + each.to_string();
    throw ExpressionError(fmt::format("the file says: {}", all));
  }
  return std::nullopt;
}

Value Expander::argument_value(const std::string& name) {
  known_arguments_.insert(name);
  const auto found = arguments_.find(name);
  if (found != arguments_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [each, value] : arguments_) known.push_back(each);
  throw ExpressionError(
      fmt::format("the argument '{}' has no value; {}declare it by <xacro:arg name=\"{}\" default=\"...\"/> "
                  "or give --arg {}:=...",
                  name, did_you_mean(name, known), name, name));
}

std::string Expander::package(const std::string& name) {
  if (const auto folder = packages_.find(name)) return *folder;
  throw ExpressionError(
      fmt::format("$(find {}): the package is not in {}; give --package-path FOLDER", name, packages_.described()));
}

Value Expander::evaluate_command(const std::string& given, Scope& scope) {
  const std::string command = evaluate_text(given, scope).to_string();
  const std::vector<std::string> words = words_of(command);
  const auto fail = [&](const std::string& message) -> void {
    throw ExpressionError(fmt::format("$({}): {}", command, message));
  };
  if (words.empty()) fail("is empty; write $(arg name) or $(find package)");
  const std::string& what = words[0];
  if (what == "eval") {
    const Surroundings surroundings{[&](const std::string& name) -> std::optional<Value> {
                                      if (!arguments_.contains(name)) return std::nullopt;
                                      return converted(argument_value(name).to_string());
                                    },
                                    [&](const std::string& name, const std::vector<Value>& arguments) {
                                      return call_outside(name, arguments, scope);
                                    }};
    try {
      return evaluate(command.substr(command.find("eval") + 4), surroundings).to_string();
    } catch (const ExpressionError& error) {
      fail(error.what());
    }
  }
  if (what == "cwd") return fs::current_path().string();
  if (what == "dirname") return fs::path(reading_.back()).parent_path().string();
  if (words.size() < 2)
    fail("is not read here; there are $(arg), $(find), $(env), $(optenv), $(eval), $(dirname), $(cwd)");
  if (what == "arg") return argument_value(words[1]);
  if (what == "find") return package(words[1]);
  if (what == "anon") return words[1];
  if (what == "env") {
    const auto value = environment(words[1]);
    if (!value) fail("the environment has no such variable");
    return *value;
  }
  if (what == "optenv") {
    if (const auto value = environment(words[1])) return *value;
    std::string otherwise;
    for (std::size_t i = 2; i < words.size(); ++i) otherwise += (i == 2 ? "" : " ") + words[i];
    return otherwise;
  }
  fail("is not read here; there are $(arg), $(find), $(env), $(optenv), $(eval), $(dirname), $(cwd)");
  return {};
}

std::string Expander::resolved(const std::string& path) {
  if (fs::path(path).is_absolute()) return path;
  const auto beside = [&path](const std::string& file) {
    return (fs::path(file).parent_path() / path).lexically_normal().string();
  };
  std::error_code none;
  const std::string there = beside(reading_.back()), here = beside(current_file_.back());
  const auto is_there = [&](const std::string& name) { return fs::exists(name, none); };
  if (there == here || !is_there(here)) return is_there(there) || there == here ? there : here;
  const bool both = is_there(there);
  const std::string& taken = both ? there : here;
  const std::string note =
      both ? fmt::format("xacro: '{}' is read, as xacro reads it, and not '{}' beside the macro that names it", there, here)
           : fmt::format("xacro: '{}' is read from beside the macro that names it; xacro looks for '{}' only", here, there);
  if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
  return taken;
}

std::string Expander::read(const std::string& path) {
  if (std::find(files_.begin(), files_.end(), path) == files_.end()) files_.push_back(path);
  return text_of_file(path);
}

}  // namespace torsor::xacro
