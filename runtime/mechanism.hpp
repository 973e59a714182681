// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "runtime/status.hpp"

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

/// y' = f(t, y) of a mechanism: dq/dt = v and dv/dt = a, where M a + h = Q(inputs) + Aᵀλ is solved by the generated
/// kernel `forward_dynamics` and the inputs come from a law `law(state) -> Inputs`.
/// Returns the kernel's status; dydt is meaningful only when it is `ok`.
template <HasForwardDynamics M, class InputLaw = NoInputs<M>>
class EquationsOfMotion {
  static constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>, n = nq + nv;

 public:
  using Scalar = ScalarOf<M>;
  using Vector = StateVector<M>;

  /// Whether q' = v, so that y = [q; v] is a second-order system (see second_order.hpp).
  static constexpr bool second_order = !HasCoordinateRates<M>;
  using Mechanism = M;

  explicit EquationsOfMotion(const typename M::Parameters& parameters = M::default_parameters(),
                             InputLaw law = InputLaw{}) noexcept
      : precomputed_(M::precompute(parameters)), law_(std::move(law)) {}

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& y, Vector& dydt) const noexcept {
    const typename M::State state = unpack<M>(t, y);
    typename M::Accelerations a{};
    typename M::Multipliers lambda{};
    const Evaluation evaluation = accelerations(state, a, lambda);
    write_coordinate_rates<M>(precomputed_, state, dydt);
    for (std::size_t i = 0; i < velocities_of<M>; ++i) dydt[coordinates_of<M> + i] = a[static_cast<int>(i)];
    return evaluation;
  }

  /// Accelerations and multipliers at a state, under the input law.
  [[nodiscard]] Evaluation accelerations(const typename M::State& state, typename M::Accelerations& a,
                                         typename M::Multipliers& lambda) const noexcept {
    return to_evaluation(M::forward_dynamics(precomputed_, state, law_(state), a, lambda));
  }

  /// ∂(q', v')/∂(q, v), column by column, from the generated derivatives: [[0, I], [∂a/∂q, ∂a/∂v]] where q' = v, and where
  /// q' = N(q) v, linear in a quaternion too, [[∂(N v)/∂q, N], [∂a/∂q N⁺, ∂a/∂v]]. Offered when no input depends on the
  /// state; without it the implicit methods take differences.
  [[nodiscard]] Evaluation jacobian(const Scalar& t, const Vector& y, std::array<Scalar, n * n>& J) const noexcept
      requires(std::same_as<InputLaw, NoInputs<M>> && (HasForwardDynamicsDerivatives<M> || HasStateMatrix<M>)) {
    const typename M::State state = unpack<M>(t, y);
    Evaluation evaluation = Evaluation::ok;
    if constexpr (HasForwardDynamicsDerivatives<M>) {
      typename M::ForwardDynamicsDerivatives by;
      evaluation = to_evaluation(M::forward_dynamics_derivatives(precomputed_, state, law_(state), by));
      for (std::size_t j = 0; j < nv; ++j) {
        for (std::size_t i = 0; i < nv; ++i) {
          J[j * n + nq + i] = by.by_position[j * nv + i];
          J[(nq + j) * n + nq + i] = by.by_velocity[j * nv + i];
        }
      }
    } else {
      typename M::Accelerations a{};
      typename M::Multipliers lambda{};
      evaluation = accelerations(state, a, lambda);
      if (evaluation != Evaluation::ok) return evaluation;
      typename M::Linearisation linear;
      evaluation = to_evaluation(M::linearisation(precomputed_, state, a, lambda, law_(state), linear));
      for (std::size_t j = 0; j < nv; ++j) {
        for (std::size_t i = 0; i < nv; ++i) {
          J[j * n + nq + i] = linear.A[j * 2 * nv + nv + i];
          J[(nq + j) * n + nq + i] = linear.A[(nv + j) * 2 * nv + nv + i];
        }
      }
    }
    complete_jacobian<M>(precomputed_, state, J);
    return evaluation;
  }

  /// Taylor coefficients of the motion through y: c[k] = y^(k)(t)/k! for k = 0..c.size() - 1, at most 30. Only with
  /// inputs that do not change: the law says so by a member `static constexpr bool constant_inputs = true`.
  [[nodiscard]] Evaluation jets(const Scalar& t, const Vector& y,
                                std::span<Vector> c) const noexcept requires HasJets<M> &&
      (M::input_count == 0 || requires { requires InputLaw::constant_inputs; }) {
    if (c.size() < 2 || c.size() > jet_order_max + 1) {
      if (c.size() == 1) c[0] = y;
      return c.size() > 1 ? Evaluation::not_finite : Evaluation::ok;
    }
    const typename M::State state = unpack<M>(t, y);
    const int order = static_cast<int>(c.size()) - 1;
    return to_evaluation(M::jets(precomputed_, state, law_(state), order, c.data()));
  }

  /// Gives the unit quaternions among the coordinates their norm back; the state may be wider than the kernels' scalar.
  template <class Number>
  void project(std::array<Number, coordinates_of<M> + velocities_of<M>>& y) const noexcept requires HasQuaternions<M> {
    normalise_quaternions<M>(y);
  }

  /// The state the scene starts from, as y, and its time.
  [[nodiscard]] Vector initial() const noexcept { return pack<M>(initial_state_of<M>(precomputed_)); }
  [[nodiscard]] Scalar initial_time() const noexcept { return initial_state_of<M>(precomputed_).time; }

  [[nodiscard]] const typename M::Precomputed& precomputed() const noexcept { return precomputed_; }
  [[nodiscard]] const InputLaw& input_law() const noexcept { return law_; }

 private:
  typename M::Precomputed precomputed_;
  InputLaw law_;
};

/// `auto motion = equations_of_motion<Mechanism<double>>();`, or with parameters, or with parameters and an input law.
template <HasForwardDynamics M>
[[nodiscard]] EquationsOfMotion<M> equations_of_motion(
    const typename M::Parameters& parameters = M::default_parameters()) noexcept {
  return EquationsOfMotion<M>(parameters);
}

template <HasForwardDynamics M, std::invocable<const typename M::State&> InputLaw>
[[nodiscard]] EquationsOfMotion<M, InputLaw> equations_of_motion(const typename M::Parameters& parameters,
                                                                 InputLaw law) noexcept {
  return EquationsOfMotion<M, InputLaw>(parameters, std::move(law));
}

}  // namespace torsor::runtime
