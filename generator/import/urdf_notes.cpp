// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_notes.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/import/command_words.hpp"
#include "torsor/generator/import/origin_notes.hpp"

namespace torsor {
namespace {

/// A decimal for people.
std::string decimal(const Number& value) { return shortest(value.to_double()); }

/// What makes the same scene again: the file and the options that are not at their defaults.
std::string arguments(const UrdfRobot& robot, const UrdfOptions& options) {
  const UrdfOptions defaults;
  std::string text = file_word(name_of_file(robot.file)) + options.file_arguments;
  if (options.base == UrdfBase::floating) text += " --base floating";
  if (options.gravity != defaults.gravity) {
    text += fmt::format(" --gravity {},{},{}", number_word(options.gravity[0]), number_word(options.gravity[1]),
                        number_word(options.gravity[2]));
  }
  if (!(options.angle_tolerance == defaults.angle_tolerance)) {
    text += " --angle-tolerance " + number_word(options.angle_tolerance);
  }
  if (!options.dampers) text += " --no-dampers";
  if (!options.motors) text += " --no-motors";
  if (options.run_time_gravity) text += " --run-time-gravity";
  text += joint_numbers("--armature", options.armature);
  text += joint_numbers("--friction", options.friction, options.friction_of_file ? "file" : "");
  if (options.limits) text += " --limits";
  text += surface_words("--ground", options.ground) + surface_words("--contacts", options.contacts);
  if (!options.fix.empty()) text += " --fix " + shell_word(fmt::format("{}", fmt::join(options.fix, ",")));
  if (!options.name.empty()) text += " --name " + shell_word(options.name);
  if (!options.points.empty()) text += " --points " + shell_word(fmt::format("{}", fmt::join(options.points, ",")));
  std::string initial;
  for (const auto& [name, value] : options.initial) initial += (initial.empty() ? "" : ",") + name + "=" + value;
  if (!initial.empty()) text += " --initial " + shell_word(initial);
  return text;
}

/// "elbow: friction 0.1"; empty when everything that the file states is in the scene.
std::string data_line(const UrdfJointData& data) {
  std::vector<std::string> parts;
  if (data.coordinate.empty()) {  // no coordinate holds its limits
    if (data.lower) parts.push_back("at least " + decimal(*data.lower));
    if (data.upper) parts.push_back("at most " + decimal(*data.upper));
    if (data.velocity) parts.push_back("velocity at most " + decimal(*data.velocity));
    if (data.effort) parts.push_back("effort at most " + decimal(*data.effort));
  }
  if (data.damping && !data.damping->is_zero() && !data.damping_acts) {
    parts.push_back("damping " + decimal(*data.damping));
  }
  if (data.friction && !data.friction->is_zero() && !data.friction_acts) parts.push_back("friction " + decimal(*data.friction));
  return parts.empty() ? "" : fmt::format("{}: {}", data.joint, fmt::join(parts, ", "));
}

}  // namespace

SceneOrigin urdf_origin(const UrdfRobot& robot, const UrdfOptions& options, const std::vector<UrdfJointData>& joints,
                        const std::vector<std::string>& renamed) {
  SceneOrigin origin{printable(name_of_file(robot.file)), arguments(robot, options), {}, robot.file, options.package_folders};
  append_notes(origin.notes, "Noted while reading (--strict refuses it):", robot.notes.lines());
  append_notes(origin.notes, "Understood while reading:", robot.remarks);
  append_notes(origin.notes, "Names that became identifiers:", renamed);
  std::vector<std::string> exact = robot.changes.lines();
  if (!robot.exact_together.empty()) exact.push_back(robot.exact_together);
  append_notes(origin.notes, "Angles and axes that were made exact:", exact);
  append_notes(origin.notes, "Angles that look exact and are not:", robot.almost);
  std::vector<std::string> data;
  for (const UrdfJointData& joint : joints) {
    if (std::string line = data_line(joint); !line.empty()) data.push_back(std::move(line));
  }
  append_notes(origin.notes, "Stated of joints, in SI, and not in the kernels:", data);
  append_notes(origin.notes, "Stated of joints and without effect:", robot.without_effect);
  return origin;
}

}  // namespace torsor
