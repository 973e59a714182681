// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_scope.hpp"

#include <utility>

#include <fmt/format.h>

namespace torsor::xacro {
namespace {

constexpr const char* spaces = " \t\r\n";

bool is_space(char c) { return std::string_view(spaces).find(c) != std::string_view::npos; }

/// The end of a default: blanks inside quotes belong to it, and those of one ${...} or $(...) up to the first bracket
/// that ends a word, as in xacro.
std::size_t end_of_default(const std::string& text, std::size_t at) {
  const bool expression = text.compare(at, 2, "${") == 0, command = text.compare(at, 2, "$(") == 0;
  if (expression || command) {
    const char close = expression ? '}' : ')';
    for (std::size_t end = text.find(close, at); end != std::string::npos; end = text.find(close, end + 1)) {
      if (end + 1 == text.size() || is_space(text[end + 1])) return end + 1;
    }
  }
  char quote = 0;
  for (; at < text.size(); ++at) {
    if (quote != 0) {
      if (text[at] == quote) quote = 0;
    } else if (text[at] == '\'' || text[at] == '"') {
      quote = text[at];
    } else if (is_space(text[at])) {
      break;
    }
  }
  if (quote != 0) throw ExpressionError(fmt::format("a quote is not closed in params=\"{}\"; end it with {}", text, quote));
  return at;
}

}  // namespace

std::vector<MacroParameter> macro_parameters(const std::string& text) {
  std::vector<MacroParameter> all;
  for (std::size_t at = text.find_first_not_of(spaces); at != std::string::npos;
       at = text.find_first_not_of(spaces, at)) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n:=", at), text.size());
    MacroParameter parameter;
    parameter.name = text.substr(at, end - at);
    if (parameter.name.find_first_not_of('*') == std::string::npos) {
      throw ExpressionError(fmt::format("a parameter without a name in params=\"{}\"", text));
    }
    at = end;
    std::size_t mark = text.find_first_not_of(spaces, at);
    if (mark != std::string::npos && text[mark] == ':' && mark + 1 < text.size() && text[mark + 1] == '=') ++mark;
    if (mark != std::string::npos && text[mark] == '=') {
      at = text.find_first_not_of(spaces, mark + 1);
      if (at == std::string::npos) at = text.size();
      if (text.compare(at, 1, "^") == 0) {
        parameter.forwards = true;
        at += text.compare(at, 2, "^|") == 0 ? 2U : 1U;
      }
      const std::size_t stop = end_of_default(text, at);
      if (stop > at) parameter.otherwise = text.substr(at, stop - at);
      at = stop;
    } else if (mark != std::string::npos && text[mark] == ':') {
      throw ExpressionError(fmt::format("params=\"{}\": a default is written name:=value", text));
    }
    all.push_back(std::move(parameter));
  }
  return all;
}

void Scope::set(const std::string& name, const Value& value, bool later) {
  Value read = literal(value);
  const bool is_text = read.is_string();
  properties_[name] = Property{std::move(read), later && is_text};
}

bool Scope::knows(const std::string& name) const {
  return properties_.contains(name) || (around_ != nullptr && around_->knows(name));
}

std::optional<Value> Scope::find(const std::string& name,
                                 const std::function<Value(const std::string&, Scope&)>& evaluate_text) {
  const auto found = properties_.find(name);
  if (found == properties_.end()) return around_ == nullptr ? std::nullopt : around_->find(name, evaluate_text);
  if (!found->second.later) return found->second.value;
  if (found->second.evaluating) {
    throw ExpressionError(
        fmt::format("the property '{}' needs itself: {}; give it another value", name, found->second.value.text()));
  }
  found->second.evaluating = true;
  const std::string text = found->second.value.text();
  Value value = literal(evaluate_text(text, *this));
  Property& property = properties_[name];
  property = Property{value};
  return value;
}

std::shared_ptr<const Node> Scope::block(const std::string& name) const {
  const auto found = blocks_.find(name);
  if (found != blocks_.end()) return found->second;
  return around_ == nullptr ? nullptr : around_->block(name);
}

std::pair<std::shared_ptr<const Macro>, Scope*> Scope::macro(const std::string& name) {
  for (Scope* at = this; at != nullptr; at = at->around_) {
    const auto found = at->macros_.find(name);
    if (found != at->macros_.end()) return {found->second, nullptr};
  }
  Scope* at = this;
  std::size_t begin = 0;
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', begin)) {
    at = at->find_namespace(name.substr(begin, dot - begin));
    if (at == nullptr) return {nullptr, nullptr};
    begin = dot + 1;
  }
  if (begin == 0) return {nullptr, nullptr};
  const auto found = at->macros_.find(name.substr(begin));
  if (found == at->macros_.end()) return {nullptr, nullptr};
  return {found->second, at};
}

std::vector<std::string> Scope::macro_names() const {
  std::vector<std::string> names = around_ == nullptr ? std::vector<std::string>() : around_->macro_names();
  for (const auto& [name, macro] : macros_) names.push_back(name);
  for (const auto& [space, scope] : namespaces_) {
    for (const auto& [name, macro] : scope->macros_) names.push_back(space + "." + name);
  }
  return names;
}

Scope& Scope::add_namespace(const std::string& name) {
  std::unique_ptr<Scope>& scope = namespaces_[name];
  if (!scope) scope = std::make_unique<Scope>(this);
  return *scope;
}

Scope* Scope::find_namespace(const std::string& name) {
  for (Scope* at = this; at != nullptr; at = at->around_) {
    const auto found = at->namespaces_.find(name);
    if (found != at->namespaces_.end()) return found->second.get();
  }
  return nullptr;
}

}  // namespace torsor::xacro
