// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "runtime/dense_step.hpp"
#include "runtime/status.hpp"
#include "runtime/system.hpp"

namespace torsor::runtime {

/// Whether an integration can throw at all: only a system or an observer that is not `noexcept` makes it so.
template <class S, class Observer, class Scalar, std::size_t size>
inline constexpr bool never_throws =
    std::is_nothrow_invocable_v<S&, const Scalar&, const std::array<Scalar, size>&, std::array<Scalar, size>&> &&
    (std::is_nothrow_invocable_v<Observer&, const Scalar&, const std::array<Scalar, size>&> ||
     std::is_nothrow_invocable_v<Observer&, const DenseStep<Scalar, size>&>);

/// Integrates y' = f(t, y) from t0 to t1, forwards or backwards, and leaves y at t1, which is hit exactly.
///
/// The method is a value that carries its options: `Midpoint{.step = 1e-3}`, `RungeKutta4{.step = 1e-3}`,
/// `DormandPrince54{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12}`.
/// The observer is called as `observer(t, y)` at the start and after every step kept; with Dormand-Prince it may take a
/// `const DenseStep&` instead (each step, no call at the start). One that returns a bool ends the integration by false.
/// Nothing is allocated. Errors come back in the result; y is then the last good state, at `result.time`.
template <class S, class Scalar, std::size_t size, class Method, class Observer = IgnoreSteps>
requires System<S, Scalar, size>
[[nodiscard]] Result<Scalar> integrate(
    S&& system, std::array<Scalar, size>& y, std::type_identity_t<Scalar> t0, std::type_identity_t<Scalar> t1,
    const Method& method, Observer&& observer = Observer{}) noexcept(never_throws<S, Observer, Scalar, size>) {
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
[[nodiscard]] Result<Scalar> integrate_through(S&& system, std::array<Scalar, size>& y, std::type_identity_t<Scalar> t0,
                                               std::type_identity_t<std::span<const Scalar>> times,
                                               const Method& method,
                                               Observer&& observer) noexcept(never_throws<S, Observer, Scalar, size>) {
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
