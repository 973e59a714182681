// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor {

/// Which theorem is asked for, in the words of a command line.
struct TheoremRequest {
  std::string kind = "resultant";   ///< resultant, moment or energy
  std::vector<std::string> bodies;  ///< all of the scene when empty
  std::string point;                ///< where moments are taken: a point, or a frame for its origin
  std::string direction = "x";      ///< x, y, z or three formulas "0,1,cos(theta)", along `axes`
  std::string axes = "ground";
  std::string observer = "ground";  ///< the frame R from which motion is seen
};

/// The point of that name, or the origin of the frame of that name, which becomes a point of the scene. A name that is
/// neither is returned as it is: whoever looks it up names those that there are.
PointReference point_at(Scene& scene, const std::string& name);

/// Newton-Euler's theorem along a direction, or the energy theorem, for bodies of a scene as a person writes it
/// (generator/dynamics/theorems/theorem_equations.hpp), parameters as symbols, and a word on the unknowns in it. What is too long is given
/// by named definitions. Throws UsageError for words it does not know and a moment without a point, SceneError for
/// names.
std::string theorem_text(const Scene& scene, const TheoremRequest& request, const PageStyle& style = {});

/// Which bodies, where and along whose axes, in the words of a command line.
struct ScrewRequest {
  std::vector<std::string> bodies;  ///< all of the scene when empty
  std::string point;                ///< where screws are reduced: a point, or a frame for its origin
  std::string axes = "ground";
  std::string observer = "ground";  ///< the frame R from which motion is seen
};

/// Momentum screw {m V_G; σ_A}, dynamic screw {m Γ_G; δ_A} and T of bodies, and of a single body its twist {Ω; V(A)}
/// (generator/dynamics/motion/body_screws.hpp), parameters as symbols. Throws UsageError without a point, SceneError for
/// names.
std::string screw_text(const Scene& scene, const ScrewRequest& request, const PageStyle& style = {});

}  // namespace torsor
