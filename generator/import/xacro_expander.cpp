// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_expander.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <glob.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor::xacro {
namespace {

/// A file expands to no more than this: who calls a macro twice in itself would fill the memory.
constexpr std::size_t most_elements = 100000;
/// Python's own limit stops xacro at some 200 macros in one another.
constexpr int deepest_calls = 400;

/// Elements of URDF whose content is no mechanics: what is wrong in an expression there is no matter.
bool holds_no_mechanics(const std::string& tag) {
  static const std::set<std::string> tags{"visual",       "collision", "material",     "gazebo",
                                          "transmission", "sensor",    "ros2_control", "self_collision_checking"};
  return tags.contains(tag);
}

bool is_name(const std::string& text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !text.empty() && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

}  // namespace

Expander::Expander(const std::string& path, const XacroOptions& options)
    : options_(options), packages_(path, options.package_folders) {
  for (const auto& [name, value] : options.arguments) arguments_[name] = value;
  reading_.push_back(path);
  current_file_.push_back(path);
}

Node Expander::expand(const Node& root) {
  Scope outermost;
  Node made = root;
  made.children.clear();
  made.attributes.clear();
  children(root, {outermost, made, true, {}});
  // The robot's name may be an argument that is declared inside.
  for (const auto& [name, text] : root.attributes) {
    if (name != "xmlns:xacro") made.set(name, value(root, text, outermost).to_string());
  }
  return made;
}

void Expander::refuse_unknown_arguments() const {
  for (const auto& [name, value] : options_.arguments) {
    if (known_arguments_.contains(name)) continue;
    const std::vector<std::string> known(known_arguments_.begin(), known_arguments_.end());
    throw UsageError(
        fmt::format("--arg {}: {}the file declares {}", name, did_you_mean(name, known),
                    known.empty() ? std::string("no <xacro:arg>") : fmt::format("{}", fmt::join(known, ", "))));
  }
}

void Expander::children(const Node& node, const Place& place) {
  for (const Node& child : node.children) element(child, place);
}

void Expander::element(const Node& given, const Place& place) {
  if (++depth_ > deepest_calls) {
    given.fail("elements and macros stand in one another without end; let an <xacro:if> end the calls");
  }
  // Messages say which macro made it.
  Node copy;
  const Node* node = &given;
  if (given.within != place.within) {
    copy = given;
    copy.within = place.within;
    node = &copy;
  }
  current_file_.push_back(*node->file);
  if (!node->tag.starts_with("xacro:")) {
    ordinary(*node, node->tag, place);
  } else {
    const std::string word = node->tag.substr(6);
    if (word == "property")
      property(*node, place);
    else if (word == "arg")
      argument(*node, place);
    else if (word == "include")
      include(*node, place);
    else if (word == "macro")
      define_macro(*node, place);
    else if (word == "insert_block")
      insert_block(*node, place);
    else if (word == "if" || word == "unless")
      conditional(*node, place);
    else if (word == "attribute")
      attribute(*node, place);
    else if (word == "element")
      ordinary(*node, text(*node, "xacro:name", place.scope), place);
    else if (word == "call")
      call_macro(*node, text(*node, "macro", place.scope), place);
    else
      call_macro(*node, word, place);
  }
  current_file_.pop_back();
  --depth_;
}

void Expander::count(const Node& node) {
  if (++made_ <= most_elements) return;
  node.fail(fmt::format("the file expands to more than {} elements; let an <xacro:if> end the calls of macros",
                        most_elements));
}

void Expander::ordinary(const Node& node, const std::string& tag, const Place& place) {
  count(node);
  if (tag.empty() || tag.find_first_of(" <>\"'&/=") != std::string::npos) {
    node.fail(fmt::format("xacro:name=\"{}\" is no name of an element", tag));
  }
  Node made;
  made.tag = tag;
  made.file = node.file;
  made.line = node.line;
  made.within = node.within;
  const bool mechanics = place.mechanics && !holds_no_mechanics(tag);
  for (const auto& [name, raw] : node.attributes) {
    if (name.starts_with("xacro:") || name == "xmlns:xacro") continue;
    if (mechanics) {
      made.attributes.emplace_back(name, value(node, raw, place.scope).to_string());
      continue;
    }
    try {
      made.attributes.emplace_back(name, evaluate_text(raw, place.scope).to_string());
    } catch (const ExpressionError&) {
      made.attributes.emplace_back(name, raw);  // a mesh of a package that is not here, for instance
    }
  }
  children(node, {place.scope, made, mechanics, place.within});
  place.into.children.push_back(std::move(made));
}

void Expander::property(const Node& node, const Place& place) {
  require_attributes(node, {"name", "value", "default", "remove", "scope", "lazy_eval"});
  const std::string name = text(node, "name", place.scope);
  if (!is_name(name)) node.fail(fmt::format("'{}' is no name of a property; use letters, digits and _", name));
  if (name.starts_with("__")) node.fail("names of properties do not begin with __");
  const std::string* given = node.attribute("value");
  const std::string* otherwise = node.attribute("default");
  const std::string* removed = node.attribute("remove");
  const bool remove = removed != nullptr && condition(value(node, *removed, place.scope));
  if ((given != nullptr ? 1 : 0) + (otherwise != nullptr ? 1 : 0) + (remove ? 1 : 0) > 1) {
    node.fail("value, default and remove exclude one another; keep one");
  }
  if (remove) return place.scope.remove(name);
  if (otherwise != nullptr) {
    if (place.scope.knows(name)) return;
    given = otherwise;
  }
  const std::string reach = node.attribute("scope") == nullptr ? "" : text(node, "scope", place.scope);
  Scope* target = &place.scope;
  if (reach == "global") {
    target = &place.scope.outermost();
  } else if (reach == "parent") {
    if (place.scope.around() != nullptr) target = place.scope.around();
  } else if (!reach.empty() && reach != "local") {
    node.fail(fmt::format("scope=\"{}\" is unknown; use parent or global, or leave it out", reach));
  }
  if (given == nullptr) return target->set_block("**" + name, std::make_shared<const Node>(node));
  if (!node.children.empty()) node.fail("has a value and elements inside; keep one");
  const std::string* lazy = node.attribute("lazy_eval");
  bool later = target == &place.scope && reach.empty();
  try {
    if (lazy != nullptr) later = condition(value(node, *lazy, place.scope)) && later;
  } catch (const ExpressionError& error) {
    node.fail(error.what());
  }
  if (later) {
    target->set(name, *given, true);
  } else {
    target->set(name, value(node, *given, place.scope), false);
  }
}

void Expander::argument(const Node& node, const Place& place) {
  require_attributes(node, {"name", "default"});
  const std::string name = text(node, "name", place.scope);
  known_arguments_.insert(name);
  if (arguments_.contains(name)) return;
  if (node.attribute("default") != nullptr) arguments_[name] = text(node, "default", place.scope);
}

void Expander::include(const Node& node, const Place& place) {
  require_attributes(node, {"filename", "ns", "optional"});
  const std::string pattern = resolved(text(node, "filename", place.scope));
  std::vector<std::string> names{pattern};
  if (pattern.find_first_of("*?[") != std::string::npos) {
    glob_t found{};
    names.clear();
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0) names.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
  }
  Scope* scope = &place.scope;
  if (node.attribute("ns") != nullptr) {
    const std::string name = text(node, "ns", place.scope);
    if (!is_name(name)) node.fail(fmt::format("ns=\"{}\" is no name; use letters, digits and _", name));
    scope = &place.scope.add_namespace(name);
  }
  const std::string* optional = node.attribute("optional");
  for (const std::string& name : names) {
    if (std::find(reading_.begin(), reading_.end(), name) != reading_.end()) {
      node.fail(fmt::format("the files include one another in a circle: {} -> {}; let one of them go without the other",
                            fmt::join(reading_, " -> "), name));
    }
    if (!std::filesystem::is_regular_file(name)) {
      if (optional != nullptr && condition(value(node, *optional, place.scope))) continue;
      node.fail(fmt::format("there is no file '{}'; correct the name, which is relative to this file", name));
    }
    const Node root = read_nodes(read(name), name);
    reading_.push_back(name);
    current_file_.push_back(name);
    // As in xacro, the attributes of the included root mean nothing.
    children(root, {*scope, place.into, place.mechanics, place.within});
    current_file_.pop_back();
    reading_.pop_back();
  }
}

void Expander::insert_block(const Node& node, const Place& place) {
  require_attributes(node, {"name"});
  const std::string name = text(node, "name", place.scope);
  if (const auto content = place.scope.block("**" + name)) return children(*content, place);
  const auto block = place.scope.block("*" + name);
  if (!block)
    node.fail(
        fmt::format("there is no block '{}'; give the macro a parameter *{} or **{}, or define "
                    "<xacro:property name=\"{}\"> with elements inside",
                    name, name, name, name));
  element(*block, place);
}

void Expander::conditional(const Node& node, const Place& place) {
  require_attributes(node, {"value"});
  const Value given = value(node, required(node, "value"), place.scope);
  bool holds = false;
  try {
    holds = condition(given);
  } catch (const ExpressionError& error) {
    node.fail(error.what());
  }
  if (holds == (node.tag == "xacro:if")) children(node, place);
}

void Expander::attribute(const Node& node, const Place& place) {
  require_attributes(node, {"name", "value"});
  const std::string name = text(node, "name", place.scope);
  if (name.empty() || name.find_first_of(" <>\"'&/=") != std::string::npos) {
    node.fail(fmt::format("'{}' is no name of an attribute", name));
  }
  place.into.set(name, text(node, "value", place.scope));
}

void Expander::define_macro(const Node& node, const Place& place) {
  require_attributes(node, {"name", "params"});
  std::string name = required(node, "name");
  if (name.starts_with("xacro:")) name = name.substr(6);
  const std::string* parameters = node.attribute("params");
  try {
    place.scope.set_macro(std::make_shared<const Macro>(
        Macro{name, parameters == nullptr ? std::vector<MacroParameter>() : macro_parameters(*parameters), node}));
  } catch (const ExpressionError& error) {
    node.fail(error.what());
  }
}

void Expander::call_macro(const Node& node, const std::string& name, const Place& place) {
  const auto [macro, space] = place.scope.macro(name);
  if (!macro) {
    std::vector<std::string> known = place.scope.macro_names();
    for (const char* word :
         {"property", "arg", "include", "macro", "insert_block", "if", "unless", "attribute", "element", "call"}) {
      known.emplace_back(word);
    }
    node.fail(
        fmt::format("there is no macro '{}'; {}define it by <xacro:macro name=\"{}\"> or include the file that does",
                    name, did_you_mean(name, known), name));
  }
  count(node);
  Scope inner(space == nullptr ? &place.scope : space);
  pass_parameters(node, *macro, inner, place);
  std::string within = fmt::format("in the macro '{}', called at {}:{}", name, *node.file, node.line);
  // Of a long chain of calls the innermost and the outermost tell most.
  if (!place.within.empty()) {
    const std::size_t outermost = place.within.rfind("in the macro");
    within += (outermost == 0 ? ", " : ", ..., ") + place.within.substr(outermost);
  }
  children(macro->body, {inner, place.into, place.mechanics, within});
}

void Expander::pass_parameters(const Node& node, const Macro& macro, Scope& inner, const Place& place) {
  std::vector<std::string> names;
  for (const MacroParameter& parameter : macro.parameters) names.push_back(parameter.name);
  const bool called = node.tag == "xacro:call";
  for (const auto& [name, given] : node.attributes) {
    if (called && name == "macro") continue;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      node.fail(fmt::format("the macro '{}' has no parameter '{}'; {}it has {}", macro.name, name,
                            did_you_mean(name, names),
                            names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", "))));
    }
    inner.set(name, value(node, given, place.scope), false);
  }
  // Blocks are evaluated where the macro is called, and stand in the order of the parameters.
  Node blocks;
  children(node, {place.scope, blocks, place.mechanics, place.within});
  std::size_t taken = 0;
  for (const MacroParameter& parameter : macro.parameters) {
    if (parameter.is_block()) {
      if (taken == blocks.children.size()) {
        node.fail(fmt::format("the block '{}' of the macro '{}' is missing; put an element inside", parameter.name,
                              macro.name));
      }
      inner.set_block(parameter.name, std::make_shared<const Node>(blocks.children[taken++]));
      continue;
    }
    if (node.attribute(parameter.name) != nullptr && !(called && parameter.name == "macro")) continue;
    if (parameter.forwards) {
      const auto evaluate = [this](const std::string& text, Scope& scope) { return evaluate_text(text, scope); };
      try {
        if (const auto found = place.scope.find(parameter.name, evaluate)) {
          inner.set(parameter.name, *found, false);
          continue;
        }
      } catch (const ExpressionError& error) {
        node.fail(error.what());
      }
    }
    if (!parameter.otherwise) {
      node.fail(fmt::format("the macro '{}' needs the parameter '{}'; add {}=\"...\"{}", macro.name, parameter.name,
                            parameter.name, parameter.forwards ? ", or a property of that name before" : ""));
    }
    inner.set(parameter.name, value(node, *parameter.otherwise, place.scope), false);
  }
  if (taken < blocks.children.size()) {
    node.fail(fmt::format("the macro '{}' takes {} block{} and got {}: <{}> is one more; remove it", macro.name, taken,
                          taken == 1 ? "" : "s", blocks.children.size(), blocks.children[taken].tag));
  }
}

void Expander::require_attributes(const Node& node, const std::vector<std::string>& known) const {
  for (const auto& [name, value] : node.attributes) {
    if (std::find(known.begin(), known.end(), name) != known.end() || name.find(':') != std::string::npos) continue;
    node.fail(fmt::format("has an attribute {}, which means nothing there; {}the attributes are {}", name,
                          did_you_mean(name, known), fmt::join(known, ", ")));
  }
}

const std::string& Expander::required(const Node& node, const std::string& attribute) const {
  const std::string* given = node.attribute(attribute);
  if (given == nullptr) node.fail(fmt::format("has no attribute {}; add {}=\"...\"", attribute, attribute));
  return *given;
}

}  // namespace torsor::xacro
