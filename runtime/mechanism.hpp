// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

#include "torsor/runtime/constraints/closed_motion.hpp"
#include "torsor/runtime/equations_of_motion.hpp"
#include "torsor/runtime/mechanism_model.hpp"

namespace torsor::runtime {

/// A mechanism whose motion can be held on its constraints: it has some, and the kernels `mass_matrix` and
/// `constraints` beside `forward_dynamics`; in float or double, not in packs.
template <class M>
concept HasClosedMotion = HasForwardDynamics<M> && HasConstraintMetric<M> && std::floating_point<ScalarOf<M>>;

namespace detail {
template <class M, class InputLaw>
struct ClosedMotionOf;

/// Whether nothing that the motion needs for its constraints is missing. Packs drift: nothing projects them.
template <class M>
constexpr bool holds_its_constraints =
    M::multiplier_count == 0 || HasClosedMotion<M> || !std::floating_point<ScalarOf<M>>;
}  // namespace detail

/// The motion that `equations_of_motion` makes: held on the constraints where there are some.
template <HasForwardDynamics M, class InputLaw = NoInputs<M>>
using MotionOf = typename std::conditional_t<HasClosedMotion<M>, detail::ClosedMotionOf<M, InputLaw>,
                                             std::type_identity<EquationsOfMotion<M, InputLaw>>>::type;

/// `auto motion = equations_of_motion<Mechanism<double>>();`, or with parameters, or with parameters and an input law.
/// Of a mechanism with constraints it is a ClosedMotion: every step ends on the constraints, and change points are
/// passed. Without the kernels that this takes it does not compile. `unprojected_motion` is the one that drifts.
template <HasForwardDynamics M>
[[nodiscard]] MotionOf<M> equations_of_motion(
    const typename M::Parameters& parameters = M::default_parameters()) noexcept {
  static_assert(detail::holds_its_constraints<M>,
                "this mechanism has constraints, and its motion is held on them by the kernels mass_matrix and "
                "constraints: generate the header with both, or take unprojected_motion, which drifts");
  return MotionOf<M>(parameters);
}

template <HasForwardDynamics M, std::invocable<const typename M::State&> InputLaw>
[[nodiscard]] MotionOf<M, InputLaw> equations_of_motion(const typename M::Parameters& parameters,
                                                        InputLaw law) noexcept {
  static_assert(detail::holds_its_constraints<M>,
                "this mechanism has constraints, and its motion is held on them by the kernels mass_matrix and "
                "constraints: generate the header with both, or take unprojected_motion, which drifts");
  return MotionOf<M, InputLaw>(parameters, std::move(law));
}

/// The equations alone, A a + γ = 0: f and A v - b of a mechanism with constraints then drift. For methods that hold
/// the constraints themselves, and to see what holding them changes. At a change point errors decide which branch it takes:
/// it may leave that of the start with status ok, on constraints that are closed.
template <HasForwardDynamics M>
[[nodiscard]] EquationsOfMotion<M> unprojected_motion(
    const typename M::Parameters& parameters = M::default_parameters()) noexcept {
  return EquationsOfMotion<M>(parameters);
}

template <HasForwardDynamics M, std::invocable<const typename M::State&> InputLaw>
[[nodiscard]] EquationsOfMotion<M, InputLaw> unprojected_motion(const typename M::Parameters& parameters,
                                                                InputLaw law) noexcept {
  return EquationsOfMotion<M, InputLaw>(parameters, std::move(law));
}

}  // namespace torsor::runtime
