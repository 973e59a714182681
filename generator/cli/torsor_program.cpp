// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/torsor_program.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/cli/command_line.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/cli/new_project.hpp"
#include "torsor/generator/cli/scene_file.hpp"
#include "torsor/generator/import/mechanism_file.hpp"

namespace torsor {
namespace {

/// What touches, as it is written.
struct SurfacesRequest {
  std::vector<std::string> named;
  std::string friction, restitution;
};

/// The options as they are written.
struct FileRequest {
  std::string file;
  std::string base = "fixed";
  std::string gravity;
  std::string angle_tolerance = "1e-9";
  std::string name;
  std::vector<std::string> points, initial, fix, armature, friction, arguments, package_folders;
  SurfacesRequest ground, contacts;
  std::string dependency_file;
  SourceFiles files;  ///< of the command: what was read, the rule of make
  bool no_dampers = false;
  bool no_motors = false;
  bool run_time_gravity = false;
  bool limits = false;
  bool accept_inertia = false;  ///< void
  bool strict = false;
  bool quiet = false;
};

void add_options(CLI::App& command, FileRequest& request) {
  command.add_option("FILE", request.file, "robot to read, a URDF, xacro or MJCF file")->required();
  command.add_option("--base", request.base, "root link: fixed (welded to the ground) or floating")
      ->capture_default_str();
  command.add_option("--gravity", request.gravity,
                     "X,Y,Z in m/s^2, along the ground's axes; 0,0,-9.81 when absent, or what an MJCF file says");
  command
      .add_option("--angle-tolerance", request.angle_tolerance, "angles near multiples of pi/12 become these multiples; the changes from the root to any link add up to this at most [rad]")
      ->capture_default_str();
  command.add_option("--name", request.name, "name of the scene; that of the robot when absent");
  command.add_option("--points", request.points, "links whose origins are points, with Jacobians; comma-separated, or all")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--initial", request.initial, "state at t = 0, NAME=VALUE, rates NAME'=VALUE; comma-separated")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--arg", request.arguments, "value of an argument of a xacro file, NAME:=VALUE; may be given again")
      ->allow_extra_args(false);
  command
      .add_option("--package-path", request.package_folders,
                  "folders of packages that $(find ...) and meshes name, colon-separated; looked at before ROS_PACKAGE_PATH")
      ->delimiter(':')->allow_extra_args(false);
  command.add_option("--depfile", request.dependency_file,
                     "write the files that were read as a rule of make; the target is this name without its .d");
  command.add_flag("--no-dampers", request.no_dampers, "leave out the dampers of <dynamics damping>");
  command.add_flag("--no-motors", request.no_motors, "leave out the input torques and forces of the joints");
  command.add_option("--fix", request.fix, "joints that become fixed, comma-separated, or massless: those that move no mass")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--armature", request.armature,
                     "reflected inertia of rotors, JOINT=NUMBER in kg m^2 (kg where the joint slides); comma-separated")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--friction", request.friction,
                     "dry friction in joints, JOINT=NUMBER in N m (N where the joint slides), or file: that of <dynamics "
                     "friction>, in MJCF of frictionloss; comma-separated")
      ->delimiter(',')->allow_extra_args(false);
  command.add_flag("--limits", request.limits, "make <limit lower upper> of the joints stops, in MJCF their range");
  command.add_option("--ground", request.ground.named,
                     "links whose <collision> spheres, boxes and cylinders touch the ground z = 0; in MJCF bodies whose geoms touch "
                     "the planes of the file; comma-separated")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--ground-friction", request.ground.friction,
                     "value of the run-time parameter ground_friction; 0.5 when absent");
  command.add_option("--ground-restitution", request.ground.restitution,
                     "value of the run-time parameter ground_restitution; 0 when absent");
  command.add_option("--contacts", request.contacts.named,
                     "pairs of links whose <collision> spheres meet, A:B; A:B+z: those of A, and corners and rims, meet the "
                     "plane of that face of B's box or cylinder; comma-separated")
      ->delimiter(',')->allow_extra_args(false);
  command.add_option("--contacts-friction", request.contacts.friction,
                     "value of the run-time parameter contacts_friction; 0.5 when absent");
  command.add_option("--contacts-restitution", request.contacts.restitution,
                     "value of the run-time parameter contacts_restitution; 0 when absent");
  command.add_flag("--run-time-gravity", request.run_time_gravity,
                   "make the components of gravity the run-time parameters gravity_x, gravity_y, gravity_z");
  command.add_flag("--strict", request.strict, "make the first note an error: elements that cannot act, inertia that no matter has");
  command.add_flag("--quiet", request.quiet, "print no notes on the standard error; headers quote them all the same");
  command.add_flag("--accept-inertia", request.accept_inertia,
                   "void: moments of inertia that no matter has are taken as given, with a note");
}

Number option_number(const std::string& option, const std::string& text) {
  try {
    return parse_decimal(text);
  } catch (const Error& error) {
    throw UsageError(fmt::format("{}: {}", option, error.what()));
  }
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

using JointNumbers = std::vector<std::pair<std::string, Number>>;

/// JOINT=NUMBER, each joint once.
void add_joint_number(JointNumbers& all, const std::string& option, const std::string& assignment) {
  const std::vector<std::string> parts = split(assignment, '=');
  if (parts.size() != 2) {
    throw UsageError(fmt::format("{} takes JOINT=NUMBER, e.g. elbow=0.1, and got '{}'", option, assignment));
  }
  for (const auto& [joint, number] : all) {
    if (joint == parts[0]) throw UsageError(fmt::format("{} names the joint '{}' twice: give it one number", option, joint));
  }
  all.emplace_back(parts[0], option_number(option, parts[1]));
}

/// Of an option that names what touches.
Surfaces surfaces(const SurfacesRequest& request, const std::string& option, const char* what) {
  Surfaces all;
  all.named = request.named;
  const auto read = [&](const std::string& text, const std::string& suffix, Number& to) {
    if (text.empty()) return;
    if (all.named.empty()) throw UsageError(fmt::format("{}{} is of the {} in {}: name them", option, suffix, what, option));
    to = option_number(option + suffix, text);
  };
  read(request.friction, "-friction", all.friction);
  read(request.restitution, "-restitution", all.restitution);
  return all;
}

UrdfOptions urdf_options(const FileRequest& request) {
  UrdfOptions options;
  if (request.base == "floating") {
    options.base = UrdfBase::floating;
  } else if (request.base != "fixed") {
    throw UsageError(fmt::format("unknown base '{}' in --base: {}use fixed or floating", request.base,
                                 did_you_mean(request.base, {"fixed", "floating"})));
  }
  if (!request.gravity.empty()) {
    const std::vector<std::string> gravity = split(request.gravity, ',');
    if (gravity.size() != 3) {
      throw UsageError(fmt::format("--gravity takes three numbers, X,Y,Z, and got '{}'", request.gravity));
    }
    for (std::size_t i = 0; i < 3; ++i) options.gravity[i] = option_number("--gravity", gravity[i]);
  }
  options.angle_tolerance = option_number("--angle-tolerance", request.angle_tolerance);
  options.dampers = !request.no_dampers;
  options.motors = !request.no_motors;
  options.strict = request.strict;
  options.fix = request.fix;
  options.run_time_gravity = request.run_time_gravity;
  for (const std::string& word : request.armature) add_joint_number(options.armature, "--armature", word);
  for (const std::string& word : request.friction) {
    if (word == "file") {
      options.friction_of_file = true;
    } else {
      add_joint_number(options.friction, "--friction", word);
    }
  }
  options.limits = request.limits;
  options.ground = surfaces(request.ground, "--ground", "links");
  options.contacts = surfaces(request.contacts, "--contacts", "pairs");
  options.name = request.name;
  options.points = request.points;
  options.package_folders = request.package_folders;
  std::set<std::string> given;
  for (const std::string& assignment : request.initial) {
    const std::vector<std::string> parts = split(assignment, '=');
    if (parts.size() != 2) {
      throw UsageError(fmt::format("--initial takes NAME=VALUE, e.g. elbow=0.3, and got '{}'", assignment));
    }
    take_once(given, "--initial", parts[0]);
    options.initial.emplace_back(parts[0], parts[1]);
  }
  return options;
}

XacroOptions xacro_options(const FileRequest& request) {
  XacroOptions options;
  options.package_folders = request.package_folders;
  std::set<std::string> given;
  for (const std::string& assignment : request.arguments) {
    const std::size_t mark = assignment.find(":=");
    if (mark == std::string::npos || mark == 0) {
      throw UsageError(fmt::format("--arg takes NAME:=VALUE, e.g. prefix:=left_, and got '{}'", assignment));
    }
    take_once(given, "--arg", assignment.substr(0, mark));
    options.arguments.emplace_back(assignment.substr(0, mark), assignment.substr(mark + 2));
  }
  return options;
}

Scene read_scene(FileRequest& request, MjcfReader mjcf_reader) {
  MechanismFile read = read_mechanism_file(
      request.file, {urdf_options(request), xacro_options(request), !request.gravity.empty(), mjcf_reader});
  request.files.read = read.files;
  request.files.read.insert(request.files.read.begin(), request.file);
  if (!request.dependency_file.empty()) {
    std::string target = request.dependency_file;
    if (!target.ends_with(".d") || target.size() == 2) {
      throw UsageError(fmt::format("--depfile takes the target's name with .d behind it, and got '{}'", target));
    }
    target.resize(target.size() - 2);
    request.files.written = {{request.dependency_file, dependency_rule(target, request.files.read)}};
  }
  if (!request.quiet) {
    for (const std::string& note : read.notes) std::fprintf(stderr, "note: %s\n", printable(note).c_str());
  }
  Scene& scene = read.robot.scene;
  if (scene.content().coordinates.empty()) {
    throw FileError(fmt::format("{}: no joint of the robot '{}' moves, so there is nothing to derive; --base floating frees "
                                "its root link",
                                request.file, scene.name()));
  }
  return std::move(scene);
}

/// torsor SCENE.cpp COMMAND, torsor COMMAND SCENE.cpp: this process becomes the scene's program, named as its file is.
int become_scene_program(int argc, const char* const* argv, int file) {
  try {
    const std::string program = scene_file_program(argv[file]);
    std::vector<char*> arguments{const_cast<char*>(argv[file])};
    for (int i = 1; i < argc; ++i) {
      if (i != file) arguments.push_back(const_cast<char*>(argv[i]));
    }
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    throw FileError(fmt::format("cannot run '{}': {}", program, std::strerror(errno)));
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", printable(fmt::format("{}: {}", argv[0], error.what())).c_str());
    return 3;
  }
}

/// torsor new NAME
int begin_project(int argc, const char* const* argv) {
  const auto fail = [argv](const std::string& message, int code) {
    std::fprintf(stderr, "%s\n", printable(fmt::format("{}: {}", argv[0], message)).c_str());
    return code;
  };
  if (argc != 3 || argv[2][0] == '-') return fail("new takes the name of the project, which becomes a folder: torsor new NAME", 2);
  try {
    for (const std::string& file : write_new_project(argv[2])) std::printf("%s\n", file.c_str());
    return 0;
  } catch (const SceneError& error) {
    return fail(error.what(), 2);
  } catch (const Error& error) {
    return fail(error.what(), 3);
  }
}

/// The file may stand before the command, as a scene's may.
std::vector<const char*> command_first(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  const auto names_robot = [](std::string_view word) {
    return word.ends_with(".urdf") || word.ends_with(".xacro") || word.ends_with(".mjcf") || word.ends_with(".xml");
  };
  if (argc > 2 && argv[2][0] != '-' && names_robot(argv[1])) std::swap(words[1], words[2]);
  return words;
}

}  // namespace

int run_torsor(int argc, const char* const* argv, MjcfReader mjcf_reader) {
  if (argc > 1 && std::string(argv[1]) == "new") return begin_project(argc, argv);
  for (int i = 1; i < argc && i < 3; ++i) {
    if (argv[i][0] != '-' && names_scene_file(argv[i])) return become_scene_program(argc, argv, i);
  }
  FileRequest request;
  const std::vector<const char*> words = command_first(argc, argv);
  return run_commands(argc, words.data(),
                      {"Equations of motion and specialised kernels of the robot of a URDF, xacro or MJCF file. "
                       "torsor SCENE.cpp COMMAND compiles a scene in C++ and runs the command. torsor new NAME begins a "
                       "project with a scene of your own.",
                       [&request](CLI::App& command) { add_options(command, request); },
                       [&] { return read_scene(request, mjcf_reader); }, [&request] { return request.quiet; },
                       [&request] { return request.files; },
                       {{"new NAME", "Begins a project: a folder with a scene of your own."}}});
}

}  // namespace torsor
