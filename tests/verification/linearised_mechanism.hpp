// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_mechanisms {

/// What the comparison of a linearisation with finite differences found.
struct LinearisationOutcome {
  std::string difference;  ///< empty when both agree
  bool forward = false;    ///< the derivatives of the forward dynamics were compared: the state is not singular
  bool reduced = false;    ///< the reduced matrices were compared too, at a state that satisfies the constraints
  bool redundant = false;  ///< and some of those constraints repeat others
  bool turning = false;    ///< an attitude was among what moved
};

/// M, C, K, E, F at fixed multipliers, at a random state that need satisfy nothing, against central differences of the
/// residual r = M q̈ + h − Aᵀλ − E u along one random direction of everything at once (q, q̇, q̈, u): attitudes move by
/// infinitesimal turns e ∘ (1, δ/2), never component by component. Where constraints tie the freedoms, also the reduced
/// M, C, K, E, F and the rates of the deviations against central differences of the forward dynamics along the
/// constraints, which are satisfied anew on both sides by Newton's method. The derivatives of the forward dynamics
/// against central differences of the motion. All in `digits` digits.
LinearisationOutcome compare_linearisation(const Scene& scene, int digits);

}  // namespace torsor::testing_mechanisms
