// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// Why an integration with events ended.
enum class EventStatus : int {
  reached_end = 0,
  stopped_at_event,
  stopped_by_observer,
  accumulation,
  beyond_barrier,
  guard_not_followed,
  too_many_events,
  integration_failed,
};

[[nodiscard]] constexpr std::string_view describe(EventStatus status) noexcept {
  switch (status) {
    case EventStatus::reached_end:
      return "reached the end time";
    case EventStatus::stopped_at_event:
      return "stopped at an event";
    case EventStatus::stopped_by_observer:
      return "stopped because the observer returned false";
    case EventStatus::accumulation:
      return "the events of a guard accumulate at a finite time: go on from there with the equations of rest on it";
    case EventStatus::beyond_barrier:
      return "the state lies beyond a barrier at the start or after a reset: begin where its guard is not negative";
    case EventStatus::guard_not_followed:
      return "a guard is not finite, oscillates too fast within a step, or crosses zero on the method's interpolant "
             "but not on its steps: limit the step";
    case EventStatus::too_many_events:
      return "the limit of events was met: raise it";
    case EventStatus::integration_failed:
      return "the integration between events failed, see its own status";
  }
  return "unknown event status";
}

/// What an observer of events is told: the state is that before any reset.
template <class Scalar, std::size_t size>
struct Event {
  std::size_t guard;  ///< index in the order of declaration
  Scalar time;
  bool rising;   ///< in the direction in which the integration proceeds; of a grazing, the side it comes from is below
  bool grazing;  ///< touches zero and returns: nothing is reset
  const std::array<Scalar, size>& state;
};

/// The end of an integration with events; y is the state at `time`.
template <class Scalar, std::size_t count>
struct EventResult {
  EventStatus status = EventStatus::reached_end;
  Result<Scalar> integration;  ///< of the last smooth piece, its statistics those of all
  Scalar time = Scalar(0);
  std::size_t guard = 0;                 ///< which one ended it
  Scalar accumulation_time = Scalar(0);  ///< where events accumulate, at or after `time`
  std::array<std::int64_t, count> fired{}, grazed{};

  [[nodiscard]] explicit constexpr operator bool() const noexcept { return status == EventStatus::reached_end; }
};

/// What is remembered of a guard from step to step.
template <class Scalar>
struct GuardMemory {
  Scalar side = Scalar(0);  ///< the sign it has, +1 or -1; 0 while it has not left zero since the last start
  Scalar band = Scalar(0);  ///< what rounding may make of the guard, as last estimated
  bool fresh = true;        ///< no step was looked at since the last start
  bool leaving = true;      ///< within rounding of zero since the last start or crossing
  bool visiting = false;    ///< within rounding of zero at the end of the last step, not since the start

  void start_anew(bool keeps_side) noexcept {
    side = keeps_side ? Scalar(1) : Scalar(0);
    fresh = leaving = true;
    visiting = false;
  }
};

/// Where a guard came nearest to zero while it is visiting it.
template <class Scalar, std::size_t size>
struct NearestPlace {
  Scalar value = Scalar(0), time = Scalar(0);
  std::array<Scalar, size> y{};
};

/// Tells whether the events of a guard accumulate. Intervals that shrink geometrically, Δ_k = Δ_0 ρ^k, end at
/// t_k + S ρ⁸/(1 - ρ⁸), where S is the time of the last eight and ρ⁸ its ratio to the eight before: for a ball that
/// bounces with restitution e, ρ = e.
template <class Scalar>
class AccumulationWatch {
 public:
  /// True when no more than `tolerance` (at least eight roundings) is left, or when seventeen events lie within 128 roundings;
  /// `limit` is then the end. Roundings are those of the time, or of `scale`, the largest time in the step of the event, to
  /// which it is located: near time 0 that is larger.
  bool operator()(Scalar time, Scalar tolerance, Scalar scale = Scalar(0)) noexcept {
    times_[seen_++ % window] = time;
    if (seen_ < window) return false;
    const Scalar last = std::abs(time - back(8)), before = std::abs(back(8) - back(16));
    const Scalar rounding = std::numeric_limits<Scalar>::epsilon() * std::max(std::abs(time), scale);
    const Scalar floor = std::max(tolerance, Scalar(8) * rounding);
    const bool shrinks = last < before;
    const Scalar rest = shrinks ? last * last / (before - last) : Scalar(0);
    limit_ = back(8) <= time ? time + rest : time - rest;
    return (shrinks && rest <= floor) || last + before <= Scalar(128) * rounding;
  }
  [[nodiscard]] Scalar limit() const noexcept { return limit_; }

 private:
  static constexpr std::size_t window = 17;
  [[nodiscard]] Scalar back(std::size_t events) const noexcept { return times_[(seen_ - 1 - events) % window]; }
  std::array<Scalar, window> times_{};
  std::size_t seen_ = 0;
  Scalar limit_ = Scalar(0);
};

}  // namespace torsor::runtime
