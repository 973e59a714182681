// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "torsor/runtime/mechanism.hpp"

namespace torsor::runtime {

/// A motion (see `equations_of_motion`) whose Lagrangian can be had from the kernels `mass_matrix` and `bias`: q' = v,
/// no multipliers, no inputs.
template <class S>
concept HasLagrangian = requires {
  typename S::Mechanism;
  requires HasMassMatrixAndBias<typename S::Mechanism>;
  requires !HasCoordinateRates<typename S::Mechanism>;
  requires S::Mechanism::multiplier_count == 0 && S::Mechanism::input_count == 0;
};

/// A mechanism generated with the kernel `inverse_dynamics_derivatives`.
template <class M>
concept HasInverseDynamicsDerivatives = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Accelerations& a, const typename M::Multipliers& lambda,
             typename M::InverseDynamicsDerivatives& derivatives) {
  M::inverse_dynamics_derivatives(precomputed, state, a, lambda, derivatives);
};

/// d/dt (M v) = F(t, q, v), the right-hand side of Lagrange's equations solved for the momentum M v:
///   F = ∂T₂/∂q - (g + d),   T₂ = ½ vᵀ M v,   where bias = Ṁ v - ∂T₂/∂q + g + d
/// has g, what does not depend on v (the gradient of -(U + T₀)), and d, odd in v (dampers, and the gyroscopic forces of
/// driven joints; ∂M/∂t must vanish). No action may be even in v but for what it is at rest, see
/// `has_forces_even_in_velocities`: it would be taken for part of c. Ṁ v - ∂T₂/∂q = c(v) is quadratic in v, and by
/// Christoffel's symbols
///   ∂T₂/∂q_k = ½ v · ∂c/∂v_k,
/// which the kernel `inverse_dynamics_derivatives` gives, or, exactly too, values of the bias at v ± s e_k and
/// -v ± s e_k, s any speed: c(v + s e_k) - c(v - s e_k) = 2 s ∂c/∂v_k. Differences of what is odd or even in v take d
/// and g away.
/// Source: Arnold, Mathematical Methods of Classical Mechanics, 19; Christoffel's symbols: Spong, Robot Modeling, 7.3.
template <MechanismModel M>
requires HasMassMatrixAndBias<M>
void lagrangian_forces(const typename M::Precomputed& precomputed, const typename M::State& state,
                       std::array<ScalarOf<M>, velocities_of<M>>& F) noexcept {
  using Scalar = ScalarOf<M>;
  using Forces = typename M::GeneralizedForces;
  constexpr std::size_t n = velocities_of<M>;
  const auto at = [](std::size_t i) { return static_cast<int>(i); };
  const Scalar half = Scalar(1) / Scalar(2);

  typename M::State back = state, rest = state;
  Scalar speed = Scalar(1);
  for (std::size_t i = 0; i < n; ++i) {
    back.v[at(i)] = -state.v[at(i)];
    rest.v[at(i)] = Scalar(0);
    speed = std::max(speed, std::abs(state.v[at(i)]));
  }
  Forces forward_bias{}, backward_bias{}, at_rest{};
  M::bias(precomputed, state, forward_bias);
  M::bias(precomputed, back, backward_bias);
  M::bias(precomputed, rest, at_rest);
  for (std::size_t i = 0; i < n; ++i) {
    F[i] = -at_rest[at(i)] - half * (forward_bias[at(i)] - backward_bias[at(i)]);
  }
  if constexpr (HasInverseDynamicsDerivatives<M>) {
    typename M::InverseDynamicsDerivatives forward, backward;
    const typename M::Accelerations none{};
    M::inverse_dynamics_derivatives(precomputed, state, none, typename M::Multipliers{}, forward);
    M::inverse_dynamics_derivatives(precomputed, back, none, typename M::Multipliers{}, backward);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < n; ++i) {
        F[k] += half * half * state.v[at(i)] * (forward.by_velocity[k * n + i] - backward.by_velocity[k * n + i]);
      }
    }
  } else {
    // c(v + s e) - c(v - s e), from the even part of the bias at both.
    const auto add = [&](const typename M::State& from, std::size_t k, Scalar shift, Scalar sign, auto& sum) {
      typename M::State moved = from;
      moved.v[at(k)] += shift;
      Forces bias{};
      M::bias(precomputed, moved, bias);
      for (std::size_t i = 0; i < n; ++i) sum[i] += sign * bias[at(i)];
    };
    for (std::size_t k = 0; k < n; ++k) {
      std::array<Scalar, n> sum{};
      add(state, k, speed, Scalar(1), sum);
      add(state, k, -speed, Scalar(-1), sum);
      add(back, k, -speed, Scalar(1), sum);
      add(back, k, speed, Scalar(-1), sum);
      for (std::size_t i = 0; i < n; ++i) F[k] += state.v[at(i)] * sum[i] / (Scalar(8) * speed);
    }
  }
}

}  // namespace torsor::runtime
