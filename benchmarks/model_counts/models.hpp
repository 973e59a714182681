// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Serial chains of revolute joints read from a JSON file {"gravity": [x, y, z], "models": [{"name", "joints": [{"R": 9
/// numbers row by row, "p": origin, "axis": "x", "y" or "z", "mass", "com", "inertia": xx, xy, xz, yy, yz, zz}]}]} in SI
/// units, inertia about the centre of mass, R from the joint's axes to its parent's. Throws FileError or SceneError
/// naming the file, the model and the entry.
std::vector<Scene> read_models(const std::string& path);

}  // namespace torsor
