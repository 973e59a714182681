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
/// with unit quaternions turned by δq and given their norm back. A coordinate so large (an angle wound up) that its
/// share of a change is lost in its rounding is left to the others, which close the loop without it. Constraints that
/// repeat others within `rank_tolerance` are left out of the factor and must close by themselves. `singular` when f has
/// no zero near, or constraints contradict each other in position or in velocity; y is then left alone. Source:
/// Hairer-Wanner II, VII.2 (projection); Lubich, Engstler, Nowak & Pöhle 1995 (mass metric).
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

/// A mechanism without constraints has nothing to be projected on: its motion as it is, for code of any mechanism.
template <class Motion>
requires(Motion::Mechanism::multiplier_count == 0) [[nodiscard]] Motion projected(
    Motion motion, ScalarOf<typename Motion::Mechanism> /*rank_tolerance*/ = {}) noexcept {
  return motion;
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
    position = velocity = open = Scalar(0);
    largest = speed = Scalar(0);
    at_rounding = true;
    for (std::size_t i = 0; i < coordinates_of<M>; ++i) largest = std::max(largest, std::abs(y[i]));
    for (std::size_t i = 0; i < nv; ++i) speed = std::max(speed, std::abs(state_.v[static_cast<int>(i)]));
    bool finite = true;
    for (std::size_t i = 0; i < m; ++i) {
      Scalar size = Scalar(0), terms = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) {
        const Scalar entry = std::abs(constraints_.jacobian[j * m + i]);
        const Scalar coordinate = HasCoordinateRates<M> ? largest : std::abs(y[j]);
        size += entry;
        terms += entry * std::min(coordinate, turn);
      }
      const Scalar over = size > Scalar(0) ? Scalar(1) / size : Scalar(1);
      const Scalar off = std::abs(constraints_.value[i]);
      position = std::max(position, off * over);
      open += off * over;
      at_rounding = at_rounding && off <= Scalar(2) * epsilon * terms;
      velocity = std::max(velocity, std::abs(constraints_.rate[i]) * over);
      finite = finite && std::isfinite(constraints_.value[i]) && std::isfinite(constraints_.rate[i]);
    }
    rounding_of_velocity = Scalar(2) * epsilon * speed;
    return finite && std::isfinite(position) && std::isfinite(velocity);
  }

  /// What is held counts as infinitely heavy.
  template <class Factor>
  [[nodiscard]] Evaluation factorise(const typename M::Precomputed& precomputed, Factor& factor, Scalar rank_tolerance,
                                     const std::array<bool, nv>& held = {}) {
    std::array<Scalar, nv * nv> mass;
    M::mass_matrix(precomputed, state_, mass);
    for (std::size_t i = 0; i < nv; ++i) {
      if (held[i]) mass[i * (nv + 1)] /= epsilon * epsilon;
    }
    return factor.factorise(mass, constraints_.jacobian, rank_tolerance);
  }

  /// Marks the coordinates of which a change is lost in rounding; whether there are more than before.
  static bool hold_lost(const StateVector<M>& y, const Eigen::Matrix<Scalar, static_cast<int>(nv), 1>& change,
                        std::array<bool, nv>& held) noexcept {
    bool more = false;
    if constexpr (!HasCoordinateRates<M>) {
      for (std::size_t i = 0; i < nv; ++i) {
        const bool lost = std::abs(y[i]) > turn && std::abs(change(static_cast<int>(i))) < epsilon * std::abs(y[i]);
        more = more || (lost && !held[i]);
        held[i] = held[i] || lost;
      }
    }
    return more;
  }

  [[nodiscard]] Residual value() const noexcept { return Eigen::Map<const Residual>(constraints_.value.data()); }
  [[nodiscard]] Residual rate() const noexcept { return Eigen::Map<const Residual>(constraints_.rate.data()); }

  /// Whether a residual on which Newton's method stands still may be rounding. Of the coordinates and of lengths that
  /// are none, magnified near a change point; not magnified, of angles wound up and of places far away.
  [[nodiscard]] bool closed() const noexcept {
    const Scalar size = std::clamp(largest, Scalar(1e-3), turn);
    return position <= Scalar(2) * epsilon * (Scalar(1e6) * size + Scalar(16) * largest);
  }

  Scalar position = Scalar(0), velocity = Scalar(0), rounding_of_velocity = Scalar(0);
  Scalar open = Scalar(0);     // the sum of what `position` is the largest of
  Scalar largest = Scalar(0);  // of the coordinates
  Scalar speed = Scalar(0);    // the largest velocity
  bool at_rounding = false;    // each f_i is below two roundings of Σ_j |A_ij q_j|, of no angle more than a turn

 private:
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar turn = static_cast<Scalar>(6.28318530717958647692528676655900577L);
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
  // Newton's steps end where rounding does: at the first that no longer halves the residual.
  constexpr int limit = 30;
  std::array<bool, State::nv> held{};
  bool any_held = false;
  for (; !here.at_rounding && result.iterations < limit; ++result.iterations) {
    // Off its zeros by d, a redundant constraint looks independent by some d.
    const Scalar tolerance = std::max(rank_tolerance, std::min(Scalar(1e-3), Scalar(4) * here.position));
    if (const Evaluation e = here.factorise(precomputed, factor, tolerance, held); e != Evaluation::ok) return fail(e);
    // What was left out for that reason alone may hold a velocity.
    factored = !any_held && (factor.rank() == static_cast<int>(State::m) || !(tolerance > rank_tolerance));
    result.rank = factor.rank();
    result.least_share = factor.least_share();
    const auto change = factor.least_change(-here.value());
    StateVector<M> trial = next;
    detail::displace<M>(precomputed, t, change, trial);
    State there;
    if (!there.read(precomputed, t, trial)) return fail(Evaluation::not_finite);
    const bool halves = there.open < here.open / Scalar(2);
    if (there.open < here.open) {
      next = trial;
      here = there;
    }
    if (halves) continue;
    // An angle wound up has lost its share of the change in its rounding: the others must do without it.
    if (!State::hold_lost(next, change, held)) break;
    any_held = true;
  }
  // What is left is rounding, or a place from which no zero is reached.
  if (!here.at_rounding && !here.closed()) return fail(Evaluation::singular);
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
  // A state that needed no change was not factored for one.
  if (result.iterations == 0 && !factored && here.factorise(precomputed, factor, rank_tolerance) == Evaluation::ok) {
    result.rank = factor.rank();
    result.least_share = factor.least_share();
  }
  result.position = here.position;
  result.velocity = here.velocity;
  y = next;
  return result;
}

}  // namespace torsor::runtime
