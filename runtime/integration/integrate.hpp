// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// One integration under way with a method: what its `start` gives.
template <class Method, class S, class Scalar, std::size_t size>
using RunOf = decltype(std::declval<const Method&>().start(
    std::declval<S&>(), std::declval<std::array<Scalar, size>&>(), std::declval<Scalar>()));

/// The steps that a method shows to observers which take them; void where it shows states only.
template <class Method, class S, class Scalar, std::size_t size>
using StepOf = typename StepOfRun<RunOf<Method, std::remove_reference_t<S>, Scalar, size>>::type;

/// Whether an integration can throw at all: only a system or an observer that is not `noexcept` makes it so.
template <class S, class Observer, class Step, class Scalar, std::size_t size>
[[nodiscard]] constexpr bool never_throws() noexcept {
  if (!std::is_nothrow_invocable_v<S&, const Scalar&, const std::array<Scalar, size>&, std::array<Scalar, size>&>)
    return false;
  if constexpr (takes_steps<Observer, Step>)
    return std::is_nothrow_invocable_v<Observer&, const Step&>;
  else
    return std::is_nothrow_invocable_v<Observer&, const Scalar&, const std::array<Scalar, size>&>;
}

/// The result where there is no motion from a start.
template <class Scalar>
[[nodiscard]] constexpr Result<Scalar> no_start(Scalar t0, Evaluation evaluation) noexcept {
  Result<Scalar> result;
  result.status = IntegrationStatus::model_failure;
  result.evaluation = evaluation;
  result.time = t0;
  return result;
}

/// Integrates y' = f(t, y) from t0 to t1, forwards or backwards, and leaves y at t1, which is hit exactly.
///
/// The method is a value that carries its options: `Midpoint{.step = 1e-3}`, `RungeKutta4{.step = 1e-3}`,
/// `DormandPrince54{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12}`.
/// The observer is called as `observer(t, y)` at the start and after every step kept; with a method that has an
/// interpolant (all but Runge-Kutta 4, midpoint and the variational integrator) it may take the step itself instead,
/// `observer(const auto& step)` (each step, no call at the start): step.start, step.end and step(t), the state at a time
/// between them. One that returns a bool ends the integration by false.
/// Nothing is allocated. Errors come back in the result; y is then the last good state, at `result.time`. Quaternions of the
/// start are given norm 1 first, and constraints are met by the first step: close an open start before.
template <class S, class Scalar, std::size_t size, class Method, class Observer = IgnoreSteps>
requires System<S, Scalar, size>
[[nodiscard]] Result<Scalar> integrate(
    S&& system, std::array<Scalar, size>& y, std::type_identity_t<Scalar> t0, std::type_identity_t<Scalar> t1,
    const Method& method,
    Observer&& observer =
        Observer{}) noexcept(never_throws<S, Observer, StepOf<Method, S, Scalar, size>, Scalar, size>()) {
  if (const Evaluation settled = settle_start(system, y); settled != Evaluation::ok) return no_start(t0, settled);
  auto run = method.start(system, y, t0);
  if constexpr (std::is_invocable_v<Observer&, const Scalar&, const std::array<Scalar, size>&>) {
    if (!notify(observer, t0, y)) run.stop();
  }
  run.advance(t1, observer);
  return run.result();
}

/// As `integrate`, through given times in turn, each hit exactly; the observer is called as `observer(t, y)` at those
/// times only (at t0 too when it is the first of them). An adaptive method keeps its step from one time to the next.
template <class S, class Scalar, std::size_t size, class Method, class Observer>
requires System<S, Scalar, size>
[[nodiscard]] Result<Scalar> integrate_through(
    S&& system, std::array<Scalar, size>& y, std::type_identity_t<Scalar> t0,
    std::type_identity_t<std::span<const Scalar>> times, const Method& method,
    Observer&& observer) noexcept(never_throws<S, Observer, StepOf<Method, S, Scalar, size>, Scalar, size>()) {
  if (const Evaluation settled = settle_start(system, y); settled != Evaluation::ok) return no_start(t0, settled);
  auto run = method.start(system, y, t0);
  const IgnoreSteps ignore;
  for (const Scalar& t : times) {
    run.advance(t, ignore);
    if (run.result().status != IntegrationStatus::reached_end) break;
    if (!notify(observer, t, y)) run.stop();
  }
  return run.result();
}

}  // namespace torsor::runtime
