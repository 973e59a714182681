// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/import/urdf.hpp"
#include "generator/import/xacro.hpp"

namespace torsor {

/// A mechanism that was read, and what was read besides the file: included files, parameters.
struct MechanismFile {
  ImportedRobot robot;
  std::vector<std::string> files;
};

/// Name of the first element of an XML text ("robot", "mujoco"); empty when there is none.
std::string root_element(std::string_view text);

/// Reads a URDF file, or a xacro file that makes one (is_xacro). The arguments that xacro was given become part of the
/// scene's origin. Throws as read_urdf and expand_xacro do; UsageError for xacro's options on a file that is none.
MechanismFile read_mechanism_file(const std::string& path, const UrdfOptions& options, const XacroOptions& xacro);

/// A rule of make that says what a target is made of: "target: file other\ file".
std::string dependency_rule(const std::string& target, const std::vector<std::string>& files);

}  // namespace torsor
