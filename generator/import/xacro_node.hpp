// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/import/xml_element.hpp"

namespace torsor::xacro {

/// An element of a file, or one that was made of it. Text between elements means nothing in a robot and is left out.
struct Node {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Node> children;
  std::shared_ptr<const std::string> file;
  int line = 0;
  std::string within;  ///< "in the macro 'arm', called at robot.xacro:7" of what a macro made

  const std::string* attribute(const std::string& name) const;
  void set(const std::string& name, const std::string& value);
  /// "<joint name="elbow">".
  std::string label() const;
  /// Throws FileError "file:line: <element>: message (in the macro ...)".
  [[noreturn]] void fail(const std::string& message) const;
};

/// The elements of a file. Throws FileError when it cannot be read or is no XML.
Node read_nodes(const std::string& text, const std::string& file);

/// One element on each line, and where each line comes from.
std::pair<std::string, std::vector<XmlLine>> write_nodes(const Node& root);

}  // namespace torsor::xacro
