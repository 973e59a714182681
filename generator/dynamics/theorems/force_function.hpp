// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/selected_actions.hpp"

namespace torsor {

/// The three cases of the course's shaker (§6.5.3).
enum class ForceFunctionCase {
  potential_energy,  ///< Q_i = ∂U/∂q_i and the whole power is −dEp/dt with Ep = −U(q, t)
  force_function,    ///< Q_i = ∂U/∂q_i, but the whole power is the derivative of nothing
  none,              ///< no U: the Q_i depend on velocities or inputs, or their cross derivatives differ
};

struct ForceFunctionReport {
  ForceFunctionCase kind = ForceFunctionCase::none;
  std::vector<std::string> reasons;  ///< why it is no better case; names coordinates. Empty for a potential energy
  std::vector<Value> forces;         ///< Q_i of the unknowns
  Value power;                       ///< the whole power of the actions on those bodies, imposed motions included [W]
  std::optional<Value> force_function;  ///< U(q, t) where it could be written down [J]
  std::string remark;                   ///< where U comes from, or why it could not be written down
};

/// Tells the three cases apart, for the selected actions as seen with the coordinates of the scene. With
/// R = P − Σ Q_i q̇_i, the power that does not pass through the coordinates (imposed motions):
///   U exists, locally, when ∂Q_i/∂q̇_j = 0 and ∂Q_i/∂q_j = ∂Q_j/∂q_i for all i, j;
///   Ep = −U exists when in addition P = dU/dt can hold, that is ∂R/∂q_i = ∂Q_i/∂t and ∂R/∂q̇_i = 0.
/// (U is fixed up to a function of time, which takes up what is left of R.) A force function given by formula is an
/// action on the coordinates: its power is Σ Q_i q̇_i. Identities are decided as by `vanishes`.
/// U is the sum of what springs, attractions and weight have, when its gradient is Q; else it is integrated along
/// straight lines from q = 0 when the Q_i are polynomials in q (degree 8 at most).
/// Throws SceneError for an unknown name, or an action without ends asked for by body.
ForceFunctionReport classify_force_function(const Equations& equations, const ActionSelection& selection = {});

/// The same verdict alone, without a look for U.
ForceFunctionCase force_function_case(const Equations& equations, const ActionSelection& selection);

/// "potential energy", "force function without potential energy", "no force function".
std::string to_string(ForceFunctionCase kind);

}  // namespace torsor
