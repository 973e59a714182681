// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "torsor/runtime/events/event_memory.hpp"
#include "torsor/runtime/events/guard.hpp"
#include "torsor/runtime/events/guard_values.hpp"
#include "torsor/runtime/events/located.hpp"
#include "torsor/runtime/events/step_scan.hpp"
#include "torsor/runtime/steps/step_polynomial.hpp"
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
      : system_(system), method_(method), set_(set), on_event_(on_event), observer_(observer), result_(result), along_(set) {}

  /// A smooth piece begins.
  void start(Scalar t, const Vector& y) noexcept {
    start_ = t;
    y_start_ = y;
    has_slope_ = restarts_ = false;
    for (std::size_t i = 0; i < count; ++i) {
      memory_[i].start_anew(set_.response(i) == Response::barrier || set_.from_above(i));
    }
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
      if (by_stepping()) y_start_ = settled(settled.start);
      Vector y_end = step(step.end);
      CheckedSystem<S, Scalar, size> f(system_);
      if (!f.settle(step.end, y_end)) return fail(f.evaluation, step.start, settled(step.start));
      return (clear_but_for_settling(step, settled) || look_through(settled)) && shown(settled, step.end, y_end);
    } else {
      if (by_stepping()) y_start_ = step(step.start);
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
  using Polynomial = StepPolynomial<Scalar>;
  using Values = typename Polynomial::Values;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();

  [[nodiscard]] bool by_stepping() const noexcept {
    bool coarse = false;
    if constexpr (requires { Method::coarse_inside; }) coarse = Method::coarse_inside;
    return coarse || set_.options.by_stepping;
  }

  template <class Step>
  bool look_through(const Step& step) {
    scale_ = std::max(std::abs(Scalar(step.start)), std::abs(Scalar(step.end)));
    for (Scalar from = step.start;;) {
      sample(step, from);
      along_.forget();
      for (std::size_t i = 0; i < count; ++i) along_.watched[i] = !is_clear(i);
      Departure<Scalar> first{};
      Scalar end = step.end;
      const std::size_t likely = likely_first();
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k == 0 ? likely : k <= likely ? k - 1 : k;
        const auto memory = memory_[i];
        departures_[i] = follow(i, step, from, end);
        if (end != step.end && undecided(i, step, end)) {
          memory_[i] = memory;
          sample_again(i, step, from, Scalar(step.end));
          departures_[i] = follow(i, step, from, Scalar(step.end));
        }
        if (result_.status != EventStatus::reached_end) return end_at(from, i, step(from));
        if (!departures_[i].found || (first.found && !earlier(step, departures_[i].after, first.after))) continue;
        first = departures_[i];
        end = sample_before(step, from, first.after);
      }
      watch_grazing(step, first);
      if (!first.found || result_.status != EventStatus::reached_end) return result_.status == EventStatus::reached_end;
      from = deal_with(step, first.after);
      if (restarts_ || result_.status != EventStatus::reached_end) return false;
    }
  }

  // All guards' values in the part of the step from a time on.
  template <class Step>
  void sample(const Step& step, Scalar from) {
    for (std::size_t j = 0; j < Polynomial::samples; ++j) {
      const Scalar t = Polynomial::time(j, from, Scalar(step.end));
      const Vector y = step(t);
      for (std::size_t i = 0; i < count; ++i) values_[i][j] = set_.value(i, t, y);
    }
  }

  // What comes after an event is not asked: other guards are followed up to it, and to what is due at the same time.
  template <class Step>
  Scalar sample_before(const Step& step, Scalar from, Scalar event) {
    const Scalar beyond = event + (step.end >= step.start ? Scalar(2) : -Scalar(2)) * together(event);
    const Scalar end = earlier(step, beyond, step.end) ? beyond : Scalar(step.end);
    for (std::size_t i = 0; i < count; ++i) {
      if (along_.watched[i]) sample_again(i, step, from, end);
    }
    return end;
  }

  template <class Step>
  void sample_again(std::size_t i, const Step& step, Scalar from, Scalar end) {
    for (std::size_t j = 0; j < Polynomial::samples; ++j) values_[i][j] = along_.value(i, step, Polynomial::time(j, from, end));
  }

  // Whether what a guard does about the time of another's event shows later only: it has not left the rounding of zero.
  template <class Step>
  [[nodiscard]] bool undecided(std::size_t i, const Step& step, Scalar end) {
    const auto& memory = memory_[i];
    return along_.watched[i] && !departures_[i].found && memory.side * along_.value(i, step, end) <= Scalar(2) * memory.band;
  }

  // Events that lie no further apart are one.
  static Scalar together(Scalar t) noexcept { return Scalar(4) * epsilon * std::abs(t); }

  // The guard whose samples are beyond zero first.
  [[nodiscard]] std::size_t likely_first() const noexcept {
    for (std::size_t j = 1; j < Polynomial::nodes; ++j) {
      for (std::size_t i = 0; i < count; ++i) {
        const Scalar side = memory_[i].side != Scalar(0) ? memory_[i].side : values_[i][0];
        if (along_.watched[i] && side * values_[i][j] < Scalar(0)) return i;
      }
    }
    return 0;
  }

  // Whether a guard stays on its side in the part of the step that was sampled.
  [[nodiscard]] bool is_clear(std::size_t i) const noexcept {
    const auto& memory = memory_[i];
    return all_finite(values_[i]) && memory.side != Scalar(0) && !memory.visiting &&
           Polynomial(values_[i]).stays_above(memory.side, Scalar(0));
  }

  template <class Step>
  Departure<Scalar> follow(std::size_t i, const Step& step, Scalar from, Scalar end) {
    auto& memory = memory_[i];
    Departure<Scalar> none{false, true, from, from, infinite, from};
    const Values values = values_[i];
    if (!along_.watched[i] || is_clear(i)) {
      memory.fresh = memory.leaving = false;
      return none;
    }
    if (!all_finite(values)) {
      result_.status = EventStatus::guard_not_followed;
      return none;
    }
    Scalar band = memory.band;
    if (memory.fresh) {
      band = along_.rounding(i, step, from);
      if (memory.side > Scalar(0) && values[0] < -band) {
        if (set_.from_above(i)) return {true, true, from, from, Scalar(0), from};
        result_.status = EventStatus::beyond_barrier;
        return none;
      }
      if (memory.side == Scalar(0) && std::abs(values[0]) > band) memory.side = values[0] > Scalar(0) ? 1 : -1;
      memory.leaving = memory.leaving && std::abs(values[0]) <= Scalar(2) * band;
    }
    const bool starts_near = memory.fresh && std::abs(values[0]) <= band;
    if (!starts_near && !memory.visiting) band = first_band(i, step, from, end);
    const auto scan = [&](Scalar side) {
      Values seen = values;
      for (Scalar& value : seen) value *= side;
      const auto guard = [&](Scalar t) { return side * along_.value(i, step, t); };
      return first_departure<Scalar>(guard, {.start = from, .end = end, .band = band, .values = seen});
    };
    if (memory.side == Scalar(0)) memory.side = side_of(scan, step);
    if (memory.side == Scalar(0)) return none;
    Departure<Scalar> departure = scan(memory.side);
    // Rounding differs along the step: what counts is that where the guard crosses or is nearest.
    for (int repeat = 0; repeat < 12; ++repeat) {
      const Scalar there = along_.rounding(i, step, departure.found ? departure.after : departure.nearest_time);
      const bool settled = departure.finite && (!departure.found || there <= Scalar(2) * band);
      band = std::max(band, there);
      if (settled) break;
      if (!departure.finite) band *= Scalar(16);
      departure = scan(memory.side);
    }
    memory.band = band;
    if (!departure.finite) result_.status = EventStatus::guard_not_followed;
    memory.fresh = false;
    if (departure.found) memory.visiting = false;
    return departure;
  }

  // Of a guard that starts at zero: the side on which it first leaves the band.
  template <class Scan, class Step>
  Scalar side_of(const Scan& scan, const Step& step) {
    const Departure<Scalar> down = scan(Scalar(1)), up = scan(Scalar(-1));
    if (!down.found && !up.found) return Scalar(0);
    if (!down.found || !up.found) return up.found ? Scalar(1) : Scalar(-1);
    return earlier(step, up.after, down.after) ? Scalar(1) : Scalar(-1);
  }

  // The least rounding at the places where a guard turns back, or at the node where it is nearest to zero.
  template <class Step>
  Scalar first_band(std::size_t i, const Step& step, Scalar from, Scalar end) {
    const Scalar side = memory_[i].side;
    Values seen = values_[i];
    for (Scalar& value : seen) value *= side;
    const Polynomial polynomial(seen);
    const auto band = [&](Scalar place) { return along_.rounding(i, step, from + place * (end - from)) / Scalar(4); };
    std::size_t nearest = 0;
    Scalar least = infinite;
    for (std::size_t j = 0; j < Polynomial::nodes; ++j) {
      nearest = std::abs(seen[j]) < std::abs(seen[nearest]) ? j : nearest;
      const Scalar turn = j > 0 ? minimum_between(polynomial, j - 1, j) : Scalar(0);
      if (turn > Scalar(0)) least = std::min(least, band(turn));
    }
    return std::min(least, band(static_cast<Scalar>(Polynomial::places[nearest])));
  }

  // Where guards come near zero and go back, up to the first crossing of any.
  template <class Step>
  void watch_grazing(const Step& step, const Departure<Scalar>& first) {
    const Scalar end = first.found ? first.after : Scalar(step.end);
    for (std::size_t i = 0; i < count && result_.status == EventStatus::reached_end; ++i) {
      const Departure<Scalar>& departure = departures_[i];
      if (departure.found || !(departure.nearest < infinite)) continue;
      auto& memory = memory_[i];
      const bool near = departure.nearest <= Scalar(2) * memory.band && !earlier(step, end, departure.nearest_time);
      const bool left = memory.side * along_.value(i, step, end) > Scalar(2) * memory.band;
      if (memory.leaving) {
        memory.leaving = !left;
        continue;
      }
      if (near && (!memory.visiting || departure.nearest < memory.nearest)) {
        memory.visiting = true;
        memory.nearest = departure.nearest;
        memory.nearest_time = departure.nearest_time;
        memory.nearest_state = step(departure.nearest_time);
      }
      if (memory.visiting && left) {
        memory.visiting = false;
        ++result_.grazed[i];
        if (tell(Event<Scalar, size>{i, memory.nearest_time, memory.side < Scalar(0), true, memory.nearest_state})) {
          if (++events_ >= set_.options.event_limit) result_.status = EventStatus::too_many_events;
        }
        if (result_.status != EventStatus::reached_end) end_at(memory.nearest_time, i, memory.nearest_state);
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
      due_[i] = departures_[i].found && std::abs(departures_[i].after - first) <= together(first);
      if (!due_[i]) continue;
      look_from = earlier(step, look_from, departures_[i].after) ? departures_[i].after : look_from;
      barriers_only = barriers_only && set_.response(i) == Response::barrier;
      place = i;
    }
    const Departure<Scalar>& located = departures_[place];
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
    look_from = earlier(step, look_from, time) ? time : look_from;
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
    auto& memory = memory_[i];
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
    const Vector y_end = step(step.end);
    const RepeatedStep<S, Method, Scalar, size> repeated{system_,  method_, step.start, step.end,
                                                         y_start_, y_end,   calls_};
    if (departures_[i].before == departures_[i].after) return {time, repeated(time)};  // beyond zero from the start
    const Scalar side = memory_[i].side;
    const auto guard = [&](Scalar t) { return side * set_.value(i, t, repeated(t)); };
    return locate_near(repeated, guard, time, stay_before);
  }

  template <class Step>
  static bool earlier(const Step& step, Scalar a, Scalar b) noexcept {
    return step.end >= step.start ? a < b : b < a;
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
    if (known) sample(cubic, start_);
    const bool clear = known && clear_by_curvature({});
    slope_start_ = slope_end;
    has_slope_ = known;
    return clear;
  }

  // Spares most steps the settling of every sample: an interpolant is farthest off near the middle of the step.
  template <class Step, class Settled>
  bool clear_but_for_settling(const Step& step, const Settled& settled) {
    sample(step, step.start);
    const Scalar middle = step.start + (step.end - step.start) / Scalar(2);
    const Vector y = step(middle), y_settled = settled(middle);
    std::array<Scalar, count> moved{};
    for (std::size_t i = 0; i < count; ++i) {
      moved[i] = Scalar(16) * std::abs(set_.value(i, middle, y_settled) - set_.value(i, middle, y));
    }
    return clear_by_curvature(moved);
  }

  // Every guard sampled stays on its side by more than its curvature and a doubt.
  [[nodiscard]] bool clear_by_curvature(const std::array<Scalar, count>& doubt) const noexcept {
    bool clear = true;
    for (std::size_t i = 0; clear && i < count; ++i) {
      const auto& memory = memory_[i];
      const Values& g = values_[i];
      Scalar curvature = Scalar(0);
      for (std::size_t j = 0; j < Polynomial::samples; ++j) {
        const Scalar chord = g[0] + static_cast<Scalar>(Polynomial::places[j]) * (g[Polynomial::degree] - g[0]);
        curvature = std::max(curvature, std::abs(g[j] - chord));
      }
      const Scalar room = curvature + doubt[i];
      clear = memory.side != Scalar(0) && !memory.fresh && !memory.visiting && std::isfinite(room) &&
              Polynomial(g).stays_above(memory.side, -room);
    }
    return clear;
  }

  static constexpr Scalar infinite = std::numeric_limits<Scalar>::infinity();
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
  std::array<EventMemory<Scalar, size>, count> memory_{};
  std::array<AccumulationWatch<Scalar>, count> accumulations_{};
  std::array<Values, count> values_{};
  std::array<Departure<Scalar>, count> departures_{};
  std::array<bool, count> due_{};
  GuardValues<Set, Scalar, size> along_;
};

}  // namespace torsor::runtime
