// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>

#include "torsor/runtime/small_motions/linear_system.hpp"
#include "torsor/runtime/small_motions/stability.hpp"
#include "torsor/runtime/small_motions/steady_states.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// Small motions that keep A x = 0, in independent coordinates: x = Z z, A Z = 0, and the matrices become Zᵀ M Z and
/// so on. Rows of A may depend on each other. Throws std::invalid_argument when nothing is left to move.
[[nodiscard]] LinearSystem on_constraints(const LinearSystem& system, const Eigen::MatrixXd& A);

namespace detail {

template <class M>
[[nodiscard]] LinearSystem linearised_motion(const typename M::Precomputed& precomputed, const FoundState<M>& s,
                                             const typename M::Inputs& inputs) {
  typename M::Linearisation linear{};
  if constexpr (requires { linear.M_r; }) {
    const auto status = M::linearisation(precomputed, s.state, s.accelerations, s.multipliers, inputs, linear);
    if (to_evaluation(status) != Evaluation::ok) {
      throw std::invalid_argument(
          "the constraints do not determine the dependent freedoms at this state: name others "
          "as independent in the scene");
    }
    return reduced_linear_system(linear);
  } else {
    throw std::invalid_argument(
        "a constrained motion is not linearised by projection, and this mechanism has no "
        "reduced linearisation");
  }
}

}  // namespace detail

/// The equations linearised about an equilibrium that was found, in independent coordinates: with constraints,
/// deviations along the columns of Z, A Z = 0, which become M' = Zᵀ M Z and so on, with K at the multipliers of the
/// equilibrium: the Hessian of −(U + T0) − Σ λ_j f_j on the tangent space. At rest this holds for holonomic constraints
/// and for non-holonomic ones alike. A state that moves under holonomic constraints is linearised in the independent
/// freedoms of the kernel. Throws std::invalid_argument when the constraints there leave no motion or do not determine
/// the dependent freedoms of the kernel, and for a moving state under constraints on velocities: take `state_matrix`.
template <HasLinearisation M>
requires(M::multiplier_count == 0 || HasConstraints<M>) [[nodiscard]] LinearSystem
    linearised_at(const typename M::Precomputed& precomputed, const FoundState<M>& s,
                  const typename M::Inputs& inputs = {}) {
  if constexpr (M::multiplier_count > 0) {
    bool moves = false;
    for (int i = 0; i < M::velocity_count; ++i) moves = moves || s.state.v[i] != 0 || s.accelerations[i] != 0;
    if (moves) return detail::linearised_motion<M>(precomputed, s, inputs);
  }
  typename M::Linearisation linear{};
  M::linearisation(precomputed, s.state, s.accelerations, s.multipliers, inputs, linear);
  LinearSystem system = linear_system(linear);
  if constexpr (M::multiplier_count > 0) {
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

/// Both verdicts on an equilibrium: that of the eigenvalues where it concludes, for damping that reaches every motion
/// makes it asymptotically stable, which Lejeune-Dirichlet cannot tell; else that of Lejeune-Dirichlet, which is asked
/// only when the caller says that all forces at rest derive from U + T0 (gyroscopic and dissipative ones may be there
/// besides). `reason` holds both answers when both were asked.
[[nodiscard]] StabilityReport stability(const LinearSystem& system, bool forces_at_rest_have_force_function);

}  // namespace torsor::runtime
