// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// Looks whether the inertia of a body of the scene can be that of matter. Always: it depends on no coordinate and not
/// on time. Where all its parameters have values: mass ≥ 0, and the principal moments about G satisfy A + B ≥ C, which
/// holds for positive masses because A + B − C = 2 ∫ z² dm; equality (points, rods, plates) is allowed, and so is an
/// error of 10⁻⁵ of the largest, since values are given with some six figures. A moment written as a literal zero is
/// one that was left out, as is usual in plane motion: then, and of moments that are taken as given, only negative ones
/// are refused. Of moments as they were read from a file none is refused. A reflected inertia is one number, not negative.
/// Throws SceneError naming the body and the values.
void check_inertia(const SceneContent& scene, const BodyContent& body);

}  // namespace torsor
