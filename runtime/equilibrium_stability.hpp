// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "runtime/linear_system.hpp"
#include "runtime/stability.hpp"
#include "runtime/steady_states.hpp"

namespace torsor::runtime {

/// Small motions that keep A x = 0, in independent coordinates: x = Z z, A Z = 0, and the matrices become Zᵀ M Z and
/// so on. Rows of A may depend on each other. Throws std::invalid_argument when nothing is left to move.
[[nodiscard]] LinearSystem on_constraints(const LinearSystem& system, const Eigen::MatrixXd& A);

/// The equations linearised about an equilibrium that was found, in independent coordinates: with constraints,
/// deviations along the columns of Z, A Z = 0, which become M' = Zᵀ M Z and so on, with K at the multipliers of the
/// equilibrium: the Hessian of −(U + T0) − Σ λ_j f_j on the tangent space. At rest this holds for holonomic constraints
/// and for non-holonomic ones alike. Throws std::invalid_argument when the constraints there leave no motion, or for a
/// state that moves: with constraints a motion needs more than a projection.
template <HasLinearisation M>
requires(M::multiplier_count == 0 || HasConstraints<M>) [[nodiscard]] LinearSystem
    linearised_at(const typename M::Precomputed& precomputed, const FoundState<M>& s,
                  const typename M::Inputs& inputs = {}) {
  typename M::Linearisation linear{};
  M::linearisation(precomputed, s.state, s.accelerations, s.multipliers, inputs, linear);
  LinearSystem system = linear_system(linear);
  if constexpr (M::multiplier_count > 0) {
    for (int i = 0; i < M::velocity_count; ++i) {
      if (s.state.v[i] != 0 || s.accelerations[i] != 0) {
        throw std::invalid_argument("coordinate " + std::to_string(i) +
                                    " moves: a constrained motion is not linearised by projection");
      }
    }
    constexpr Eigen::Index n = M::velocity_count, m = M::multiplier_count;
    typename M::Constraints c{};
    M::constraints(precomputed, s.state, c);
    Eigen::MatrixXd A(m, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = 0; i < m; ++i) A(i, j) = c.jacobian[static_cast<std::size_t>(j * m + i)];
    }
    return on_constraints(system, A);
  }
  return system;
}

/// Both verdicts on an equilibrium, the conservative one first: stable by Lejeune-Dirichlet when −(U + T0) has a strict
/// minimum, else by the eigenvalues. Lejeune-Dirichlet is asked only when the caller says that all forces at rest
/// derive from U + T0 (gyroscopic and dissipative ones may be there besides). `reason` holds both answers when neither
/// concludes. Damping that reaches every motion turns "stable" into "asymptotically stable".
[[nodiscard]] StabilityReport stability(const LinearSystem& system, bool forces_at_rest_have_force_function);

}  // namespace torsor::runtime
