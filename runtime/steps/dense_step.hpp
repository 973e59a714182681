// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// One accepted step of a Dormand-Prince method, to be evaluated at any time inside it, ends included; continuously
/// differentiable from step to step. With five terms it is the interpolant of order 4 of the pair 5(4) (local error
/// h^5), with eight that of order 7 of the method 8(5,3) (local error h^8).
/// Source: Hairer-Nørsett-Wanner I, II.6 (6.12) and II.10, in the form of their codes (contd5, contd8):
///   y(t + θ h) = c0 + θ (c1 + (1 - θ) (c2 + θ (c3 + (1 - θ) (c4 + ...)))).
template <class Scalar, std::size_t size, std::size_t terms = 5>
struct DenseStep {
  Scalar start;  ///< time at which the step begins
  Scalar end;    ///< time at which it ends, before `start` when time runs backwards
  std::array<std::array<Scalar, size>, terms> coefficients;

  /// The state at a time between `start` and `end`.
  [[nodiscard]] std::array<Scalar, size> operator()(Scalar time) const noexcept {
    const Scalar theta = (time - start) / (end - start);
    const Scalar rest = Scalar(1) - theta;
    std::array<Scalar, size> y = coefficients[terms - 1];
    for (std::size_t k = terms - 1; k-- > 0;) {
      const Scalar factor = k % 2 == 0 ? theta : rest;
      for (std::size_t i = 0; i < size; ++i) y[i] = coefficients[k][i] + factor * y[i];
    }
    return y;
  }
};

/// From when to when a step goes. Its length is that which the method took: end - start may be another by rounding.
template <class Scalar>
struct StepTimes {
  Scalar start, end, length;
};

/// The first four terms, which interpolate the states and slopes at both ends of a step.
template <class Step, class Scalar, class State, std::size_t size>
[[nodiscard]] Step hermite_step(const StepTimes<Scalar>& times, const State& state,
                                const std::array<Scalar, size>& first_slope,
                                const std::array<Scalar, size>& last_slope) noexcept {
  const Scalar h = times.length;
  Step step{times.start, times.end, {}};
  auto& c = step.coefficients;
  for (std::size_t i = 0; i < size; ++i) {
    c[0][i] = state.now()[i];
    c[1][i] = state.next()[i] - state.now()[i];
    c[2][i] = h * first_slope[i] - c[1][i];
    c[3][i] = c[1][i] - h * last_slope[i] - c[2][i];
  }
  return step;
}

/// The steps that a run of a method shows to its observers; void where it shows states only.
template <class Run>
struct StepOfRun {
  using type = void;
};
template <class Run>
requires requires { typename Run::Step; }
struct StepOfRun<Run> {
  using type = typename Run::Step;
};

/// Whether an observer wants whole steps, to be evaluated inside, rather than the states at their ends.
template <class Observer, class Step>
inline constexpr bool takes_steps =
    std::is_invocable_v<Observer&, const Step&> && !std::is_same_v<std::remove_cvref_t<Observer>, IgnoreSteps>;
template <class Observer>
inline constexpr bool takes_steps<Observer, void> = false;

}  // namespace torsor::runtime
