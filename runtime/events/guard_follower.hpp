// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/events/event_memory.hpp"
#include "torsor/runtime/events/guard.hpp"
#include "torsor/runtime/events/guard_values.hpp"
#include "torsor/runtime/events/step_scan.hpp"
#include "torsor/runtime/steps/step_polynomial.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Which of two times comes first along a step.
template <class Step, class Scalar>
[[nodiscard]] bool comes_before(const Step& step, Scalar a, Scalar b) noexcept {
  return step.end >= step.start ? a < b : b < a;
}

/// Follows the guards of a set through a step to the first that goes beyond zero.
template <class Set, class Scalar, std::size_t size>
class GuardFollower {
 public:
  static constexpr std::size_t count = Set::count;
  static constexpr Scalar infinite = std::numeric_limits<Scalar>::infinity();

  explicit GuardFollower(const Set& set) noexcept : set_(set), along_(set) {}

  /// A smooth piece begins.
  void start_anew() noexcept {
    for (std::size_t i = 0; i < count; ++i) memory_[i].start_anew(set_.response(i) == Response::barrier || set_.from_above(i));
  }

  [[nodiscard]] GuardMemory<Scalar>& memory(std::size_t i) noexcept { return memory_[i]; }
  /// What a guard does up to the end of the first departure.
  [[nodiscard]] const Departure<Scalar>& departure(std::size_t i) const noexcept { return departures_[i]; }
  template <class Step>
  [[nodiscard]] Scalar value(std::size_t i, const Step& step, Scalar t) {
    return along_.value(i, step, t);
  }

  /// Reads all guards in the part of a step from a time on.
  template <class Step>
  void sample(const Step& step, Scalar from) {
    for (std::size_t j = 0; j < Polynomial::samples; ++j) {
      const Scalar t = Polynomial::time(j, from, Scalar(step.end));
      const auto y = step(t);
      for (std::size_t i = 0; i < count; ++i) values_[i][j] = set_.value(i, t, y);
    }
  }

  /// Passes what was read last if every guard stays on its side by more than its curvature and a doubt: nothing is left to follow.
  [[nodiscard]] bool pass_if_clear(const std::array<Scalar, count>& doubt) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
      const Values& g = values_[i];
      Scalar curvature = Scalar(0);
      for (std::size_t j = 0; j < Polynomial::samples; ++j) {
        const Scalar chord = g[0] + static_cast<Scalar>(Polynomial::places[j]) * (g[Polynomial::degree] - g[0]);
        curvature = std::max(curvature, std::abs(g[j] - chord));
      }
      const Scalar room = curvature + doubt[i];
      const Scalar side = memory_[i].side;
      const bool clear = side != Scalar(0) && !memory_[i].visiting && std::isfinite(room) &&
                         Polynomial(g).stays_above(side, -room);
      if (!clear) return false;
    }
    for (GuardMemory<Scalar>& memory : memory_) memory.fresh = memory.leaving = false;
    return true;
  }

  /// The first departure in the part of a step from a time on, if any is found. Not reached_end: guard `failed` cannot be
  /// followed, or lies beyond its barrier.
  struct First {
    EventStatus status = EventStatus::reached_end;
    std::size_t failed = 0;
    Departure<Scalar> departure{};
  };
  template <class Step>
  [[nodiscard]] First first(const Step& step, Scalar from) {
    sample(step, from);
    along_.forget();
    for (std::size_t i = 0; i < count; ++i) along_.watched[i] = !is_clear(i);
    First first;
    Scalar end = step.end;
    const std::size_t likely = likely_first();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = k == 0 ? likely : k <= likely ? k - 1 : k;
      const GuardMemory<Scalar> memory = memory_[i];
      first.status = follow(i, step, from, end);
      if (end != step.end && undecided(i, step, end)) {
        memory_[i] = memory;
        sample_again(i, step, from, Scalar(step.end));
        first.status = follow(i, step, from, Scalar(step.end));
      }
      if (first.status != EventStatus::reached_end) {
        first.failed = i;
        return first;
      }
      const Departure<Scalar>& departure = departures_[i];
      if (!departure.found || (first.departure.found && !comes_before(step, departure.after, first.departure.after))) continue;
      first.departure = departure;
      end = sample_before(step, from, departure.after);
    }
    return first;
  }

  /// Events that lie no further apart are one.
  [[nodiscard]] static Scalar together(Scalar t) noexcept { return Scalar(4) * epsilon * std::abs(t); }

 private:
  using Polynomial = StepPolynomial<Scalar>;
  using Values = typename Polynomial::Values;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();

  // What comes after an event is not asked: other guards are followed up to it, and to what is due at the same time.
  template <class Step>
  Scalar sample_before(const Step& step, Scalar from, Scalar event) {
    const Scalar beyond = event + (step.end >= step.start ? Scalar(2) : -Scalar(2)) * together(event);
    const Scalar end = comes_before(step, beyond, Scalar(step.end)) ? beyond : Scalar(step.end);
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

  // Sets the guard's departure.
  template <class Step>
  EventStatus follow(std::size_t i, const Step& step, Scalar from, Scalar end) {
    auto& memory = memory_[i];
    Departure<Scalar>& departure = departures_[i];
    departure = {false, true, from, from, infinite, from};
    const Values values = values_[i];
    if (!along_.watched[i] || is_clear(i)) {
      memory.fresh = memory.leaving = false;
      return EventStatus::reached_end;
    }
    if (!all_finite(values)) return EventStatus::guard_not_followed;
    Scalar band = memory.band;
    if (memory.fresh) {
      band = along_.rounding(i, step, from);
      if (memory.side > Scalar(0) && values[0] < -band) {
        if (!set_.from_above(i)) return EventStatus::beyond_barrier;
        departure = {true, true, from, from, Scalar(0), from};
        return EventStatus::reached_end;
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
    if (memory.side == Scalar(0)) return EventStatus::reached_end;
    departure = scan(memory.side);
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
    memory.fresh = false;
    if (departure.found) memory.visiting = false;
    return departure.finite && std::isfinite(band) ? EventStatus::reached_end : EventStatus::guard_not_followed;
  }

  // Of a guard that starts at zero: the side on which it first leaves the band.
  template <class Scan, class Step>
  Scalar side_of(const Scan& scan, const Step& step) {
    const Departure<Scalar> down = scan(Scalar(1)), up = scan(Scalar(-1));
    if (!down.found && !up.found) return Scalar(0);
    if (!down.found || !up.found) return up.found ? Scalar(1) : Scalar(-1);
    return comes_before(step, up.after, down.after) ? Scalar(1) : Scalar(-1);
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

  const Set& set_;
  std::array<GuardMemory<Scalar>, count> memory_{};
  std::array<Values, count> values_{};
  std::array<Departure<Scalar>, count> departures_{};
  GuardValues<Set, Scalar, size> along_;
};

}  // namespace torsor::runtime
