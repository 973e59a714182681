// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// What the configuration has for a freedom: its coordinate; the four components of a unit quaternion with the first of
/// the three freedoms that turn it, and nothing with the other two. The freedoms of a scene taken in order of
/// declaration give the positions in the one order that everything lists them in: q[i] of a generated header, pages,
/// lists.
std::vector<SymbolPointer> positions_with(const SceneContent& scene, const CoordinateContent& freedom);

}  // namespace torsor
