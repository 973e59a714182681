// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// How far a joint turns or slides: multiplier · q + offset + offset_twelfths π/12, q being the leader's coordinate.
struct UrdfDisplacement {
  const UrdfJoint* leader = nullptr;  ///< the joint itself, or what it mimics in the end; null: the joint is held
  Number multiplier{1}, offset, offset_twelfths;
};

/// The displacements of all joints that turn or slide, by name; mimics of mimics are followed to the end, each joint once.
/// Throws FileError when a multiplier is beyond the range of a double.
std::map<std::string, UrdfDisplacement> displacements(const UrdfRobot& robot);

}  // namespace torsor
