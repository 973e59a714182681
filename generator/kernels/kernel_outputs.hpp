// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"

// What a model of a simulator gives beside its motion, and nothing else: kernels of what was asked for by name, with exact
// derivatives along the state and by run-time parameters.

namespace torsor {

/// By names of the scene.
struct OutputNames {
  std::vector<std::string> points, frames;
  std::vector<std::string> reactions;  ///< released coordinates

  bool places() const { return !points.empty() || !frames.empty(); }
};

/// In ground axes: of each point its position, of each frame the position of its origin, then, row by row, the rotation
/// from its axes to the ground's. Throws SceneError for a name that is none.
std::vector<Value> output_places(const Equations& equations, const OutputNames& names);
/// They as an array.
Kernel make_output_places(const Equations& equations, const OutputNames& names);
/// Their derivatives by the configuration and by run-time parameters.
Kernel make_output_place_derivatives(const Equations& equations, const OutputNames& names);

/// Derivatives of T and U by the configuration and by run-time parameters, of T by velocities.
Kernel make_energy_derivatives(const Equations& equations);

/// Reactions against released coordinates as an array.
Kernel make_output_reactions(const Equations& equations, const OutputNames& names);
/// Their partial derivatives: each of what they depend on by itself, accelerations and multipliers among them.
Kernel make_output_reaction_derivatives(const Equations& equations, const OutputNames& names);

}  // namespace torsor
