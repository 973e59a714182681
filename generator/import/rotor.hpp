// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/mechanics/scene.hpp"

namespace torsor {

/// A rotor at rest in the ground but for the displacement e of a joint: T = ½ a ė², reflected inertia a. Along a slide it is
/// a wheel of radius 1 m, which has no weight.
void add_rotor(Scene& scene, const std::string& frame, const Expression& displacement, bool turns, const Expression& armature);

}  // namespace torsor
