// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/recursions/inertia_derivatives.hpp"

namespace torsor {

/// M ε̈ + C ε̇ + K ε = F + E δu about any state (q, q̇, q̈, λ, u), ε and δu deviations from it. With the residual
/// r = M q̈ + h − Aᵀλ − E u: C = ∂r/∂q̇, K = ∂r/∂q, F = −r, E = ∂Q/∂u; q̈ = 0 gives the expansion about a rest or any
/// other state with its own F. With constraints this is the expansion at fixed multipliers, in all coordinates: A' δλ
/// and the linearised constraints come beside it.
struct Linearisation {
  ValueMatrix M, C, K, E;
  std::vector<Value> F;
};
Linearisation linearisation(const Equations& equations);

/// Whether a residual has the motors' actions in it.
enum class Inputs { left_out, act };

/// ∂r/∂q and ∂r/∂v of r = M q̈ + h − B λ [− E u] at accelerations, multipliers and inputs as symbols: by
/// inertia_derivatives where it applies, what is left (everything, where it does not) definition by definition.
ForceDerivatives residual_derivatives(const Equations& equations, Inputs inputs);
/// The same of what the residual has besides inertia, gravity and applied wrenches: springs, dampers, constraints.
ForceDerivatives effort_derivatives(const Equations& equations, Inputs inputs);

}  // namespace torsor
