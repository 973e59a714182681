// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// A part of `validate`: what a law gives to a joint, by a driven coordinate or in the displacement itself, has no jump and none
/// of its slope as far as `jumps_along` sees it, at the values that parameters have: along the time, and along coordinates where
/// the joint moves mass. At such a place the acceleration is an impulse, which no equation of motion has. Throws SceneError
/// naming the coordinate, or the joint, and the law.
void check_laws(const Scene& scene);

}  // namespace torsor
