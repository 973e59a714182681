// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

// Parts of `validate`: what a scene says of its joints and contacts must be what it promises. Each throws SceneError
// with one line that names the object, the value and the remedy.

/// What is shown is shown on a frame of the scene, and its lengths are above 0, as far as they are known.
void check_shown_forms(const SceneContent& scene);

/// Support functions of contacts are those of convex bodies: homogeneous of degree 1, and, where all parameters have
/// values, with radii of curvature that are nowhere negative (48 directions are looked at).
void check_support_functions(const Model& model);

/// What is not to slip on a body is not part of it.
void check_slipping_bodies(const Model& model);

/// A closing joint starts in the orientation it is meant to have: its conditions a_i · b_j = 0 hold half a turn off
/// too, where those of the axes that shall coincide are opposite, a_i · b_i = −1. For an initial state that satisfies
/// the constraints, with a value for every parameter.
void check_closing_joints(const Equations& equations);

}  // namespace torsor
