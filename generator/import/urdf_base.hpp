// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// The root link and what it is to the ground.
struct SettledBase {
  std::string root;
  UrdfBase base = UrdfBase::fixed;
  std::optional<UrdfPlacement> start{};  ///< of a base that floats, where the file holds it
};

/// What a floating base means where the file frees the robot itself, or holds it by a link "world":
///  * floating joints that leave a root without mass, or a root "world", are the base: it stays fixed;
///  * a root "world" without mass that one fixed joint holds the robot by is left out, and its child floats from
///    where that joint held it.
/// The robot's remarks tell which.
SettledBase settle_base(UrdfRobot& robot, const std::string& root, UrdfBase wanted);

}  // namespace torsor
