// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "torsor/runtime/integration/fixed_step.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/steps/second_order.hpp"
#include "torsor/runtime/steps/spot_checks.hpp"

namespace torsor::runtime {

/// Störmer-Verlet, order 2, one evaluation a step and few more, for y = [q; v] with q' = v and accelerations that depend on
/// q alone:
///   v½ = v + h/2 a(q),  q(t + h) = q + h v½,  v(t + h) = v½ + h/2 a(q(t + h)).
/// Symplectic, symmetric and explicit; sums are compensated. Stable while h times the highest frequency is below 2.
/// Observers may take the steps themselves, the cubic through the states and slopes of both ends, of order 3 inside.
///
/// The accelerations depend on q alone exactly when the mass matrix is constant and no action depends on velocities.
/// Before the first step this is tried: a must not change when v does, at the start and at places about it; otherwise
/// the integration ends at once with `unsuitable_model` (take `VariationalIntegrator` or `GaussCollocation`). It is
/// tried again after 1, 2, 4, ... steps and after every 64, two evaluations each: a damper that is switched on later
/// ends the integration at the next of these, and one that acts for fewer steps may pass unseen. A system
/// may say `static constexpr bool accelerations_depend_on_velocities = false` to be spared that, or true.
/// Source: Hairer-Lubich-Wanner, Geometric Numerical Integration, I.1.4 (1.17), and VIII.5 for the rounding.
struct StoermerVerlet {
  static constexpr int order = 2;

  double step = 0.0;  ///< in units of time, positive in both directions of time
  std::int64_t step_limit = usual_fixed_step_limit;

  template <class S, class Scalar, std::size_t size>
  class Formula;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    static_assert(is_second_order<S> && size % 2 == 0,
                  "Stoermer-Verlet needs y = [q; v] with q' = v: the system must say second_order = true");
    return FixedStepRun<Formula<S, Scalar, size>, S, Scalar, size>(system, y, t, step, Formula<S, Scalar, size>{},
                                                                    step_limit);
  }
};

template <class S, class Scalar, std::size_t size>
class StoermerVerlet::Formula {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = DenseStep<Scalar, size, 4>;

  template <class F>
  [[nodiscard]] IntegrationStatus prepare(F& f, Scalar t, const Vector& y) {
    if constexpr (requires { std::remove_cvref_t<S>::accelerations_depend_on_velocities; }) {
      if (std::remove_cvref_t<S>::accelerations_depend_on_velocities) return IntegrationStatus::unsuitable_model;
    } else {
      for (int place = 0; place < 3; ++place) {
        if (feels_velocities(f, t, y, place)) return IntegrationStatus::unsuitable_model;
      }
    }
    return f(t, y, slope_) ? IntegrationStatus::reached_end : IntegrationStatus::model_failure;
  }

  template <class F>
  [[nodiscard]] IntegrationStatus step(F& f, Scalar t, Scalar h, const Vector& y, Vector& next) {
    if constexpr (!requires { std::remove_cvref_t<S>::accelerations_depend_on_velocities; }) {
      if (checks_.due() && feels_velocities(f, t, y, 0)) return IntegrationStatus::unsuitable_model;
    }
    const Scalar to_middle = h / Scalar(2);
    CompensatedState<Scalar, size> state = state_;
    first_slope_ = slope_;
    next = y;
    for (std::size_t i = half; i < size; ++i) next[i] = state.add(i, y[i], to_middle * slope_[i]);
    // The velocity's own rest, below half its last place, is less than the product with h rounds away.
    for (std::size_t i = 0; i < half; ++i) next[i] = state.add(i, y[i], h * next[half + i]);
    if (!f(t + h, next, slope_)) return IntegrationStatus::model_failure;
    for (std::size_t i = half; i < size; ++i) next[i] = state.add(i, next[i], to_middle * slope_[i]);
    state_ = state;
    return IntegrationStatus::reached_end;
  }

  template <class F>
  [[nodiscard]] bool refine(F&, Scalar, Scalar, const Vector&, const Vector&) noexcept {
    return true;
  }

  // The accelerations of both ends are known; q' is v itself there.
  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, const Vector& y, const Vector& next) const noexcept {
    Vector first = first_slope_, last = slope_;
    for (std::size_t i = 0; i < half; ++i) {
      first[i] = y[half + i];
      last[i] = next[half + i];
    }
    return hermite_step<Step>({.start = t, .end = t_next, .length = t_next - t}, Ends{y, next}, first, last);
  }

 private:
  struct Ends {
    const Vector &from, &to;
    [[nodiscard]] const Vector& now() const noexcept { return from; }
    [[nodiscard]] const Vector& next() const noexcept { return to; }
  };
  static constexpr std::size_t half = size / 2;

  // Compares a(q, v) with a(q, 0) at a place about q and velocities about v, all shifts different from each other.
  // Where the model cannot be evaluated nothing is learnt.
  template <class F>
  bool feels_velocities(F& f, Scalar t, Vector y, int place) {
    Vector at_rest, moving;
    Scalar fastest = Scalar(1);  // a damper may act above some speed only
    for (std::size_t i = half; i < size; ++i) fastest = std::max(fastest, std::abs(y[i]));
    for (std::size_t i = 0; i < half; ++i) {
      const Scalar shift = Scalar(0.37) + Scalar(0.61) * spread<Scalar>(i);
      y[i] += static_cast<Scalar>(place) * shift * (Scalar(0.1) + std::abs(y[i]));
      y[half + i] = Scalar(0);
    }
    const Vector still = y;
    for (std::size_t i = 0; i < half; ++i) {
      y[half + i] = fastest * (Scalar(1.3) + Scalar(0.7) * spread<Scalar>(3 * i + 1));
    }
    if (!f(t, still, at_rest) || !f(t, y, moving)) return false;
    for (std::size_t i = half; i < size; ++i) {
      // A model may lose some digits where terms in the velocities cancel.
      const Scalar slack = Scalar(1000) * std::numeric_limits<Scalar>::epsilon();
      if (std::abs(moving[i] - at_rest[i]) > slack * (std::abs(at_rest[i]) + std::abs(moving[i]))) return true;
    }
    return false;
  }

  SpotChecks checks_;
  CompensatedState<Scalar, size> state_;
  Vector slope_{}, first_slope_{};
};

}  // namespace torsor::runtime
