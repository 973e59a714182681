// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/import/xacro_expander.hpp"

namespace torsor {

bool is_xacro(const std::string& path, std::string_view text) {
  if (path.ends_with(".xacro")) return true;
  if (text.find("<xacro:") != std::string_view::npos) return true;
  return text.find("xmlns:xacro") != std::string_view::npos && text.find("${") != std::string_view::npos;
}

ExpandedXacro expand_xacro(std::string_view text, const std::string& path, const XacroOptions& options) {
  xacro::Expander expander(path, options);
  const xacro::Node root = expander.expand(xacro::read_nodes(std::string(text), path));
  expander.refuse_unknown_arguments();
  ExpandedXacro expanded;
  std::tie(expanded.text, expanded.lines) = xacro::write_nodes(root);
  expanded.files = expander.files();
  expanded.notes = expander.notes();
  return expanded;
}

}  // namespace torsor
