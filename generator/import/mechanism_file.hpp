// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/xacro.hpp"

namespace torsor {

/// What makes a model of an MJCF file: read_with_mujoco, where a program is linked to it.
using MjcfReader = MjcfModel (*)(const std::string& path);

/// How a file becomes a scene. What MJCF has too is taken from `urdf`: tolerance, dampers, motors, name, points, start.
struct MechanismFileOptions {
  UrdfOptions urdf;
  XacroOptions xacro;
  bool gravity_given = false;  ///< otherwise an MJCF file's own holds
  MjcfReader mjcf_reader = nullptr;
};

/// A mechanism that was read, and what was read besides the file: included files, parameters, meshes.
struct MechanismFile {
  ImportedRobot robot;
  std::vector<std::string> files;
  std::vector<std::string> notes;  ///< what an MJCF file says and does not act
};

/// Name of the first element of an XML text ("robot", "mujoco"); empty when there is none.
std::string root_element(std::string_view text);

/// Reads a URDF file, a xacro file that makes one (is_xacro), or an MJCF file (its first element is <mujoco>). The
/// arguments that xacro was given become part of the scene's origin. Throws as read_urdf, expand_xacro and mjcf_scene
/// do; UsageError for options that are not for this kind of file, FileError for MJCF without a reader.
MechanismFile read_mechanism_file(const std::string& path, const MechanismFileOptions& options);

/// A rule of make that says what a target is made of: "target: file other\ file".
std::string dependency_rule(const std::string& target, const std::vector<std::string>& files);

}  // namespace torsor
