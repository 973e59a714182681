// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

struct Rotor {
  Expression displacement;  ///< e of the joint
  bool turns = true;        ///< whether that is an angle
  Expression armature;      ///< a, the reflected inertia [kg m², of a slide kg]
};

/// A rotor at rest in the ground but for the displacement e of a joint: T = ½ a ė². Along a slide it is a wheel of radius
/// 1 m, which has no weight.
void add_rotor(Scene& scene, const std::string& frame, const Rotor& rotor);

}  // namespace torsor
