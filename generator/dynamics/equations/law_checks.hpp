// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// A part of `validate`: what a law of time gives to a joint, by a driven coordinate or in the displacement itself, has no jump
/// and none of its rate as far as `jumps_along` sees it, at the values that parameters have. At such a place the acceleration
/// is an impulse, which no equation of motion has. Throws SceneError naming the coordinate, or the joint, and the law.
void check_laws_of_time(const Scene& scene);

}  // namespace torsor
