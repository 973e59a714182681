// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// The scalar of a generated mechanism.
template <class M>
using ScalarOf = std::remove_cvref_t<decltype(std::declval<const typename M::State&>().time)>;

/// What the runtime needs of every generated `Mechanism<Scalar>`, whatever kernels were asked for.
template <class M>
concept MechanismModel = requires(const typename M::Parameters& parameters, const typename M::State& state) {
  requires M::coordinate_count >
  0 && M::velocity_count > 0 && M::input_count >= 0 && M::multiplier_count >= 0;
  typename M::Accelerations;
  typename M::GeneralizedForces;
  typename M::Inputs;
  typename M::Multipliers;
  { M::default_parameters() } -> std::same_as<typename M::Parameters>;
  { M::precompute(parameters) } -> std::same_as<typename M::Precomputed>;
  { M::initial_state() } -> std::same_as<typename M::State>;
  { state.q[0] } -> std::convertible_to<ScalarOf<M>>;
  { state.v[0] } -> std::convertible_to<ScalarOf<M>>;
};

/// A mechanism generated with the kernel `forward_dynamics`.
template <class M>
concept HasForwardDynamics = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Inputs& inputs, typename M::Accelerations& a, typename M::Multipliers& lambda) {
  M::forward_dynamics(precomputed, state, inputs, a, lambda);
};

/// A mechanism generated with the kernel `constraints`.
template <class M>
concept HasConstraints = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             typename M::Constraints& constraints) {
  M::constraints(precomputed, state, constraints);
};

/// A mechanism whose dq/dt is not v (quaternions) says how they are related.
template <class M>
concept HasCoordinateRates = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             std::array<ScalarOf<M>, std::size_t(M::coordinate_count)>& rates) {
  M::coordinate_rates(precomputed, state, rates);
};

/// A mechanism with unit quaternions (w, x, y, z) among its coordinates says where each begins.
template <class M>
concept HasQuaternions = MechanismModel<M> && requires {
  requires M::quaternion_count >
  0;
  M::quaternions[0];
};

/// A mechanism with constraints that repeat others says whose multipliers are taken as zero.
template <class M>
concept HasRedundantConstraints = MechanismModel<M> && requires {
  requires M::redundant_count >
  0;
  M::redundant_multipliers[0];
};

/// A mechanism generated with the kernel `forward_dynamics_derivatives`.
template <class M>
concept HasForwardDynamicsDerivatives = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Inputs& inputs, typename M::ForwardDynamicsDerivatives& derivatives) {
  M::forward_dynamics_derivatives(precomputed, state, inputs, derivatives);
};

/// A mechanism without multipliers generated with the kernel `linearisation`, whose A is the Jacobian too.
template <class M>
concept HasStateMatrix = MechanismModel<M> && M::multiplier_count == 0 &&
                         requires(const typename M::Precomputed& precomputed, const typename M::State& state,
                                  const typename M::Accelerations& a, const typename M::Multipliers& lambda,
                                  const typename M::Inputs& inputs, typename M::Linearisation& linear) {
  M::linearisation(precomputed, state, a, lambda, inputs, linear);
  requires std::tuple_size_v<decltype(linear.A)>
  == 4 * std::size_t(M::velocity_count) * std::size_t(M::velocity_count);
};

template <MechanismModel M>
inline constexpr std::size_t coordinates_of = static_cast<std::size_t>(M::coordinate_count);
template <MechanismModel M>
inline constexpr std::size_t velocities_of = static_cast<std::size_t>(M::velocity_count);

/// A mechanism generated with the kernels `mass_matrix` and `bias`.
template <class M>
concept HasMassMatrixAndBias = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             std::array<ScalarOf<M>, velocities_of<M> * velocities_of<M>>& mass, typename M::GeneralizedForces& h) {
  M::mass_matrix(precomputed, state, mass);
  M::bias(precomputed, state, h);
};

/// All that a solution by matrices needs: constraints too where there are multipliers.
template <class M>
concept HasDynamicsMatrices = HasMassMatrixAndBias<M> &&(M::multiplier_count == 0 || HasConstraints<M>);

/// y = [q; v], the unknown of y' = f(t, y).
template <MechanismModel M>
using StateVector = std::array<ScalarOf<M>, coordinates_of<M> + velocities_of<M>>;

template <MechanismModel M>
[[nodiscard]] StateVector<M> pack(const typename M::State& state) noexcept {
  StateVector<M> y;
  for (std::size_t i = 0; i < coordinates_of<M>; ++i) y[i] = state.q[static_cast<int>(i)];
  for (std::size_t i = 0; i < velocities_of<M>; ++i) y[coordinates_of<M> + i] = state.v[static_cast<int>(i)];
  return y;
}

template <MechanismModel M>
[[nodiscard]] typename M::State unpack(const ScalarOf<M>& time, const StateVector<M>& y) noexcept {
  typename M::State state{};
  state.time = time;
  for (std::size_t i = 0; i < coordinates_of<M>; ++i) state.q[static_cast<int>(i)] = y[i];
  for (std::size_t i = 0; i < velocities_of<M>; ++i) state.v[static_cast<int>(i)] = y[coordinates_of<M> + i];
  return state;
}

/// The state the scene starts from with these parameters: its values may be formulas of them.
template <MechanismModel M>
[[nodiscard]] typename M::State initial_state_with(const typename M::Parameters& parameters) noexcept {
  if constexpr (requires { M::initial_state(parameters); }) {
    return M::initial_state(parameters);
  } else {
    return M::initial_state();
  }
}
template <MechanismModel M>
[[nodiscard]] typename M::State initial_state_of(const typename M::Precomputed& precomputed) noexcept {
  if constexpr (requires { precomputed.parameters; }) {
    return initial_state_with<M>(precomputed.parameters);
  } else {
    return M::initial_state();
  }
}

/// dq/dt at a state, the first part of dy/dt: v itself unless the mechanism has a map of its own.
template <MechanismModel M>
void write_coordinate_rates(const typename M::Precomputed& precomputed, const typename M::State& state,
                            StateVector<M>& dydt) noexcept {
  if constexpr (HasCoordinateRates<M>) {
    std::array<ScalarOf<M>, coordinates_of<M>> rates;
    M::coordinate_rates(precomputed, state, rates);
    for (std::size_t i = 0; i < coordinates_of<M>; ++i) dydt[i] = rates[i];
  } else {
    static_assert(coordinates_of<M> == velocities_of<M>,
                  "a mechanism with more coordinates than velocities must supply coordinate_rates");
    for (std::size_t i = 0; i < coordinates_of<M>; ++i) dydt[i] = state.v[static_cast<int>(i)];
  }
}

/// A mechanism generated with the kernel `jets`: Taylor coefficients of its motions.
template <class M>
concept HasJets = HasForwardDynamics<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Inputs& inputs, StateVector<M>* coefficients) {
  M::jets(precomputed, state, inputs, 1, coefficients);
};

/// The most that can be asked of the kernel `jets`.
inline constexpr std::size_t jet_order_max = 30;

/// Gives the unit quaternions among the coordinates of y their norm back; of packs too, lane by lane.
template <HasQuaternions M, class Scalar>
void normalise_quaternions(std::array<Scalar, coordinates_of<M> + velocities_of<M>>& y) noexcept {
  for (const int first : M::quaternions) {
    const auto w = static_cast<std::size_t>(first);
    const Scalar square = y[w] * y[w] + y[w + 1] * y[w + 1] + y[w + 2] * y[w + 2] + y[w + 3] * y[w + 3];
    using std::sqrt;
    const Scalar scale = Scalar(1) / sqrt(square);
    for (std::size_t k = 0; k < 4; ++k) y[w + k] *= scale;
  }
}

/// The same of a state that a motion starts from, of any size; what has norm 1 within a few roundings keeps its bits, what
/// is not finite stays. False where one is zero: it has no direction, and is no attitude.
template <MechanismModel M, class Scalar>
[[nodiscard]] bool start_with_unit_quaternions(
    [[maybe_unused]] std::array<Scalar, coordinates_of<M> + velocities_of<M>>& y) noexcept {
  if constexpr (HasQuaternions<M>) {
    for (const int first : M::quaternions) {
      const auto w = static_cast<std::size_t>(first);
      Scalar largest = Scalar(0), square = Scalar(0);
      bool zero = true;
      for (std::size_t k = w; k < w + 4; ++k) {
        zero = zero && y[k] == Scalar(0);
        largest = std::max(largest, std::abs(y[k]));
      }
      if (zero) return false;
      for (std::size_t k = w; k < w + 4; ++k) square += (y[k] / largest) * (y[k] / largest);  // neither overflows nor vanishes
      const Scalar root = std::sqrt(square);
      const bool unit = std::abs(largest * root - Scalar(1)) <= Scalar(4) * std::numeric_limits<Scalar>::epsilon();
      if (unit || !std::isfinite(square)) continue;
      for (std::size_t k = w; k < w + 4; ++k) y[k] = y[k] / largest / root;
    }
  }
  return true;
}

/// Completes ∂(q', v')/∂(q, v), whose last rows hold ∂a/∂(virtual displacement) in the first nv columns and ∂a/∂v in the
/// last: the rows of q' = N(q) v, and by displacements N⁺ δq. The columns of N are orthogonal: those of a quaternion are,
/// and all others have one entry. N v is linear in the quaternions and independent of all other coordinates.
template <MechanismModel M>
void complete_jacobian(
    const typename M::Precomputed& precomputed, const typename M::State& state,
    std::array<ScalarOf<M>, std::tuple_size_v<StateVector<M>> * std::tuple_size_v<StateVector<M>>>& J) noexcept {
  using Scalar = ScalarOf<M>;
  constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>, n = nq + nv;
  if constexpr (HasCoordinateRates<M>) {
    std::array<std::array<Scalar, nq>, nv> N;
    std::array<Scalar, nq> here, there;
    M::coordinate_rates(precomputed, state, here);
    for (std::size_t k = 0; k < nv; ++k) {
      typename M::State unit = state;
      for (std::size_t i = 0; i < nv; ++i) unit.v[static_cast<int>(i)] = Scalar(i == k ? 1 : 0);
      M::coordinate_rates(precomputed, unit, N[k]);
      for (std::size_t i = 0; i < nq; ++i) J[(nq + k) * n + i] = N[k][i];
    }
    std::array<Scalar, nv * nv> by_displacement;
    for (std::size_t k = 0; k < nv; ++k) {
      Scalar square = Scalar(0);
      for (const Scalar& entry : N[k]) square += entry * entry;
      for (std::size_t i = 0; i < nv; ++i) by_displacement[k * nv + i] = J[k * n + nq + i] / square;
    }
    for (std::size_t j = 0; j < nq; ++j) {
      typename M::State moved = state;
      moved.q[static_cast<int>(j)] += Scalar(1);
      M::coordinate_rates(precomputed, moved, there);
      for (std::size_t i = 0; i < nq; ++i) J[j * n + i] = there[i] - here[i];
      for (std::size_t i = 0; i < nv; ++i) {
        J[j * n + nq + i] = Scalar(0);
        for (std::size_t k = 0; k < nv; ++k) J[j * n + nq + i] += by_displacement[k * nv + i] * N[k][j];
      }
    }
  } else {
    for (std::size_t j = 0; j < nv; ++j) {
      for (std::size_t i = 0; i < nv; ++i) {
        J[j * n + i] = Scalar(0);
        J[(nv + j) * n + i] = Scalar(i == j ? 1 : 0);
      }
    }
  }
}

/// The input law of a mechanism left to itself.
template <MechanismModel M>
struct NoInputs {
  static constexpr bool constant_inputs = true;
  [[nodiscard]] typename M::Inputs operator()(const typename M::State&) const noexcept {
    typename M::Inputs inputs{};
    if constexpr (M::input_count > 0) {
      for (int i = 0; i < M::input_count; ++i) inputs[i] = ScalarOf<M>(0);
    }
    return inputs;
  }
};

}  // namespace torsor::runtime
