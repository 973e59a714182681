// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/pivot_test.hpp"

namespace torsor {

/// Which parameters sensitivities are taken by, a column each: those that stay symbols, in the scene's order, unless
/// ModelOptions::sensitive_to names others.
std::vector<SymbolPointer> sensitivity_parameters(const Equations& equations);

/// Of each value a row, a column for each parameter. By forward differentiation for each parameter or, where that takes fewer
/// operations, by a reverse sweep for each value (Griewank & Walther, Evaluating Derivatives, 2nd ed., §3).
ValueMatrix derivatives_by_parameters(const Equations& equations, const std::vector<Value>& values,
                                      const std::vector<SymbolPointer>& parameters);

/// ∂f_i/∂π_k of the inverse dynamics f = M a + h − B λ at (q, v, a, λ), the parameter π_k in column k. What depends on
/// parameters only is computed once for a set of them, regrouped inertia among it, as in every kernel.
ValueMatrix inverse_sensitivities(const Equations& equations);

/// ∂a_i/∂π_k and ∂λ_j/∂π_k of the motion at (q, v, u, t), where constraints hold or not: with the factorisation of the
/// motion, M δa − B δλ = −∂(M a + h − B λ − E u)/∂π δπ, A δa = −∂(A a + γ)/∂π δπ; no derivative of M⁻¹ is formed.
struct ForwardSensitivities {
  ValueMatrix accelerations, multipliers;
  std::vector<PivotTest> pivots;
};
ForwardSensitivities forward_sensitivities(const Equations& equations);

}  // namespace torsor
