// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {

/// Of the axes of joints: none is null, and those of a universal joint are perpendicular.
std::vector<SizeBound> bounds_of_axes(const SceneContent& scene);

}  // namespace torsor
