// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/mjcf_origin.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/import/command_words.hpp"
#include "torsor/generator/import/origin_notes.hpp"

namespace torsor {
namespace {

std::string options_text(const MjcfOptions& options) {
  const MjcfOptions defaults;
  std::string text;
  if (options.gravity) {
    const auto& g = *options.gravity;
    text += fmt::format(" --gravity {},{},{}", number_word(g[0]), number_word(g[1]), number_word(g[2]));
  }
  if (!(options.angle_tolerance == defaults.angle_tolerance)) {
    text += " --angle-tolerance " + number_word(options.angle_tolerance);
  }
  if (!options.dampers) text += " --no-dampers";
  if (!options.motors) text += " --no-motors";
  text += joint_numbers("--friction", options.friction, options.friction_of_file ? "file" : "");
  if (options.limits) text += " --limits";
  text += surface_words("--ground", options.ground);
  if (!options.name.empty()) text += " --name " + shell_word(options.name);
  if (!options.points.empty()) text += " --points " + shell_word(fmt::format("{}", fmt::join(options.points, ",")));
  std::string initial;
  for (const auto& [name, value] : options.initial) initial += (initial.empty() ? "" : ",") + name + "=" + value;
  if (!initial.empty()) text += " --initial " + shell_word(initial);
  return text;
}

}  // namespace

SceneOrigin mjcf_origin(const MjcfModel& model, const MjcfOptions& options, const MjcfHead& head) {
  const std::string file = name_of_file(model.file);
  SceneOrigin origin{printable(file), file_word(file) + options_text(options), {}, model.file, {}};
  append_notes(origin.notes, "Names that became identifiers:", head.renamed);
  append_notes(origin.notes, "Angles and axes that were made exact:", head.changed);
  append_notes(origin.notes, "Stated, in SI, and not in the kernels:", head.data);
  append_notes(origin.notes, "In the file and without effect:", head.notes);
  return origin;
}

}  // namespace torsor
