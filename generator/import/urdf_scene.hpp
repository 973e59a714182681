// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// Makes a scene of a robot that was read: settles its tree and its base, fixes the joints that the options name, and
/// refuses what was noted when they are strict. See read_urdf for the scene and for the errors.
ImportedRobot make_scene(UrdfRobot robot, const UrdfOptions& options);

}  // namespace torsor
