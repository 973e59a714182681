// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/generator/import/xml_element.hpp"

namespace torsor {

/// What the command line says to a xacro file.
struct XacroOptions {
  std::vector<std::pair<std::string, std::string>> arguments;  ///< values of <xacro:arg>: {"prefix", "left_"}
  std::vector<std::string> package_folders;                    ///< packages of $(find ...), or folders that hold some
};

/// A xacro file with its macros expanded.
struct ExpandedXacro {
  std::string text;                ///< XML without any xacro element, an element on each line
  std::vector<XmlLine> lines;      ///< where each line of it comes from
  std::vector<std::string> files;  ///< what was read besides the file itself, in the order of reading
  std::vector<std::string> notes;  ///< of file names that may be meant otherwise
};

/// Whether a file is xacro: its name ends with .xacro, or its text has elements of xacro, or it declares their
/// namespace and has expressions.
bool is_xacro(const std::string& path, std::string_view text);

/// Expands a file in the language of ROS' xacro: properties (value, default, remove, scope; blocks), macros (defaults,
/// ^, ^|, blocks, local properties, namespaces, xacro:call), insert_block, include (relative to the file, $(find pkg),
/// patterns, ns), arg, if, unless, element, attribute; ${expressions} as generator/import/xacro_expression.hpp has
/// them;
/// $(arg), $(find), $(env), $(optenv), $(eval), $(dirname), $(cwd). A number that an expression computes is written as
/// Python writes it, the shortest decimal of the double: what xacro would give. What an expression in elements
/// that hold no mechanics (visual, collision, gazebo, transmission, ...) cannot say is left as it stands.
///
/// Throws FileError "file:line: <element>: what is wrong; what to do (in the macro 'm', called at file:line)": unknown
/// names, macros, parameters, arguments and packages, files that include themselves, macros that call themselves
/// without end. UsageError for an argument that no file declares.
ExpandedXacro expand_xacro(std::string_view text, const std::string& path, const XacroOptions& options = {});

}  // namespace torsor
