// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/import/mechanism_file.hpp"

#include <utility>

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/import/xacro_node.hpp"

namespace torsor {
namespace {

/// What a shell would take apart, in single quotes.
std::string one_word(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string root_element(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos && at + 1 < text.size();
       at = text.find('<', at + 1)) {
    if (text.substr(at, 4) == "<!--") {
      at = text.find("-->", at);
      if (at == std::string_view::npos) return "";
      continue;
    }
    if (text[at + 1] == '?' || text[at + 1] == '!') continue;
    const std::size_t end = text.find_first_of(" \t\r\n/>", at + 1);
    return std::string(text.substr(at + 1, end == std::string_view::npos ? end : end - at - 1));
  }
  return "";
}

MechanismFile read_mechanism_file(const std::string& path, const UrdfOptions& options, const XacroOptions& xacro) {
  const std::string text = xacro::text_of_file(path);
  if (!is_xacro(path, text)) {
    if (!xacro.arguments.empty())
      throw UsageError(fmt::format("--arg is for xacro files; '{}' has no xacro element", path));
    return {read_urdf_text(text, path, options), {}};
  }
  const ExpandedXacro expanded = expand_xacro(text, path, xacro);
  UrdfOptions with_arguments = options;
  for (const auto& [name, value] : xacro.arguments) {
    with_arguments.file_arguments += " --arg " + one_word(name + ":=" + value);
  }
  return {read_urdf_text(expanded.text, path, with_arguments, expanded.lines), expanded.files};
}

std::string dependency_rule(const std::string& target, const std::vector<std::string>& files) {
  const auto escaped = [](const std::string& path) {
    std::string text;
    for (const char c : path) {
      if (c == ' ' || c == '#') text += '\\';
      if (c == '$') text += '$';
      text += c;
    }
    return text;
  };
  std::string rule = escaped(target) + ":";
  for (const std::string& file : files) rule += " \\\n  " + escaped(file);
  return rule + "\n";
}

}  // namespace torsor
