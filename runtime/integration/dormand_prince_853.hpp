// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "torsor/runtime/integration/adaptive_run.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/steps/dormand_prince_tableau_853.hpp"
#include "torsor/runtime/steps/step_control.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Dormand-Prince 8(5,3), for sharp tolerances (1e-6 and below): twelve evaluations a step, the error estimated by
/// embedded solutions of orders 5 and 3, and an interpolant of order 7 that costs three evaluations more, made for
/// observers that take whole steps only.
///
/// With the weighted norms E5 and E3 of the two differences, as in DormandPrince54, a step is kept when
///   h E5² / sqrt(E5² + E3²/100) <= 1,
/// which falls with h^8. A stage that the model refuses, or that is not finite, rejects the step.
/// Source: Hairer-Nørsett-Wanner I, II.5 (error estimate: II.10, (10.17)), code dop853.
struct DormandPrince853 {
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
    return AdaptiveRun<Formula<Scalar, size>, DormandPrince853, S, Scalar, size>(system, y, t, *this);
  }

  struct Gains {
    // At the usual 0.9 pendulums have every fifth step rejected; 0.8 saves a tenth of all evaluations.
    static constexpr double integral = 0.0, proportional = 0.125, safety = 0.8;
    static constexpr double strongest_shrink = 1.0 / 3.0, strongest_growth = 6.0;
  };
};

/// Stages, error and interpolant of one step; see AdaptiveRun.
template <class Scalar, std::size_t size>
class DormandPrince853::Formula : public StepControl<Scalar, Gains> {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = DenseStep<Scalar, size, 8>;
  using State = AccumulatedState<Scalar, size>;

  explicit Formula(const DormandPrince853&) noexcept {}
  static bool usable(const DormandPrince853&) noexcept { return true; }

  template <class F>
  Evaluation prepare(F& f, const StepsAhead<Scalar, size>& ahead, Scalar& length) {
    tolerances_ = ahead.tolerances;
    if (!f(ahead.range.start, ahead.y, k_[0])) return f.evaluation;
    if (!(length > Scalar(0))) length = starting_step(f, ahead, k_[0], 8);
    return Evaluation::ok;
  }

  // The slope at the end is needed only where the step is kept.
  template <class F>
  Evaluation attempt(F& f, Scalar t, Scalar h, State& state, Scalar& error) {
    if (!stages<T::stage_2>(f, t, h, state.now(), std::make_index_sequence<11>{})) return f.evaluation;
    Vector slope, increment;
    for (std::size_t i = 0; i < size; ++i) {
      slope[i] = combination<T::solution>(i);
      increment[i] = h * slope[i];
    }
    state.propose(increment);
    const Vector& next = state.next();
    if (!all_finite(next)) return Evaluation::not_finite;
    Scalar fifth = Scalar(0), third = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar magnitude = std::max(std::abs(state.now()[i]), std::abs(next[i]));
      fifth += tolerances_.square(combination<T::fifth_order>(i), magnitude);
      third += tolerances_.square(slope[i] - third_order(i), magnitude);
    }
    const Scalar mixed = fifth + Scalar(0.01) * third;
    error = mixed == Scalar(0) ? Scalar(0) : std::abs(h) * fifth / std::sqrt(mixed * static_cast<Scalar>(size));
    if (error <= Scalar(1) && !f(t + h, next, k_[12])) return f.evaluation;
    return Evaluation::ok;
  }

  template <class F>
  Evaluation refine(F& f, Scalar t, Scalar h, const State& state) {
    return stages<T::stage_14>(f, t, h, state.now(), std::make_index_sequence<3>{}) ? Evaluation::ok : f.evaluation;
  }

  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, Scalar h, const State& state) const noexcept {
    Step step = hermite_step<Step>({.start = t, .end = t_next, .length = h}, state, k_[0], k_[12]);
    for (std::size_t i = 0; i < size; ++i) {
      step.coefficients[4][i] = h * combination<T::dense>(i);
      step.coefficients[5][i] = h * combination<T::dense + 1>(i);
      step.coefficients[6][i] = h * combination<T::dense + 2>(i);
      step.coefficients[7][i] = h * combination<T::dense + 3>(i);
    }
    return step;
  }

  void accept() noexcept { k_[0] = k_[12]; }

 private:
  using T = DormandPrinceTableau853;

  template <std::size_t first_row, class F, std::size_t... more>
  bool stages(F& f, Scalar t, Scalar h, const Vector& y, std::index_sequence<more...>) {
    return (stage<first_row + more>(f, t, h, y) && ...);
  }

  // The slopes are numbered as the rows of the tableau, after the first.
  template <std::size_t row, class F>
  bool stage(F& f, Scalar t, Scalar h, const Vector& y) {
    Vector x;
    for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + h * combination<row>(i);
    return f(t + static_cast<Scalar>(T::times[row + 1]) * h, x, k_[row + 1]);
  }

  template <std::size_t row>
  [[nodiscard]] Scalar combination(std::size_t i) const noexcept {
    return combination<row>(i, std::make_index_sequence<T::slopes>{});
  }

  template <std::size_t row, std::size_t... slope>
  [[nodiscard]] Scalar combination(std::size_t i, std::index_sequence<slope...>) const noexcept {
    Scalar sum = Scalar(0);
    const auto add = [&]<std::size_t j>(std::integral_constant<std::size_t, j>) noexcept {
      if constexpr (T::weights[row][j] != 0.0L) sum += static_cast<Scalar>(T::weights[row][j]) * k_[j][i];
    };
    (add(std::integral_constant<std::size_t, slope>{}), ...);
    return sum;
  }

  [[nodiscard]] Scalar third_order(std::size_t i) const noexcept {
    Scalar sum = Scalar(0);
    for (std::size_t j = 0; j < 3; ++j) sum += static_cast<Scalar>(T::third_order[j]) * k_[T::third_order_slopes[j]][i];
    return sum;
  }

  Tolerances<Scalar> tolerances_{};
  std::array<Vector, T::slopes> k_;
};

}  // namespace torsor::runtime
