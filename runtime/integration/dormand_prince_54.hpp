// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/integration/adaptive_run.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/steps/dormand_prince_tableau.hpp"
#include "torsor/runtime/steps/step_control.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Dormand-Prince 5(4): an error of order 5 estimated against an embedded order 4, first stage same as last, a
/// proportional-integral step control and an interpolant of order 4.
///
/// A step is kept when  sqrt(1/n Σ (e_i / (absolute + relative max(|y_i|, |y_i next|)))²) <= 1.  A stage that the model
/// refuses, or that is not finite, rejects the step; so does a state that overflows.
/// Source: Hairer-Nørsett-Wanner I, II.4 (error norm 4.11, starting step 4.14), II.5 (pair); Hairer-Wanner II, IV.2
/// (control).
struct DormandPrince54 {
  double relative_tolerance = 1e-9;      ///< 0, or at least four roundings of the scalar
  double absolute_tolerance = 1e-12;     ///< in the units of the state, the same for every component
  double first_step = 0.0;               ///< 0: chosen from the equations
  double largest_step = 0.0;             ///< 0: no limit
  std::int64_t step_limit = 10'000'000;  ///< accepted and rejected together
  bool compensated = false;              ///< carry what rounding loses of each sum of state and step

  template <class Scalar, std::size_t size>
  class Formula;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    return AdaptiveRun<Formula<Scalar, size>, DormandPrince54, S, Scalar, size>(system, y, t, *this);
  }

  struct Gains {
    static constexpr double integral = 0.04, proportional = 0.2 - 0.75 * integral, safety = 0.9;
    static constexpr double strongest_shrink = 0.2, strongest_growth = 10.0;
  };
};

/// Stages, error and interpolant of one step; see AdaptiveRun.
template <class Scalar, std::size_t size>
class DormandPrince54::Formula : public StepControl<Scalar, Gains> {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = DenseStep<Scalar, size>;
  using State = AccumulatedState<Scalar, size>;

  explicit Formula(const DormandPrince54&) noexcept {}
  static bool usable(const DormandPrince54&) noexcept { return true; }

  template <class F>
  Evaluation prepare(F& f, const StepsAhead<Scalar, size>& ahead, Scalar& length) {
    tolerances_ = ahead.tolerances;
    if (!f(ahead.range.start, ahead.y, k1_)) return f.evaluation;
    if (!(length > Scalar(0))) length = starting_step(f, ahead, k1_, 5);
    return Evaluation::ok;
  }

  // One step of length h to state.next(), its last slope in k7_; the weighted error is that of the embedded formula.
  template <class F>
  Evaluation attempt(F& f, Scalar t, Scalar h, State& state, Scalar& error) {
    using T = DormandPrinceTableau<Scalar>;
    const Vector& y = state.now();
    Vector x;
    for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + h * (T::a21 * k1_[i]);
    if (!f(t + T::c2 * h, x, k2_)) return f.evaluation;
    for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + h * (T::a31 * k1_[i] + T::a32 * k2_[i]);
    if (!f(t + T::c3 * h, x, k3_)) return f.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = y[i] + h * (T::a41 * k1_[i] + T::a42 * k2_[i] + T::a43 * k3_[i]);
    }
    if (!f(t + T::c4 * h, x, k4_)) return f.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = y[i] + h * (T::a51 * k1_[i] + T::a52 * k2_[i] + T::a53 * k3_[i] + T::a54 * k4_[i]);
    }
    if (!f(t + T::c5 * h, x, k5_)) return f.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = y[i] + h * (T::a61 * k1_[i] + T::a62 * k2_[i] + T::a63 * k3_[i] + T::a64 * k4_[i] + T::a65 * k5_[i]);
    }
    if (!f(t + h, x, k6_)) return f.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = h * (T::a71 * k1_[i] + T::a73 * k3_[i] + T::a74 * k4_[i] + T::a75 * k5_[i] + T::a76 * k6_[i]);
    }
    state.propose(x);
    const Vector& next = state.next();
    if (!all_finite(next)) return Evaluation::not_finite;
    if (!f(t + h, next, k7_)) return f.evaluation;
    Scalar sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar e =
          h * (T::e1 * k1_[i] + T::e3 * k3_[i] + T::e4 * k4_[i] + T::e5 * k5_[i] + T::e6 * k6_[i] + T::e7 * k7_[i]);
      sum += tolerances_.square(e, std::max(std::abs(y[i]), std::abs(next[i])));
    }
    error = std::sqrt(sum / static_cast<Scalar>(size));
    return Evaluation::ok;
  }

  template <class F>
  Evaluation refine(F&, Scalar, Scalar, const State&) noexcept {
    return Evaluation::ok;
  }

  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, Scalar h, const State& state) const noexcept {
    using T = DormandPrinceTableau<Scalar>;
    Step step = hermite_step<Step>({.start = t, .end = t_next, .length = h}, state, k1_, k7_);
    for (std::size_t i = 0; i < size; ++i) {
      step.coefficients[4][i] =
          h * (T::d1 * k1_[i] + T::d3 * k3_[i] + T::d4 * k4_[i] + T::d5 * k5_[i] + T::d6 * k6_[i] + T::d7 * k7_[i]);
    }
    return step;
  }

  void accept() noexcept { k1_ = k7_; }

 private:
  Tolerances<Scalar> tolerances_{};
  Vector k1_, k2_, k3_, k4_, k5_, k6_, k7_;
};

}  // namespace torsor::runtime
