// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/import/xacro.hpp"
#include "torsor/generator/import/xacro_node.hpp"
#include "torsor/generator/import/xacro_packages.hpp"
#include "torsor/generator/import/xacro_scope.hpp"

namespace torsor::xacro {

/// Makes of a file's elements those without xacro. The order of the file is the order of doing: a property is known
/// from its element on.
class Expander {
 public:
  Expander(const std::string& path, const XacroOptions& options);

  Node expand(const Node& root);
  /// Throws UsageError for an argument of the command line that no file declared or used.
  void refuse_unknown_arguments() const;
  const std::vector<std::string>& files() const { return files_; }
  /// Names of files that may be meant otherwise.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// Where a piece of a file is evaluated.
  struct Place {
    Scope& scope;
    Node& into;             ///< takes what is made
    bool mechanics = true;  ///< otherwise inside an element that holds none
    std::string within;     ///< the macros that are being expanded
  };

  void children(const Node& node, const Place& place);
  void element(const Node& node, const Place& place);
  /// Counts an element or a call; refuses more than a memory holds.
  void count(const Node& node);
  void ordinary(const Node& node, const std::string& tag, const Place& place);
  void property(const Node& node, const Place& place);
  void argument(const Node& node, const Place& place);
  void include(const Node& node, const Place& place);
  void insert_block(const Node& node, const Place& place);
  void conditional(const Node& node, const Place& place);
  void attribute(const Node& node, const Place& place);
  void define_macro(const Node& node, const Place& place);
  void call_macro(const Node& node, const std::string& name, const Place& place);
  void pass_parameters(const Node& node, const Macro& macro, Scope& inner, const Place& place);

  /// Values of texts; errors name the element.
  Value value(const Node& node, const std::string& text, Scope& scope);
  std::string text(const Node& node, const std::string& attribute, Scope& scope);
  Value evaluate_text(const std::string& text, Scope& scope);
  Value evaluate_expression(const std::string& expression, Scope& scope);
  Value evaluate_command(const std::string& command, Scope& scope);
  std::optional<Value> call_outside(const std::string& name, const std::vector<Value>& arguments, Scope& scope);
  Value argument_value(const std::string& name);
  std::string package(const std::string& name);
  /// A path that is relative to the file which is read, or else to that of the macro which names it.
  std::string resolved(const std::string& path);
  std::string read(const std::string& path);

  void require_attributes(const Node& node, const std::vector<std::string>& known) const;
  const std::string& required(const Node& node, const std::string& attribute) const;

  XacroOptions options_;
  PackageFolders packages_;
  std::map<std::string, std::string> arguments_;
  std::set<std::string> known_arguments_;
  std::vector<std::string> files_, notes_;
  std::vector<std::string> reading_;       ///< the files that include one another now, the innermost last
  std::vector<std::string> current_file_;  ///< whose elements are evaluated now
  int depth_ = 0;                          ///< of elements and macros in one another
  int evaluations_ = 0;                    ///< of expressions in one another
  std::size_t made_ = 0;
};

}  // namespace torsor::xacro
