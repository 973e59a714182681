// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/pivot_test.hpp"

namespace torsor {

/// Derivatives of the accelerations and multipliers of the motion, functions of (q, v, u, t) where constraints hold or
/// not: ∂a_i/∂x_j in row i. Along an attitude q_j is a turn about its moving axis j.
struct ForwardDerivatives {
  struct Of {
    ValueMatrix by_position, by_velocity;
    ValueMatrix by_force;  ///< by generalised forces added to E u: M⁻¹ without constraints
    ValueMatrix by_input;  ///< by motors: by_force · E
  };
  Of accelerations, multipliers;
  std::vector<PivotTest> pivots;
  std::string method;  ///< how they are found, in words
};

/// Through articulated bodies (articulated_derivatives.hpp) where that fits and costs less or is asked for; else by the
/// equations, differentiated at the motion's own accelerations and multipliers and solved with their factorisation: no
/// derivative of M⁻¹ is formed. M δa − B δλ = −∂(M a + h − B λ − E u)/∂x δx, A δa = −∂(A a + γ)/∂x δx (Carpentier &
/// Mansard, Analytical derivatives of rigid body dynamics algorithms, 2018, eq. 4).
ForwardDerivatives forward_derivatives(const Equations& equations);
/// The same by solving, whatever it costs: for those who solve with the factorisation further.
ForwardDerivatives forward_derivatives_by_factorisation(const Equations& equations);

}  // namespace torsor
