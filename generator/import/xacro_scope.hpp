// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/import/xacro_node.hpp"
#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// A parameter of a macro: name, name:=default, name:=^ (the caller's property of that name), name:=^|default, *block
/// (an element that is inserted whole) and **block (its content).
struct MacroParameter {
  std::string name;
  bool forwards = false;
  std::optional<std::string> otherwise;
  bool is_block() const { return name[0] == '*'; }
};

struct Macro {
  std::string name;
  std::vector<MacroParameter> parameters;
  Node body;
};

/// The parameters of params="...". Throws ExpressionError.
std::vector<MacroParameter> macro_parameters(const std::string& text);

/// Properties, blocks and macros that are known at one place. A name that is not here is looked for where the macro was
/// called, or around the file that was included into a namespace.
class Scope {
 public:
  explicit Scope(Scope* around = nullptr) : around_(around) {}

  Scope* around() const { return around_; }
  Scope& outermost() { return around_ == nullptr ? *this : around_->outermost(); }

  /// Sets a property. With `later` its text is evaluated where it is first used; otherwise it is a value.
  void set(const std::string& name, const Value& value, bool later);
  void remove(const std::string& name) { properties_.erase(name); }
  bool knows(const std::string& name) const;
  /// The value of a property; `evaluate_text` gives a text its value in a scope. Throws ExpressionError when it needs
  /// itself.
  std::optional<Value> find(const std::string& name,
                            const std::function<Value(const std::string&, Scope&)>& evaluate_text);

  void set_block(const std::string& name, std::shared_ptr<const Node> block) { blocks_[name] = std::move(block); }
  /// The block of that name with its stars: "*tip", "**content".
  std::shared_ptr<const Node> block(const std::string& name) const;

  void set_macro(std::shared_ptr<const Macro> macro) { macros_[macro->name] = std::move(macro); }
  /// The macro of that name, and the namespace it stands in (null for none): "arm", "ur.arm".
  std::pair<std::shared_ptr<const Macro>, Scope*> macro(const std::string& name);
  /// Names of all macros that are known here.
  std::vector<std::string> macro_names() const;

  Scope& add_namespace(const std::string& name);
  Scope* find_namespace(const std::string& name);

 private:
  struct Property {
    Value value;
    bool later = false;  ///< a text that is not evaluated yet
    bool evaluating = false;
  };
  Scope* around_;
  std::map<std::string, Property> properties_;
  std::map<std::string, std::shared_ptr<const Node>> blocks_;
  std::map<std::string, std::shared_ptr<const Macro>> macros_;
  std::map<std::string, std::unique_ptr<Scope>> namespaces_;
};

}  // namespace torsor::xacro
