// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

#include "torsor/runtime/events/event_watch.hpp"
#include "torsor/runtime/integration/integrate.hpp"

namespace torsor::runtime {

/// As `integrate_with_events` below, each piece by the run that `begin(t)` gives at its start: a new one of the method, or
/// one that is under way there and goes on.
template <class Begin, class S, class Scalar, std::size_t size, class Method, class Set, class OnEvent, class Observer>
requires System<S, Scalar, size>
[[nodiscard]] EventResult<Scalar, Set::count> integrate_pieces(Begin&& begin, S& system, std::array<Scalar, size>& y,
                                                               std::type_identity_t<Scalar> t0,
                                                               std::type_identity_t<Scalar> t1, const Method& method,
                                                               const Set& set, OnEvent& on_event, Observer& observer) {
  using Watch = EventWatch<S, Method, Scalar, size, Set, OnEvent, Observer>;
  EventResult<Scalar, Set::count> result;
  result.time = t0;
  if (const Evaluation settled = settle_start(system, y); settled != Evaluation::ok) {
    result.status = EventStatus::integration_failed;
    result.integration = no_start(t0, settled);
    return result;
  }
  Watch watch(system, method, set, on_event, observer, result);
  if constexpr (std::is_invocable_v<Observer&, const Scalar&, const std::array<Scalar, size>&>) {
    if (!notify(observer, t0, y)) result.status = EventStatus::stopped_by_observer;
  }
  Statistics total;
  const auto integrate_piece = [&] {
    auto&& run = begin(result.time);
    watch.start(result.time, y);
    run.advance(t1, watch);
    result.integration = run.result();
    total += result.integration.statistics;
    result.time = result.integration.time;
    if (watch.restarts() || result.status != EventStatus::reached_end) {
      y = watch.state();
      result.time = watch.time();
    } else if (!result.integration) {
      result.status = EventStatus::integration_failed;
    }
    if (watch.failure() != Evaluation::ok) {
      result.integration.status = IntegrationStatus::model_failure;
      result.integration.evaluation = watch.failure();
    }
  };
  while (result.status == EventStatus::reached_end) {
    integrate_piece();
    if (result.time == t1) break;
  }
  if (result.status != EventStatus::integration_failed) result.integration.status = IntegrationStatus::reached_end;
  result.integration.statistics = total;
  result.integration.statistics.calls += watch.calls();
  return result;
}

/// Integrates y' = f(t, y) from t0 to t1 by any method, while guards g_i(t, y) are watched: where one passes through
/// zero, the observer is told, the integration ends, or the state is set anew and the method starts again from there.
///
///   const auto floor = barrier([](double, const State& y) { return y[0]; },
///                              [](double, State& y) { y[1] *= -0.8; });
///   const auto result = integrate_with_events(ball, y, 0, 10, DormandPrince54{}, Events(floor));
///
/// Crossings are located to neighbouring numbers of time on the method's interpolant, or on steps of the method where
/// it has none (see guard.hpp for `by_stepping`, and for what counts as grazing). At a barrier the state is the last
/// one on its side, at any other guard the first beyond. Where the system has a `project`, events lie on settled
/// states, and what a reset leaves is settled before the method starts again. `on_event(const Event&)` is told of each
/// crossing and grazing in time, before a reset; `observer(t, y)` sees the start, the ends of steps and of what resets
/// cut off, and the states after resets, or, instead, the steps themselves as something with start, end and
/// operator()(time). Either ends the integration by returning false. A guard at zero at the start has no event until it
/// has left zero. Nothing is allocated. The end comes back in the result, y is the state at `result.time`.
template <class S, class Scalar, std::size_t size, class Method, class Set, class OnEvent = IgnoreSteps,
          class Observer = IgnoreSteps>
requires System<S, Scalar, size>
[[nodiscard]] EventResult<Scalar, Set::count> integrate_with_events(
    S&& system, std::array<Scalar, size>& y, std::type_identity_t<Scalar> t0, std::type_identity_t<Scalar> t1,
    const Method& method, const Set& set, OnEvent&& on_event = OnEvent{}, Observer&& observer = Observer{}) {
  const auto begin = [&](Scalar t) { return method.start(system, y, t); };
  return integrate_pieces(begin, system, y, t0, t1, method, set, on_event, observer);
}

}  // namespace torsor::runtime
