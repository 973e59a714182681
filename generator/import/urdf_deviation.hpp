// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// What making angles exact adds up to.
struct UrdfDeviation {
  double sum = 0;    ///< [rad], the largest of all links
  std::string link;  ///< that link
};

/// Sum of |δ| over what was made exact by `size` or less between the root and each link, its own moments of inertia
/// included: δ of a turn by its angle, 2 δ of an axis that turns by δ, since R' = D R Dᵀ, and of a mimic its offset's and
/// its leader's times the multiplier. A link's attitude, and with it all that its mass does in any joint, is that of the
/// file within this angle. The robot need not be a tree yet.
UrdfDeviation largest_deviation(const UrdfRobot& robot, double size);

/// A tolerance for each angle with which all of them stay within `allowed` by largest_deviation: the sizes from the
/// smallest on, as many as fit; below `tolerance`, with which they do not.
Number smaller_tolerance(const UrdfRobot& robot, const Number& tolerance, double allowed);

}  // namespace torsor
