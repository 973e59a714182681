// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <span>
#include <type_traits>
#include <utility>

#include "torsor/runtime/constraints/change_point.hpp"
#include "torsor/runtime/equations_of_motion.hpp"
#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// The motion of a mechanism with constraints, held on them: every step ends on f(q, t) = 0 and A v = b, to rounding,
/// and change points are passed (see ChangePoints). y' = f(t, y) on the constraints is that of EquationsOfMotion;
/// beside them, where stages of a step are, it is that of the nearest state on them wherever this matters.
template <HasForwardDynamics M, class InputLaw = NoInputs<M>>
requires HasConstraintMetric<M>
class ClosedMotion : public EquationsOfMotion<M, InputLaw> {
  using Base = EquationsOfMotion<M, InputLaw>;

 public:
  using typename Base::Scalar;
  using typename Base::Vector;

  explicit ClosedMotion(const typename M::Parameters& parameters = M::default_parameters(),
                        InputLaw law = InputLaw{}) noexcept
      : Base(parameters, std::move(law)), change_points_(this->precomputed()) {}

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& y, Vector& dydt) const noexcept {
    const auto equations = [this](Scalar time, const Vector& state, Vector& slope) noexcept {
      return Base::operator()(time, state, slope);
    };
    return change_points_.evaluate({this->precomputed(), t, y}, equations, dydt);
  }

  /// Accelerations and multipliers of the state as it is given; `singular` at a change point, where the state alone
  /// does not determine them.
  [[nodiscard]] Evaluation accelerations(const typename M::State& state, typename M::Accelerations& a,
                                         typename M::Multipliers& lambda) const noexcept {
    return regular(state) ? Base::accelerations(state, a, lambda) : Evaluation::singular;
  }

  /// See EquationsOfMotion; `singular` at a change point.
  [[nodiscard]] Evaluation jets(const Scalar& t, const Vector& y,
                                std::span<Vector> c) const noexcept requires HasJets<M> &&
      (M::input_count == 0 || requires { requires InputLaw::constant_inputs; }) {
    return regular(unpack<M>(t, y)) ? Base::jets(t, y, c) : Evaluation::singular;
  }

  /// Puts a state on the constraints by the least change in the metric of the masses; quaternions keep their norm.
  [[nodiscard]] Evaluation project(Scalar t, Vector& y) const noexcept { return settle(t, y); }
  [[nodiscard]] Evaluation settle(Scalar t, Vector& y) const noexcept {
    return change_points_.settle(this->precomputed(), t, y);
  }

 private:
  [[nodiscard]] bool regular(const typename M::State& state) const noexcept {
    typename M::Constraints constraints{};
    M::constraints(this->precomputed(), state, constraints);
    return change_points_.regular(constraints);
  }

  ChangePoints<M> change_points_;
};

namespace detail {
template <class M, class InputLaw>
struct ClosedMotionOf {
  using type = ClosedMotion<M, InputLaw>;
};
}  // namespace detail

}  // namespace torsor::runtime
