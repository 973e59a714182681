// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "runtime/constraints/independent_constraints.hpp"
#include "runtime/mechanism.hpp"
#include "runtime/status.hpp"

namespace torsor::runtime {

/// A mechanism generated with the kernels `mass_matrix` and `constraints`.
template <class M>
concept HasConstraintMetric = HasConstraints<M> && M::multiplier_count >
0 && requires(const typename M::Precomputed& precomputed, const typename M::State& state,
              std::array<ScalarOf<M>, velocities_of<M> * velocities_of<M>>& mass) {
  M::mass_matrix(precomputed, state, mass);
};

/// What a projection did. Residuals are the largest |f_i| and |A v - b|_i, each over the size Σ_j |A_ij| of its row: a
/// displacement of the coordinates, and a rate of them.
template <class Scalar>
struct Projection {
  Evaluation evaluation = Evaluation::ok;
  Scalar position = Scalar(0), velocity = Scalar(0);
  Scalar least_share = Scalar(1);  ///< see IndependentConstraints
  int rank = 0;
  int iterations = 0;
};

/// Puts a state onto its constraints by the least change in the metric of the masses:
///   δq = -M⁻¹ Aᵀ (A M⁻¹ Aᵀ)⁺ f(q, t), repeated until f is down to rounding;   δv = -M⁻¹ Aᵀ (A M⁻¹ Aᵀ)⁺ (A v - b),
/// with unit quaternions turned by δq and given their norm back. Constraints that repeat others within `rank_tolerance`
/// are left out of the factor and must close by themselves. `singular` when f has no zero near, or constraints contradict
/// each other in position or in velocity; y is then left alone. Source: Hairer-Wanner II, VII.2 (projection); Lubich,
/// Engstler, Nowak & Pöhle 1995 (mass metric).
template <HasConstraintMetric M>
[[nodiscard]] Projection<ScalarOf<M>> project_on_constraints(
    const typename M::Precomputed& precomputed, ScalarOf<M> t, StateVector<M>& y,
    ScalarOf<M> rank_tolerance = usual_rank_tolerance<ScalarOf<M>>()) noexcept;

/// A motion whose every step ends on its constraints, in position and velocity; quaternions keep their norm. All
/// methods call `project` after each step kept; where it fails, adaptive methods shorten the step and others end with
/// the status of the model. The last slope and the interpolant of a step belong to the state before the correction,
/// which is below the step's error: they keep their order. `const auto motion =
/// projected(equations_of_motion<Mechanism<double>>());`
template <class Motion>
class Projected : public Motion {
 public:
  using Mechanism = typename Motion::Mechanism;
  using Scalar = ScalarOf<Mechanism>;
  using Vector = StateVector<Mechanism>;

  /// Constraints of which the others leave less than `rank_tolerance` are not enforced; see IndependentConstraints.
  explicit Projected(Motion motion, Scalar rank_tolerance = usual_rank_tolerance<Scalar>()) noexcept
      : Motion(std::move(motion)), rank_tolerance_(rank_tolerance) {}

  [[nodiscard]] Evaluation project(Scalar t, Vector& y) const noexcept {
    return project_on_constraints<Mechanism>(this->precomputed(), t, y, rank_tolerance_).evaluation;
  }

 private:
  Scalar rank_tolerance_;
};

template <class Motion>
requires HasConstraintMetric<typename Motion::Mechanism>
[[nodiscard]] Projected<Motion> projected(Motion motion,
                                          ScalarOf<typename Motion::Mechanism> rank_tolerance =
                                              usual_rank_tolerance<ScalarOf<typename Motion::Mechanism>>()) noexcept {
  return Projected<Motion>(std::move(motion), rank_tolerance);
}

namespace detail {

/// q := q + displacement, a velocity for one unit of time; quaternions keep their norm.
template <MechanismModel M, class Displacement>
void displace(const typename M::Precomputed& precomputed, ScalarOf<M> t, const Displacement& displacement,
              StateVector<M>& y) noexcept {
  typename M::State state = unpack<M>(t, y);
  for (int i = 0; i < M::velocity_count; ++i) state.v[i] = displacement(i);
  StateVector<M> change{};
  write_coordinate_rates<M>(precomputed, state, change);
  for (std::size_t i = 0; i < coordinates_of<M>; ++i) y[i] += change[i];
  if constexpr (HasQuaternions<M>) normalise_quaternions<M>(y);
}

/// Constraints and masses at a state, and how far it is off.
template <HasConstraintMetric M>
class ConstraintState {
 public:
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  using Residual = Eigen::Matrix<Scalar, static_cast<int>(m), 1>;

  bool read(const typename M::Precomputed& precomputed, Scalar t, const StateVector<M>& y) noexcept {
    state_ = unpack<M>(t, y);
    M::constraints(precomputed, state_, constraints_);
    position = velocity = rounding = Scalar(0);
    Scalar largest = Scalar(0);
    speed = Scalar(0);
    for (std::size_t i = 0; i < coordinates_of<M>; ++i) largest = std::max(largest, std::abs(y[i]));
    if (!(largest > Scalar(0))) largest = Scalar(1);
    for (std::size_t i = 0; i < nv; ++i) speed = std::max(speed, std::abs(state_.v[static_cast<int>(i)]));
    bool finite = true;
    for (std::size_t i = 0; i < m; ++i) {
      Scalar size = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) size += std::abs(constraints_.jacobian[j * m + i]);
      const Scalar over = size > Scalar(0) ? Scalar(1) / size : Scalar(1);
      position = std::max(position, std::abs(constraints_.value[i]) * over);
      velocity = std::max(velocity, std::abs(constraints_.rate[i]) * over);
      finite = finite && std::isfinite(constraints_.value[i]) && std::isfinite(constraints_.rate[i]);
    }
    rounding = Scalar(2) * std::numeric_limits<Scalar>::epsilon() * largest;
    rounding_of_velocity = Scalar(2) * std::numeric_limits<Scalar>::epsilon() * speed;
    return finite && std::isfinite(position) && std::isfinite(velocity);
  }

  template <class Factor>
  [[nodiscard]] Evaluation factorise(const typename M::Precomputed& precomputed, Factor& factor,
                                     Scalar rank_tolerance) {
    std::array<Scalar, nv * nv> mass;
    M::mass_matrix(precomputed, state_, mass);
    return factor.factorise(mass, constraints_.jacobian, rank_tolerance);
  }

  [[nodiscard]] Residual value() const noexcept { return Eigen::Map<const Residual>(constraints_.value.data()); }
  [[nodiscard]] Residual rate() const noexcept { return Eigen::Map<const Residual>(constraints_.rate.data()); }

  Scalar position = Scalar(0), velocity = Scalar(0), rounding = Scalar(0), rounding_of_velocity = Scalar(0);
  Scalar speed = Scalar(0);  // the largest velocity

 private:
  typename M::State state_{};
  typename M::Constraints constraints_{};
};

}  // namespace detail

template <HasConstraintMetric M>
Projection<ScalarOf<M>> project_on_constraints(const typename M::Precomputed& precomputed, ScalarOf<M> t,
                                               StateVector<M>& y, ScalarOf<M> rank_tolerance) noexcept {
  using Scalar = ScalarOf<M>;
  using State = detail::ConstraintState<M>;
  IndependentConstraints<Scalar, State::nv, State::m> factor;
  Projection<Scalar> result;
  StateVector<M> next = y;
  if constexpr (HasQuaternions<M>) normalise_quaternions<M>(next);
  State here;
  const auto fail = [&](Evaluation evaluation) {
    result.evaluation = evaluation;
    return result;
  };
  if (!here.read(precomputed, t, next)) return fail(Evaluation::not_finite);
  bool factored = false;
  // Newton's steps end where rounding does: at the second that no longer halves the residual.
  constexpr int limit = 30;
  for (; here.position > here.rounding; ++result.iterations) {
    if (result.iterations == limit) return fail(Evaluation::singular);
    // Off its zeros by d, a redundant constraint looks independent by some d.
    const Scalar tolerance = std::max(rank_tolerance, std::min(Scalar(1e-3), Scalar(4) * here.position));
    if (const Evaluation e = here.factorise(precomputed, factor, tolerance); e != Evaluation::ok) return fail(e);
    // What was left out for that reason alone may hold a velocity.
    factored = factor.rank() == static_cast<int>(State::m) || !(tolerance > rank_tolerance);
    result.rank = factor.rank();
    result.least_share = factor.least_share();
    StateVector<M> trial = next;
    detail::displace<M>(precomputed, t, factor.least_change(-here.value()), trial);
    State there;
    if (!there.read(precomputed, t, trial)) return fail(Evaluation::not_finite);
    const bool halves = there.position < here.position / Scalar(2);
    if (there.position < here.position) {
      next = trial;
      here = there;
    }
    if (!halves) break;
  }
  // What is left is rounding, or a place from which no zero is reached.
  if (!(here.position <= Scalar(1e6) * here.rounding)) return fail(Evaluation::singular);
  for (int repeat = 0; repeat < 3 && here.velocity > here.rounding_of_velocity; ++repeat) {
    if (!factored) {
      if (const Evaluation e = here.factorise(precomputed, factor, rank_tolerance); e != Evaluation::ok) return fail(e);
      factored = true;
      result.rank = factor.rank();
      result.least_share = factor.least_share();
    }
    const auto change = factor.least_change(-here.rate());
    StateVector<M> trial = next;
    for (std::size_t i = 0; i < State::nv; ++i) trial[coordinates_of<M> + i] += change(static_cast<int>(i));
    State there;
    if (!there.read(precomputed, t, trial)) return fail(Evaluation::not_finite);
    if (!(there.velocity < here.velocity)) break;
    next = trial;
    here = there;
  }
  // Of a velocity, constraints that are left out may keep a share of the order of the rank tolerance, not all of it.
  const Scalar left_over = Scalar(1e6) * here.rounding_of_velocity + Scalar(1e3) * rank_tolerance * here.speed;
  if (!(here.velocity <= left_over)) return fail(Evaluation::singular);
  result.position = here.position;
  result.velocity = here.velocity;
  y = next;
  return result;
}

}  // namespace torsor::runtime
