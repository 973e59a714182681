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
      : system_(system), method_(method), set_(set), on_event_(on_event), observer_(observer), result_(result) {}

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
    for (Scalar from = step.start;;) {
      sample(step, from);
      Departure<Scalar> first{};
      for (std::size_t i = 0; i < count; ++i) {
        departures_[i] = follow(i, step, from);
        if (result_.status != EventStatus::reached_end) return end_at(from, i, step(from));
        if (departures_[i].found && (!first.found || earlier(step, departures_[i].after, first.after))) {
          first = departures_[i];
        }
      }
      watch_grazing(step, first);
      if (!first.found || result_.status != EventStatus::reached_end) return result_.status == EventStatus::reached_end;
      from = deal_with(step, first.after);
      if (restarts_ || result_.status != EventStatus::reached_end) return false;
    }
  }

  // The guards' values at the places of the part of the step from a time on.
  template <class Step>
  void sample(const Step& step, Scalar from) {
    for (std::size_t j = 0; j < Polynomial::samples; ++j) {
      const Scalar place = static_cast<Scalar>(Polynomial::places[j]);
      const Scalar t = j == 0 ? from : j == Polynomial::degree ? Scalar(step.end) : from + place * (step.end - from);
      const Vector y = step(t);
      for (std::size_t i = 0; i < count; ++i) values_[i][j] = set_.value(i, t, y);
    }
  }

  template <class Step>
  Departure<Scalar> follow(std::size_t i, const Step& step, Scalar from) {
    auto& memory = memory_[i];
    Departure<Scalar> none{false, true, from, from, infinite, from};
    Values values = values_[i];
    Scalar largest = Scalar(0);
    for (const Scalar& value : values) largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : infinite;
    if (!(largest < infinite)) {
      result_.status = EventStatus::guard_not_followed;
      return none;
    }
    if (memory.side != Scalar(0) && !memory.visiting && Polynomial(values).stays_above(memory.side, Scalar(0))) {
      memory.fresh = memory.leaving = false;
      return none;
    }
    Scalar band = memory.band;
    if (memory.fresh) {
      band = band_at(i, step, from);
      if (memory.side > Scalar(0) && values[0] < -band) {
        if (set_.from_above(i)) return {true, true, from, from, Scalar(0), from};
        result_.status = EventStatus::beyond_barrier;
        return none;
      }
      if (memory.side == Scalar(0) && std::abs(values[0]) > band) memory.side = values[0] > Scalar(0) ? 1 : -1;
    }
    const bool starts_near = memory.fresh && std::abs(values[0]) <= band;
    if (!starts_near && !memory.visiting) band = first_band(i, step, from);
    const auto scan = [&](Scalar side) {
      Values seen = values;
      for (Scalar& value : seen) value *= side;
      const auto guard = [&](Scalar t) { return side * set_.value(i, t, step(t)); };
      return first_departure<Scalar>(guard, {.start = from, .end = Scalar(step.end), .band = band, .values = seen});
    };
    if (memory.side == Scalar(0)) memory.side = side_of(scan, step);
    if (memory.side == Scalar(0)) return none;
    Departure<Scalar> departure = scan(memory.side);
    // Rounding differs along the step: what counts is that where the guard crosses or is nearest.
    for (int repeat = 0; repeat < 12; ++repeat) {
      const Scalar there = band_at(i, step, departure.found ? departure.after : departure.nearest_time);
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
  Scalar first_band(std::size_t i, const Step& step, Scalar from) const {
    const Scalar side = memory_[i].side;
    Values seen = values_[i];
    for (Scalar& value : seen) value *= side;
    const Polynomial polynomial(seen);
    const auto band = [&](Scalar place) { return band_at(i, step, from + place * (step.end - from)) / Scalar(4); };
    std::size_t nearest = 0;
    Scalar least = infinite;
    for (std::size_t j = 0; j < Polynomial::nodes; ++j) {
      nearest = std::abs(seen[j]) < std::abs(seen[nearest]) ? j : nearest;
      const Scalar turn = j > 0 ? minimum_between(polynomial, j - 1, j) : Scalar(0);
      if (turn > Scalar(0)) least = std::min(least, band(turn));
    }
    return std::min(least, band(static_cast<Scalar>(Polynomial::places[nearest])));
  }

  // What rounding may make of the guard at a time: of the state and the time, to first order, and of its own terms,
  // which shows in its answer to changes by a rounding.
  template <class Step>
  Scalar band_at(std::size_t i, const Step& step, Scalar t) const {
    const Scalar relative = std::sqrt(epsilon), one = Scalar(1);
    Vector y = step(t);
    const Vector y_start = step(step.start), y_end = step(step.end);
    const Scalar value = set_.value(i, t, y);
    Scalar terms = std::abs(set_.value(i, t * (one + relative), y) - value) / relative, noise = Scalar(0);
    for (std::size_t k = 0; k < size; ++k) {
      const Scalar kept = y[k], largest = std::max({std::abs(y_start[k]), std::abs(y_end[k]), std::abs(kept)});
      y[k] = kept + relative * largest;
      terms += std::abs(set_.value(i, t, y) - value) / relative;
      y[k] = kept * (one + Scalar(2) * epsilon);
      noise = std::max(noise, std::abs(set_.value(i, t, y) - value));
      y[k] = kept;
    }
    // How far the guard goes in a rounding of the time.
    const Scalar part = Scalar(1e-3) * (step.end - step.start);
    const Scalar aside = earlier(step, t + part, step.end) ? t + part : t - part;
    const Scalar rate = std::abs(set_.value(i, aside, step(aside)) - value) / std::abs(part);
    return static_cast<Scalar>(set_.options.touch) * std::max(epsilon * terms, noise) +
           Scalar(8) * epsilon * std::abs(t) * rate;
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
      const bool left = memory.side * set_.value(i, end, step(end)) > Scalar(2) * memory.band;
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
    const Scalar together = Scalar(4) * epsilon * std::abs(first);
    Scalar time = first, look_from = first;
    bool barriers_only = true;
    std::size_t place = 0;
    for (std::size_t i = 0; i < count; ++i) {
      due_[i] = departures_[i].found && std::abs(departures_[i].after - first) <= together;
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
      const Located located_there = locate_by_stepping(step, place, barriers_only, time);
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
    if (accumulations_[i](time, static_cast<Scalar>(set_.options.accumulation))) {
      result_.status = EventStatus::accumulation;
      result_.accumulation_time = accumulations_[i].limit();
    } else if (++events_ >= set_.options.event_limit) {
      result_.status = EventStatus::too_many_events;
    }
  }

  struct Located {
    Scalar time;
    Vector y;
    bool crosses = true;  ///< false where steps of the method do not cross near the time given: the interpolant is wrong there
  };

  // The interpolant is right to the method's error; the method's own step from the start of the step is righter.
  template <class Step>
  Located locate_by_stepping(const Step& step, std::size_t i, bool stay_before, Scalar time) {
    const Vector y_end = step(step.end);
    const RepeatedStep<S, Method, Scalar, size> repeated{system_,  method_, step.start, step.end,
                                                         y_start_, y_end,   calls_};
    if (departures_[i].before == departures_[i].after)
      return Located{time, repeated(time)};  // beyond zero from the start
    const Scalar side = memory_[i].side;
    const auto guard = [&](Scalar t) { return side * set_.value(i, t, repeated(t)); };
    const Scalar h = step.end - step.start;
    for (Scalar reach = Scalar(1e-8); reach < Scalar(5); reach *= Scalar(10)) {
      const auto inside = [&](Scalar t) {
        return earlier(step, t, step.start) ? Scalar(step.start) : earlier(step, step.end, t) ? Scalar(step.end) : t;
      };
      Bracket<Scalar> bracket{inside(time - reach * h), inside(time + reach * h), Scalar(0), Scalar(0)};
      bracket.value_before = guard(bracket.before);
      bracket.value_after = guard(bracket.after);
      if (!(bracket.value_before > Scalar(0) && bracket.value_after <= Scalar(0))) continue;
      narrow(bracket, guard);
      const Scalar found = stay_before ? bracket.before : bracket.after;
      return Located{found, repeated(found)};
    }
    return {time, repeated(time), false};
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
  Scalar start_ = Scalar(0), event_time_ = Scalar(0);
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
};

}  // namespace torsor::runtime
