// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "torsor/runtime/events/event_memory.hpp"
#include "torsor/runtime/events/guard.hpp"
#include "torsor/runtime/events/guard_follower.hpp"
#include "torsor/runtime/events/located.hpp"
#include "torsor/runtime/steps/whole_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// The observer that stands between a method and its user while guards are watched: it looks through each step, tells
/// of events, and ends the run where the state must be set anew.
template <class S, class Method, class Scalar, std::size_t size, class Set, class OnEvent, class Observer>
class EventWatch {
 public:
  using Vector = std::array<Scalar, size>;
  static constexpr std::size_t count = Set::count;
  using EventResultType = EventResult<Scalar, count>;

  EventWatch(S& system, const Method& method, const Set& set, OnEvent& on_event, Observer& observer,
             EventResultType& result) noexcept
      : system_(system), method_(method), set_(set), on_event_(on_event), observer_(observer), result_(result), guards_(set) {}

  /// A smooth piece begins.
  void start(Scalar t, const Vector& y) noexcept {
    start_ = t;
    y_start_ = y;
    has_slope_ = restarts_ = false;
    guards_.start_anew();
  }

  /// A state was set anew at `time`: the integration goes on from `state`.
  [[nodiscard]] bool restarts() const noexcept { return restarts_; }
  [[nodiscard]] Scalar time() const noexcept { return event_time_; }
  [[nodiscard]] const Vector& state() const noexcept { return event_state_; }
  /// How the system failed to settle a state after a reset or at the end of a step, if it did.
  [[nodiscard]] Evaluation failure() const noexcept { return failure_; }
  /// Evaluations of the model made here.
  [[nodiscard]] std::int64_t calls() const noexcept { return calls_; }

  /// Steps of a method with an interpolant, which leaves the invariants of the system by its error: where a guard may
  /// have an event, the states inside the step are settled.
  template <class Step>
  requires DenseOutput<Step, Scalar, size>
  bool operator()(const Step& step) {
    if constexpr (Settles<S, Scalar, size>) {
      const SettledStep<S, Step, Scalar, size> settled{system_, step, step.start, step.end};
      Vector y_end = step(step.end);
      CheckedSystem<S, Scalar, size> f(system_);
      if (!f.settle(step.end, y_end)) return fail(f.evaluation, step.start, settled(step.start));
      return (clear_but_for_settling(step, settled) || look_through(settled)) && shown(settled, step.end, y_end);
    } else {
      return look_through(step) && shown(step, step.end, step(step.end));
    }
  }

  /// Steps of a method without one: a cubic shows whether there may be an event, steps of the method locate it.
  bool operator()(const Scalar& t, const Vector& y) {
    const RepeatedStep<S, Method, Scalar, size> step{system_, method_, start_, t, y_start_, y, calls_};
    const bool go_on = (clear_by_cubic(t, y) || look_through(step)) && shown(step, t, y);
    start_ = t;
    y_start_ = y;
    return go_on;
  }

 private:
  using Guards = GuardFollower<Set, Scalar, size>;

  [[nodiscard]] bool by_stepping() const noexcept {
    bool coarse = false;
    if constexpr (requires { Method::coarse_inside; }) coarse = Method::coarse_inside;
    return coarse || set_.options.by_stepping;
  }

  template <class Step>
  bool look_through(const Step& step) {
    scale_ = std::max(std::abs(Scalar(step.start)), std::abs(Scalar(step.end)));
    for (Scalar from = step.start;;) {
      const auto followed = guards_.first(step, from);
      result_.status = followed.status;
      if (result_.status != EventStatus::reached_end) return end_at(from, followed.failed, step(from));
      const Departure<Scalar>& first = followed.departure;
      watch_grazing(step, first);
      if (!first.found || result_.status != EventStatus::reached_end) return result_.status == EventStatus::reached_end;
      from = deal_with(step, first.after);
      if (restarts_ || result_.status != EventStatus::reached_end) return false;
    }
  }

  // Where guards come near zero and go back, up to the first crossing of any.
  template <class Step>
  void watch_grazing(const Step& step, const Departure<Scalar>& first) {
    const Scalar end = first.found ? first.after : Scalar(step.end);
    for (std::size_t i = 0; i < count && result_.status == EventStatus::reached_end; ++i) {
      const Departure<Scalar>& departure = guards_.departure(i);
      if (departure.found || !(departure.nearest < Guards::infinite)) continue;
      GuardMemory<Scalar>& memory = guards_.memory(i);
      NearestPlace<Scalar, size>& nearest = nearest_[i];
      const bool near = departure.nearest <= Scalar(2) * memory.band && !comes_before(step, end, departure.nearest_time);
      const bool left = memory.side * guards_.value(i, step, end) > Scalar(2) * memory.band;
      if (memory.leaving) {
        memory.leaving = !left;
        continue;
      }
      if (near && (!memory.visiting || departure.nearest < nearest.value)) {
        memory.visiting = true;
        nearest = {departure.nearest, departure.nearest_time, step(departure.nearest_time)};
      }
      if (memory.visiting && left) {
        memory.visiting = false;
        ++result_.grazed[i];
        if (tell(Event<Scalar, size>{i, nearest.time, memory.side < Scalar(0), true, nearest.y})) {
          if (++events_ >= set_.options.event_limit) result_.status = EventStatus::too_many_events;
        }
        if (result_.status != EventStatus::reached_end) end_at(nearest.time, i, nearest.y);
      }
    }
  }

  // All crossings at the time of the first one, in the order of the guards. Gives the time from which to look on.
  template <class Step>
  Scalar deal_with(const Step& step, Scalar first) {
    Scalar time = first, look_from = first;
    bool barriers_only = true;
    std::size_t place = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Departure<Scalar>& departure = guards_.departure(i);
      due_[i] = departure.found && std::abs(departure.after - first) <= Guards::together(first);
      if (!due_[i]) continue;
      look_from = comes_before(step, look_from, departure.after) ? departure.after : look_from;
      barriers_only = barriers_only && set_.response(i) == Response::barrier;
      place = i;
    }
    const Departure<Scalar>& located = guards_.departure(place);
    // A state is kept on its side of a barrier, and put beyond any other guard.
    time = barriers_only ? located.before : look_from;
    Vector y = step(time);
    if (by_stepping()) {
      const Located<Scalar, size> located_there = locate_by_stepping(step, place, barriers_only, time);
      time = located_there.time;
      if (all_finite(located_there.y)) y = located_there.y;
      if (!located_there.crosses) {
        result_.status = EventStatus::guard_not_followed;
        end_at(time, place, y);
        return look_from;
      }
    }
    look_from = comes_before(step, look_from, time) ? time : look_from;
    for (std::size_t i = 0; i < count; ++i) {
      if (!due_[i]) continue;
      respond(i, time, y);
      if (result_.status != EventStatus::reached_end) {
        end_at(time, i, y);
        return look_from;
      }
    }
    if (restarts_) end_piece(step, time, y);
    return look_from;
  }

  void respond(std::size_t i, Scalar time, Vector& y) {
    GuardMemory<Scalar>& memory = guards_.memory(i);
    const bool rising = memory.side < Scalar(0);
    memory.side = -memory.side;
    memory.leaving = true;
    const Crossing crossing = set_.crossing(i);
    if (crossing != Crossing::either && (crossing == Crossing::rising) != rising) return;
    ++result_.fired[i];
    if (!restarts_) before_reset_ = y;
    if (!tell(Event<Scalar, size>{i, time, rising, false, y})) return;
    const Response response = set_.response(i);
    if (response == Response::note) {
      count_event(i, time);
      return;
    }
    const Vector before = y;
    const bool go_on = set_.reset(i, time, y);
    const Vector as_reset = y;
    CheckedSystem<S, Scalar, size> f(system_);
    const bool settled = f.settle(time, y);
    if (!settled || !all_finite(y)) {
      y = before;
      fail(settled ? Evaluation::not_finite : f.evaluation, time, y);
      return;
    }
    y = f.unwound(y, as_reset);
    if (!go_on) {
      result_.status = EventStatus::stopped_at_event;
      return;
    }
    restarts_ = true;
    count_event(i, time);
  }

  // Whatever is done at events, they must end.
  void count_event(std::size_t i, Scalar time) {
    if (accumulations_[i](time, static_cast<Scalar>(set_.options.accumulation), scale_)) {
      result_.status = EventStatus::accumulation;
      result_.accumulation_time = accumulations_[i].limit();
    } else if (++events_ >= set_.options.event_limit) {
      result_.status = EventStatus::too_many_events;
    }
  }

  // The interpolant is right to the method's error; the method's own step from the start of the step is righter.
  template <class Step>
  Located<Scalar, size> locate_by_stepping(const Step& step, std::size_t i, bool stay_before, Scalar time) {
    const Vector y_start = step(step.start), y_end = step(step.end);
    const RepeatedStep<S, Method, Scalar, size> repeated{system_, method_, step.start, step.end, y_start, y_end, calls_};
    if (guards_.departure(i).before == guards_.departure(i).after) return {time, repeated(time)};  // beyond zero from the start
    const Scalar side = guards_.memory(i).side;
    const auto guard = [&](Scalar t) { return side * set_.value(i, t, repeated(t)); };
    return locate_near(repeated, guard, time, stay_before);
  }

  bool tell(const Event<Scalar, size>& event) {
    if (notify(on_event_, event)) return true;
    result_.status = EventStatus::stopped_by_observer;
    return false;
  }

  bool end_at(Scalar time, std::size_t guard, const Vector& y) {
    result_.guard = guard;
    event_time_ = time;
    event_state_ = y;
    return false;
  }

  bool fail(Evaluation evaluation, Scalar time, const Vector& y) {
    failure_ = evaluation;
    result_.status = EventStatus::integration_failed;
    return end_at(time, result_.guard, y);
  }

  template <class Step>
  void end_piece(const Step& step, Scalar time, const Vector& y) {
    end_at(time, 0, y);
    if (!shown(step, time, before_reset_)) return;
    if constexpr (std::is_invocable_v<Observer&, const Scalar&, const Vector&>) {
      if (!notify(observer_, time, y)) result_.status = EventStatus::stopped_by_observer;
    }
  }

  template <class Step>
  bool shown(const Step& step, Scalar end, const Vector& y) {
    bool go_on = true;
    using Part = PartOfStep<Step, Scalar>;
    if constexpr (std::is_invocable_v<Observer&, const Scalar&, const Vector&>) {
      go_on = notify(observer_, end, y);
    } else if constexpr (std::is_invocable_v<Observer&, const Part&>) {
      go_on = notify(observer_, Part{step, step.start, end});
    }
    if (!go_on) {
      result_.status = EventStatus::stopped_by_observer;
      end_at(end, 0, y);
    }
    return go_on;
  }

  // The cubic through both ends leaves no doubt where a guard stays away from zero by more than its own curvature.
  bool clear_by_cubic(Scalar t, const Vector& y) {
    CheckedSystem<S, Scalar, size> f(system_);
    bool known = has_slope_ || f(start_, y_start_, slope_start_);
    Vector slope_end{};
    known = f(t, y, slope_end) && known;
    calls_ += f.calls;
    const HermiteStep<Scalar, size> cubic{start_, t, y_start_, y, slope_start_, slope_end};
    if (known) guards_.sample(cubic, start_);
    const bool clear = known && guards_.pass_if_clear({});
    slope_start_ = slope_end;
    has_slope_ = known;
    return clear;
  }

  // Spares most steps the settling of every sample: an interpolant is farthest off near the middle of the step.
  template <class Step, class Settled>
  bool clear_but_for_settling(const Step& step, const Settled& settled) {
    guards_.sample(step, step.start);
    const Scalar middle = step.start + (step.end - step.start) / Scalar(2);
    const Vector y = step(middle), y_settled = settled(middle);
    // All of one state in turn: what guards read of it may be dear.
    std::array<Scalar, count> moved{}, inside{};
    for (std::size_t i = 0; i < count; ++i) inside[i] = set_.value(i, middle, y);
    for (std::size_t i = 0; i < count; ++i) moved[i] = Scalar(16) * std::abs(set_.value(i, middle, y_settled) - inside[i]);
    return guards_.pass_if_clear(moved);
  }

  S& system_;
  const Method& method_;
  const Set& set_;
  OnEvent& on_event_;
  Observer& observer_;
  EventResultType& result_;
  Scalar start_ = Scalar(0), event_time_ = Scalar(0), scale_ = Scalar(0);
  Vector y_start_{}, slope_start_{}, event_state_{}, before_reset_{};
  bool has_slope_ = false, restarts_ = false;
  Evaluation failure_ = Evaluation::ok;
  std::int64_t calls_ = 0;
  long long events_ = 0;
  Guards guards_;
  std::array<NearestPlace<Scalar, size>, count> nearest_{};
  std::array<AccumulationWatch<Scalar>, count> accumulations_{};
  std::array<bool, count> due_{};
};

}  // namespace torsor::runtime
