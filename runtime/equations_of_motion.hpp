// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>

#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// y' = f(t, y) of a mechanism: dq/dt = v and dv/dt = a, where M a + h = Q(inputs) + Aᵀλ is solved by the generated
/// kernel `forward_dynamics` and the inputs come from a law `law(state) -> Inputs`.
/// Returns the kernel's status; dydt is meaningful only when it is `ok`. Nothing holds constraints: A a + γ = 0 is all
/// that is solved, f and A v - b drift. See `equations_of_motion`.
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

  /// ∂(q', v')/∂(q, v), column by column, from the generated derivatives: [[0, I], [∂a/∂q, ∂a/∂v]] where q' = v, and
  /// where q' = N(q) v, linear in a quaternion too, [[∂(N v)/∂q, N], [∂a/∂q N⁺, ∂a/∂v]]. Offered when no input depends
  /// on the state; without it the implicit methods take differences.
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

  /// The same of what a motion starts from: another norm would give other equations until the first step ends.
  template <class Number>
  [[nodiscard]] Evaluation settle_start(std::array<Number, coordinates_of<M> + velocities_of<M>>& y) const noexcept
      requires HasQuaternions<M> {
    return start_with_unit_quaternions<M>(y) ? Evaluation::ok : Evaluation::not_finite;
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

}  // namespace torsor::runtime
