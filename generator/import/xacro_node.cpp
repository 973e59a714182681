// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_node.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include "torsor/generator/base/entities.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor::xacro {
namespace {

Node converted(const tinyxml2::XMLElement& element, const std::shared_ptr<const std::string>& file) {
  Node node;
  node.tag = element.Name();
  node.file = file;
  node.line = element.GetLineNum();
  for (const auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    node.attributes.emplace_back(each->Name(), each->Value());
  }
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    node.children.push_back(converted(*child, file));
  }
  return node;
}

std::string escaped(const std::string& text) { return with_entities(text, "&<>\"\n\r\t"); }

void write(const Node& node, int depth, std::string& text, std::vector<XmlLine>& lines) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  text += indent + "<" + node.tag;
  for (const auto& [name, value] : node.attributes) text += fmt::format(" {}=\"{}\"", name, escaped(value));
  text += node.children.empty() ? "/>\n" : ">\n";
  lines.push_back({*node.file, node.line, node.within});
  if (node.children.empty()) return;
  for (const Node& child : node.children) write(child, depth + 1, text, lines);
  text += indent + "</" + node.tag + ">\n";
  lines.push_back(lines.back());
}

}  // namespace

const std::string* Node::attribute(const std::string& name) const {
  for (const auto& [each, value] : attributes) {
    if (each == name) return &value;
  }
  return nullptr;
}

void Node::set(const std::string& name, const std::string& value) {
  for (auto& [each, old] : attributes) {
    if (each != name) continue;
    old = value;
    return;
  }
  attributes.emplace_back(name, value);
}

std::string Node::label() const {
  const std::string* name = attribute("name");
  return name == nullptr ? "<" + tag + ">" : fmt::format("<{} name=\"{}\">", tag, *name);
}

void Node::fail(const std::string& message) const {
  throw FileError(
      fmt::format("{}:{}: {}: {}{}", *file, line, label(), message, within.empty() ? "" : " (" + within + ")"));
}

Node read_nodes(const std::string& text, const std::string& file) {
  const XmlFile checked(text, file);
  return converted(checked.element(), std::make_shared<const std::string>(file));
}

std::pair<std::string, std::vector<XmlLine>> write_nodes(const Node& root) {
  std::pair<std::string, std::vector<XmlLine>> written;
  write(root, 0, written.first, written.second);
  return written;
}

}  // namespace torsor::xacro
