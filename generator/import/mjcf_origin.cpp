// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/import/mjcf_origin.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/expression/decimal.hpp"

namespace torsor {
namespace {

std::string number_text(const Number& value) { return shortest(value.to_double()); }

/// In single quotes where a shell would take it apart.
std::string word_of_shell(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./=,+").find(c) != std::string_view::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string options_text(const MjcfOptions& options) {
  const MjcfOptions defaults;
  std::string text;
  if (options.gravity) {
    const auto& g = *options.gravity;
    text += fmt::format(" --gravity {},{},{}", number_text(g[0]), number_text(g[1]), number_text(g[2]));
  }
  if (!(options.angle_tolerance == defaults.angle_tolerance)) {
    text += " --angle-tolerance " + number_text(options.angle_tolerance);
  }
  if (!options.dampers) text += " --no-dampers";
  if (!options.motors) text += " --no-motors";
  if (!options.name.empty()) text += " --name " + options.name;
  if (!options.points.empty()) text += " --points " + word_of_shell(fmt::format("{}", fmt::join(options.points, ",")));
  std::string initial;
  for (const auto& [name, value] : options.initial) initial += (initial.empty() ? "" : ",") + name + "=" + value;
  if (!initial.empty()) text += " --initial " + word_of_shell(initial);
  return text;
}

void append_lines(std::vector<std::string>& notes, const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  notes.push_back(title);
  for (const std::string& line : lines) notes.push_back("  " + line);
}

}  // namespace

SceneOrigin mjcf_origin(const MjcfModel& model, const MjcfOptions& options, const MjcfHead& head) {
  const std::string file = model.file.substr(model.file.find_last_of("/\\") + 1);
  SceneOrigin origin{file, word_of_shell(file) + options_text(options), {}};
  append_lines(origin.notes, "Names that became identifiers:", head.renamed);
  append_lines(origin.notes, "Angles and axes that were made exact:", head.changed);
  append_lines(origin.notes, "Stated, in SI, and not in the kernels:", head.data);
  append_lines(origin.notes, "In the file and without effect:", head.notes);
  return origin;
}

}  // namespace torsor
