// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "benchmarks/work_precision/problem.hpp"
#include "torsor/runtime/status.hpp"

namespace work_precision {

/// s, later than all events.
inline constexpr double contact_end = 10.0;

/// Where a motion with contact was ended by its last event.
template <class Motion>
struct ContactEnd {
  double time = 0.0;
  typename Motion::State y{};
  bool reached = false;  ///< the last event
  int events = 0;
  torsor::runtime::Statistics statistics{};
};

// Each motion: its equations as a plain right-hand side and their Taylor coefficients, a guard that falls through zero
// at an event, `after` (what an event does to the state; false: it was the last), and the end in closed form.

/// A ball dropped from 1 m that keeps 0.8 of its speed at each impact, until the tenth; y = (height, velocity).
struct BouncingBall {
  using State = std::array<double, 2>;
  static constexpr double gravity = 9.81, restitution = 0.8;
  static constexpr int impacts = 10;
  static constexpr State start{1.0, 0.0};

  torsor::runtime::Evaluation operator()(double, const State& y, State& rate) const noexcept {
    rate = {y[1], -gravity};
    return torsor::runtime::Evaluation::ok;
  }
  torsor::runtime::Evaluation jets(double, const State& y, std::span<State> c) const noexcept {
    std::fill(c.begin(), c.end(), State{});
    c[0] = y;
    c[1] = {y[1], -gravity};
    if (c.size() > 2) c[2] = {-gravity / 2, 0.0};
    return torsor::runtime::Evaluation::ok;
  }
  static double guard(const State& y) noexcept { return y[0]; }
  static bool after(State& y, int events) noexcept {
    y[1] *= -restitution;
    return events < impacts;
  }
  /// Time of the tenth impact √(2 h/g) (1 + 2 Σ e^k), relative, and the speed after it, e^10 √(2 g h), relative; the
  /// energy as a part of m g h.
  static Outcome outcome(const ContactEnd<BouncingBall>& end) {
    const double time = 3.578892951020438280739116;
    const double speed = std::pow(restitution, impacts) * std::sqrt(2 * gravity);
    const double energy = end.y[1] * end.y[1] / 2 + gravity * end.y[0] - speed * speed / 2;
    return {end.reached, std::max(std::abs(end.time / time - 1), std::abs(std::abs(end.y[1]) / speed - 1)),
            std::abs(energy) / gravity, end.statistics};
  }
};

/// A billiard ball thrown at 2 m/s without spin on cloth of μ = 0.2, until it rolls; y = (x, v, ω).
struct SlidingBall {
  using State = std::array<double, 3>;
  static constexpr double gravity = 9.81, friction = 0.2, radius = 0.05, speed = 2.0;
  static constexpr State start{0.0, speed, 0.0};

  torsor::runtime::Evaluation operator()(double, const State& y, State& rate) const noexcept {
    rate = {y[1], -friction * gravity, 2.5 * friction * gravity / radius};
    return torsor::runtime::Evaluation::ok;
  }
  torsor::runtime::Evaluation jets(double t, const State& y, std::span<State> c) const noexcept {
    std::fill(c.begin(), c.end(), State{});
    c[0] = y;
    (void)(*this)(t, y, c[1]);
    if (c.size() > 2) c[2][0] = c[1][1] / 2;
    return torsor::runtime::Evaluation::ok;
  }
  static double guard(const State& y) noexcept { return y[1] - radius * y[2]; }
  static bool after(State&, int) noexcept { return false; }
  /// Time 2 v/(7 μ g), speed 5 v/7, spin and way 12 v²/(49 μ g), all relative; the energy lost is 2/7 of the first.
  static Outcome outcome(const ContactEnd<SlidingBall>& end) {
    const double time = 2 * speed / (7 * friction * gravity), rolling = 5.0 / 7.0 * speed;
    const double way = 12 * speed * speed / (49 * friction * gravity);
    const double energy = (end.y[1] * end.y[1] + 0.4 * radius * radius * end.y[2] * end.y[2]) / (speed * speed);
    return {end.reached,
            std::max({std::abs(end.time / time - 1), std::abs(end.y[1] / rolling - 1),
                      std::abs(end.y[2] * radius / rolling - 1), std::abs(end.y[0] / way - 1)}),
            std::abs(energy - 5.0 / 7.0), end.statistics};
  }
};

}  // namespace work_precision
