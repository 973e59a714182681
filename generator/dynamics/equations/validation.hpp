// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Looks at a scene as a whole before anything is derived from it: references, units, coordinates that move something,
/// masses where something must accelerate, constraints that involve coordinates, reactions that enforce what they are
/// said to enforce, an initial state that satisfies the constraints.
/// Throws SceneError or UnitError with one line that names the object, the value and the remedy.
void validate(const Scene& scene);

/// The part of it that looks at what the parameters are worth: inertias, axes, coefficients of friction, contacts.
void check_values(const SceneContent& scene);

/// Whether masses are lacking where something must accelerate, with the parameters as they are: other values of those that
/// can change do not help. Throws SceneError.
void check_masses(const Scene& scene, const ModelOptions& options);

/// The state (q, q̇) of the unknowns at t = 0, with parameters at their values; parameters without a value make it
/// empty when they are needed.
std::vector<Real> initial_state(const Scene& scene);

}  // namespace torsor
