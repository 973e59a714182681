// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/mechanism_file.hpp"

#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/import/mjcf_files.hpp"
#include "torsor/generator/import/text_of_file.hpp"

namespace torsor {
namespace {

void refuse_arguments(const std::string& path, const MechanismFileOptions& options) {
  if (options.xacro.arguments.empty()) return;
  throw UsageError(fmt::format("--arg is for xacro files; '{}' has no xacro element", path));
}

MechanismFile read_mjcf_file(const std::string& path, const MechanismFileOptions& options) {
  refuse_arguments(path, options);
  const UrdfOptions& given = options.urdf;
  if (given.base == UrdfBase::floating) {
    throw UsageError(fmt::format("--base floating is for URDF; write <freejoint/> in the first body of '{}'", path));
  }
  if (!given.fix.empty()) {
    throw UsageError(fmt::format("--fix is for URDF; take the <joint> of '{}' out of its body in '{}'", given.fix.front(), path));
  }
  if (!given.armature.empty() || given.run_time_gravity) {
    throw UsageError(fmt::format(
        "--armature and --run-time-gravity are for URDF; in '{}' armature is an attribute of <joint>", path));
  }
  if (!given.contacts.named.empty()) throw UsageError(fmt::format("--contacts is for URDF; '{}' is MJCF", path));
  if (options.mjcf_reader == nullptr) {
    throw FileError(
        fmt::format("{}: is MJCF, which this program was built without; install libmujoco-dev and build torsor "
                    "again",
                    path));
  }
  MjcfOptions mjcf;
  if (options.gravity_given) mjcf.gravity = given.gravity;
  mjcf.angle_tolerance = given.angle_tolerance;
  mjcf.strict = given.strict;
  mjcf.dampers = given.dampers;
  mjcf.motors = given.motors;
  mjcf.friction = given.friction;
  mjcf.friction_of_file = given.friction_of_file;
  mjcf.limits = given.limits;
  mjcf.ground = given.ground;
  mjcf.name = given.name;
  mjcf.points = given.points;
  mjcf.initial = given.initial;
  ImportedMjcf read = mjcf_scene(options.mjcf_reader(path), mjcf);
  if (read.scene.content().coordinates.empty()) {
    throw FileError(fmt::format("{}: no joint of the model '{}' moves, so there is nothing to derive; give a body a <joint> or "
                                "a <freejoint/>",
                                path, read.scene.name()));
  }
  return {{std::move(read.scene), {}, {}}, mjcf_files(path), std::move(read.notes)};
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

MechanismFile read_mechanism_file(const std::string& path, const MechanismFileOptions& options) {
  const std::string text = text_of_file(path);
  if (root_element(text) == "mujoco") return read_mjcf_file(path, options);
  if (!is_xacro(path, text)) {
    refuse_arguments(path, options);
    ImportedRobot robot = read_urdf_text(text, path, options.urdf);
    std::vector<std::string> notes = std::move(robot.notes);
    return {std::move(robot), {}, std::move(notes)};
  }
  const ExpandedXacro expanded = expand_xacro(text, path, options.xacro);
  UrdfOptions with_arguments = options.urdf;
  for (const auto& [name, value] : options.xacro.arguments) {
    with_arguments.file_arguments += " --arg " + shell_word(name + ":=" + value);
  }
  ImportedRobot robot = read_urdf_text(expanded.text, path, with_arguments, expanded.lines);
  std::vector<std::string> notes = expanded.notes;
  notes.insert(notes.end(), robot.notes.begin(), robot.notes.end());
  return {std::move(robot), expanded.files, std::move(notes)};
}

std::string dependency_rule(const std::string& target, const std::vector<std::string>& files) {
  const auto escaped = [](const std::string& path) {
    if (path.find_first_of("\n\r") != std::string::npos) {
      throw FileError(fmt::format("--depfile: no rule of make can name '{}', which holds the end of a line: rename it", path));
    }
    std::string text;
    for (const char c : path) {
      if (c == ' ' || c == '#' || c == ':') text += '\\';
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
