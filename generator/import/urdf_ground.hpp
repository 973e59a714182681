// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/import/urdf_collisions.hpp"

namespace torsor {

/// Contacts of the links that `ground` names with the ground's plane z = 0, from their <collision> elements:
/// a sphere touches as it is, a box with its corners, a cylinder with its two rims. Throws
/// UsageError for a link that is unknown or has none, FileError for a form that cannot touch a plane.
void add_ground(const UrdfContactScene& around, const Surfaces& ground);

}  // namespace torsor
