// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "torsor/runtime/constraints/constraint_kinds.hpp"
#include "torsor/runtime/constraints/constraint_reading.hpp"
#include "torsor/runtime/constraints/independent_constraints.hpp"
#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// A mechanism generated with the kernels `mass_matrix` and `constraints`.
template <class M>
concept HasConstraintMetric = HasConstraints<M> && M::multiplier_count >
0 && requires(const typename M::Precomputed& precomputed, const typename M::State& state,
              std::array<ScalarOf<M>, velocities_of<M> * velocities_of<M>>& mass) {
  M::mass_matrix(precomputed, state, mass);
};

/// What a projection did. Residuals are the largest |f_i| and |A v - b|_i, each over the size Σ_j |A_ij| of its row: a
/// displacement of the coordinates, and a rate of them. The rank is that of all constraints, unless it failed.
template <class Scalar>
struct Projection {
  Evaluation evaluation = Evaluation::ok;
  Scalar position = Scalar(0), velocity = Scalar(0);
  Scalar least_share = Scalar(1);  ///< see IndependentConstraints
  int rank = 0;
  int iterations = 0;
};

/// Puts a state onto its constraints by the least change in the metric of the masses:
///   δq = -M⁻¹ Fᵀ (F M⁻¹ Fᵀ)⁺ f(q, t), repeated until f is down to rounding;   δv = -M⁻¹ Aᵀ (A M⁻¹ Aᵀ)⁺ (A v - b),
/// F being the rows of A that are derivatives of f: constraints on velocities alone (rolling) say nothing of positions.
/// Unit quaternions are turned by δq and given their norm back. What is rounding already is left alone, in positions
/// and in velocities (see ConstraintReading). An angle wound up so far that its share of a change is lost in its
/// rounding is left to the others, which close the loop without it. Constraints that repeat others within
/// `rank_tolerance` are left out of the factor and must close by themselves. `singular` when f has no zero near, when
/// corrections grow from one to the next, or when constraints contradict each other in position or in velocity;
/// `not_finite` when anything is; y is then left alone. Source: Hairer-Wanner II, VII.2 (projection); Lubich, Engstler,
/// Nowak & Pöhle 1995 (mass metric); Deuflhard, Newton Methods for Nonlinear Problems, 2.1 (growing corrections).
template <HasConstraintMetric M>
[[nodiscard]] Projection<ScalarOf<M>> project_on_constraints(
    const typename M::Precomputed& precomputed, ScalarOf<M> t, StateVector<M>& y,
    ScalarOf<M> rank_tolerance = usual_rank_tolerance<ScalarOf<M>>()) noexcept;

namespace detail {

/// The steps of `project_on_constraints`.
template <HasConstraintMetric M>
class ProjectionOnConstraints {
 public:
  using Scalar = ScalarOf<M>;
  using Kinds = ConstraintKinds<M>;
  using Reading = ConstraintReading<M>;
  using Rows = typename Reading::Rows;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);

  ProjectionOnConstraints(const typename M::Precomputed& precomputed, const Kinds& kinds, Scalar t,
                          Scalar rank_tolerance) noexcept
      : precomputed_(precomputed), kinds_(kinds), t_(t), rank_tolerance_(rank_tolerance) {}

  /// `with_rank`: tells the rank of a state that needs no projection too.
  [[nodiscard]] Projection<Scalar> operator()(StateVector<M>& y, bool with_rank) noexcept {
    next_ = y;
    if constexpr (HasQuaternions<M>) normalise_quaternions<M>(next_);
    result_.evaluation = here_.read(precomputed_, kinds_, t_, next_) ? Evaluation::ok : Evaluation::not_finite;
    const bool done = result_.evaluation == Evaluation::ok && positions() && velocities() &&
                      (!with_rank || all_factored_ || factorise(rank_tolerance_, false));
    if (!done) return result_;
    result_.position = here_.position;
    result_.velocity = here_.velocity;
    y = next_;
    return result_;
  }

 private:
  using Column = SmallMatrix<Scalar, nv>;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();

  bool fail(Evaluation evaluation) noexcept {
    result_.evaluation = evaluation;
    return false;
  }

  // Newton's steps end where rounding does: at the first that no longer halves the residual.
  bool positions() noexcept {
    constexpr int limit = 30;
    constexpr Scalar growth = Scalar(10);  // of one correction over the largest before: Newton's method leads away
    Scalar largest = std::numeric_limits<Scalar>::infinity();
    bool grows = false;
    for (; !is_rounding() && result_.iterations < limit; ++result_.iterations) {
      // Off its zeros by d, a redundant constraint looks independent by some d.
      const Scalar tolerance = std::max(rank_tolerance_, std::min(Scalar(1e-3), Scalar(4) * here_.displacement));
      if (!factorise(tolerance, true)) return false;
      const Column change = factor_.least_change(-here_.value(lengths_));
      const Scalar moved = here_.motion_by(kinds_, change);
      grows = moved > growth * largest;
      if (grows) break;
      largest = result_.iterations == 0 ? moved : std::max(largest, moved);
      StateVector<M> trial = next_;
      displace<M>(precomputed_, t_, change, trial);
      Reading there;
      if (!there.read(precomputed_, kinds_, t_, trial)) return fail(Evaluation::not_finite);
      const bool halves = there.open < here_.open / Scalar(2);
      if (there.open < here_.open) {
        next_ = trial;
        here_ = there;
        all_factored_ = all_factored_ && !any_held_;
      }
      if (halves) continue;
      // An angle wound up has lost its share of the change in its rounding: the others must do without it.
      if (!hold_lost(change)) break;
      any_held_ = true;
    }
    // What is left is rounding, or a place from which no zero is reached.
    return is_rounding() || closed(grows) || fail(Evaluation::singular);
  }

  // Lengths are looked at once, where they could matter.
  bool is_rounding() noexcept {
    if (here_.position_is_rounding(lengths_)) return true;
    if (lengths_known_ || !here_.position_may_be_rounding()) return false;
    lengths_ = Reading::lengths(precomputed_, kinds_, t_, next_);
    lengths_known_ = true;
    return here_.position_is_rounding(lengths_);
  }

  // Whether a residual on which Newton's method stands still may be rounding: of places far away and of angles wound
  // up; near a change point magnified, of constraints that are let go.
  bool closed(bool grows) noexcept {
    if (!lengths_known_) lengths_ = Reading::lengths(precomputed_, kinds_, t_, next_);
    const Scalar roundings = grows ? Scalar(64) : Scalar(1e6);
    bool within = true;
    for (std::size_t i = 0; i < m; ++i) within = within && here_.position_is_closed(i, lengths_, roundings);
    return within;
  }

  bool velocities() noexcept {
    for (int repeat = 0; repeat < 3 && !here_.velocity_is_rounding(); ++repeat) {
      if (!all_factored_ && !factorise(rank_tolerance_, false)) return false;
      const Column change = factor_.least_change(-here_.rate());
      StateVector<M> trial = next_;
      for (std::size_t i = 0; i < nv; ++i) trial[coordinates_of<M> + i] += change(static_cast<int>(i));
      Reading there;
      if (!there.read(precomputed_, kinds_, t_, trial)) return fail(Evaluation::not_finite);
      if (!(there.parting < here_.parting)) break;
      next_ = trial;
      here_ = there;
    }
    // Constraints that are left out may keep a share of the order of the rank tolerance, not all of it.
    const Scalar left_over = Scalar(2e6) * epsilon + Scalar(1e3) * rank_tolerance_;
    return here_.velocity_is_rounding() || here_.velocity_is_within(left_over) || fail(Evaluation::singular);
  }

  // Of the holonomic constraints alone, or of all. What is held counts as infinitely heavy.
  bool factorise(Scalar tolerance, bool holonomic) noexcept {
    std::array<Scalar, nv * nv> mass;
    M::mass_matrix(precomputed_, here_.state, mass);
    auto jacobian = here_.constraints.jacobian;
    bool all = true;
    for (std::size_t i = 0; i < m && holonomic; ++i) {
      if (kinds_.holonomic[i]) continue;
      all = false;
      for (std::size_t j = 0; j < nv; ++j) jacobian[j * m + i] = Scalar(0);
    }
    for (std::size_t i = 0; i < nv && holonomic; ++i) {
      if (held_[i]) mass[i * (nv + 1)] /= epsilon * epsilon;
    }
    const Evaluation evaluation = factor_.factorise(mass, jacobian, tolerance, kinds_.usual);
    if (evaluation != Evaluation::ok) return fail(evaluation);
    result_.rank = factor_.rank();
    result_.least_share = factor_.least_share();
    // What was left out for its tolerance alone may hold a velocity.
    all_factored_ = all && !(holonomic && any_held_) &&
                    (result_.rank == static_cast<int>(m) || !(tolerance > rank_tolerance_));
    return true;
  }

  // Marks the angles of which a change is lost in rounding; whether there are more than before.
  bool hold_lost(const Column& change) noexcept {
    bool more = false;
    for (std::size_t i = 0; i < nv; ++i) {
      if (held_[i] || !kinds_.turns[i] || kinds_.coordinate[i] == Kinds::nq) continue;
      const Scalar angle = std::abs(next_[kinds_.coordinate[i]]);
      held_[i] = angle > Kinds::whole_turn && std::abs(change(static_cast<int>(i))) < epsilon * angle;
      more = more || held_[i];
    }
    return more;
  }

  const typename M::Precomputed& precomputed_;
  const Kinds& kinds_;
  Scalar t_, rank_tolerance_;
  IndependentConstraints<Scalar, nv, m> factor_;
  Projection<Scalar> result_;
  StateVector<M> next_{};
  Reading here_;
  Rows lengths_{};
  bool lengths_known_ = false;
  bool all_factored_ = false;  // the factor is one of all constraints, at this position
  std::array<bool, nv> held_{};
  bool any_held_ = false;
};

}  // namespace detail

template <HasConstraintMetric M>
Projection<ScalarOf<M>> project_on_constraints(const typename M::Precomputed& precomputed, ScalarOf<M> t,
                                               StateVector<M>& y, ScalarOf<M> rank_tolerance) noexcept {
  const auto kinds = ConstraintKinds<M>::at(precomputed, t, y);
  return detail::ProjectionOnConstraints<M>(precomputed, kinds, t, rank_tolerance)(y, true);
}

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

  /// Constraints of which the others leave less than `rank_tolerance` are not enforced; see IndependentConstraints. 0:
  /// as the motion itself does it, else by the usual one.
  explicit Projected(Motion motion, Scalar rank_tolerance = Scalar(0)) noexcept
      : Motion(std::move(motion)),
        rank_tolerance_(rank_tolerance),
        kinds_(ConstraintKinds<Mechanism>::at(this->precomputed(), this->initial_time(), this->initial())) {}

  [[nodiscard]] Evaluation project(Scalar t, Vector& y) const noexcept {
    if constexpr (requires { Motion::settle(t, y); }) {  // knows its change points
      if (!(rank_tolerance_ > Scalar(0))) return Motion::settle(t, y);
    }
    const Scalar tolerance = rank_tolerance_ > Scalar(0) ? rank_tolerance_ : usual_rank_tolerance<Scalar>();
    const bool with_rank = false;
    return detail::ProjectionOnConstraints<Mechanism>(this->precomputed(), kinds_, t, tolerance)(y, with_rank)
        .evaluation;
  }

 private:
  Scalar rank_tolerance_;
  ConstraintKinds<Mechanism> kinds_;
};

template <class Motion>
requires HasConstraintMetric<typename Motion::Mechanism>
[[nodiscard]] Projected<Motion> projected(Motion motion,
                                          ScalarOf<typename Motion::Mechanism> rank_tolerance = {}) noexcept {
  return Projected<Motion>(std::move(motion), rank_tolerance);
}

/// A mechanism without constraints has nothing to be projected on: its motion as it is, for code of any mechanism.
template <class Motion>
requires(Motion::Mechanism::multiplier_count == 0) [[nodiscard]] Motion projected(
    Motion motion, ScalarOf<typename Motion::Mechanism> /*rank_tolerance*/ = {}) noexcept {
  return motion;
}

template <HasConstraintMetric M>
class RankDistance;
template <HasConstraintMetric M>
class ChangePoints;

}  // namespace torsor::runtime

// equations_of_motion makes motions that are projected by default: it builds on what is above.
#include "torsor/runtime/mechanism.hpp"
