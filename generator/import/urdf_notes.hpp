// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// Where a scene made of that robot comes from: the file's name without any folder, the arguments that make the scene
/// again (the file and the options that are not at their defaults) and notes on renamed parts, changed angles, limits,
/// damping and friction, what was noted while reading, and what has no effect.
SceneOrigin urdf_origin(const UrdfRobot& robot, const UrdfOptions& options, const std::vector<UrdfJointData>& joints,
                        const std::vector<std::string>& renamed);

}  // namespace torsor
