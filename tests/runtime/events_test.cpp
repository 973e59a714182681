// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/integration/events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"

namespace events_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 2>;
using One = std::array<double, 1>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double g = 9.81;

// Free fall (z, z'): every method here is exact for it, but for rounding.
const auto fall = [](double, const State& y, State& dydt) noexcept {
  dydt = {y[1], -g};
  return Evaluation::ok;
};
const auto height = [](double, const State& y) noexcept { return y[0]; };
auto restitution(double e) {
  return [e](double, State& y) noexcept { y[1] *= -e; };
}

const auto oscillator = [](double, const State& y, State& dydt) noexcept {
  dydt = {y[1], -y[0]};
  return Evaluation::ok;
};
constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

// A ball dropped from h = 1 onto a floor: closed forms, 25 digits.
struct Bouncing {
  double e, end, tenth, path;
};
constexpr Bouncing bouncing[] = {
    {0.5, 1.354570922957192713352433, 1.352807158734592202006922, 5.0 / 3.0},
    {0.8, 4.0637127688715781400573, 3.578892951020438280739116, 41.0 / 9.0},
    {0.9, 8.578949178728887184565411, 5.430218002585345622119992, 9.526315789473684},
};

template <class Method>
void expect_accumulation(const Method& method, const Bouncing& exact) {
  State y{1.0, 0.0};
  int impacts = 0;
  double tenth = 0.0, path = 0.0, lowest = 1.0;
  const auto on_event = [&](const Event<double, 2>& event) {
    if (++impacts == 10) tenth = event.time;
    // Down from the top that energy gives, and up again after the impact.
    const double drop = event.state[1] * event.state[1] / (2 * g);
    path += drop * (1 + exact.e * exact.e);
  };
  const auto result = integrate_with_events(fall, y, 0, 100, method, Events(barrier(height, restitution(exact.e))),
                                            on_event, [&](double, const State& s) { lowest = std::min(lowest, s[0]); });
  EXPECT_EQ(result.status, EventStatus::accumulation) << describe(result.status);
  EXPECT_EQ(result.guard, 0U);
  // A time is rounded, and the ball reflected up to a rounding of the time early, which the later bounces see as a part
  // of their start: n impacts move the end by n ulp(t) (1 + e)/(1 - e) at most, the tenth by the first ten of them.
  const double rounding = epsilon * exact.end;
  const double n = static_cast<double>(result.fired[0]);
  EXPECT_NEAR(result.accumulation_time, exact.end, n * rounding * (1 + exact.e) / (1 - exact.e));
  EXPECT_NEAR(tenth, exact.tenth, 10 * 10 * rounding);
  EXPECT_NEAR(path, exact.path, 1e-12);
  // Ended by the end of the resolution of time, not by a limit: Δ_n = Δ_0 e^n reaches a rounding within n = 36/-ln e.
  EXPECT_LT(n, 36.0 / -std::log(exact.e) + 40);
  EXPECT_GE(lowest, -1e-15);  // does not sink by more than it falls in a rounding of the time
  EXPECT_NEAR(y[1], 0.0, 1e-12);
}

TEST(BouncingBall, ComesToRestAtTheTimeOfItsClosedFormWithEveryMethod) {
  for (const Bouncing& exact : bouncing) {
    expect_accumulation(DormandPrince54{}, exact);
    expect_accumulation(RungeKutta4{.step = 0.05}, exact);
    expect_accumulation(Midpoint{.step = 0.07}, exact);
  }
}

TEST(BouncingBall, ThatDoesNotBounceRestsAtOnce) {
  State y{1.0, 0.0};
  const auto result = integrate_with_events(fall, y, 0, 10, precise, Events(barrier(height, restitution(0.0))));
  EXPECT_EQ(result.status, EventStatus::accumulation);
  // The ball stops within a rounding of the time of the floor, some 4 ε high, and falls the rest.
  EXPECT_NEAR(result.accumulation_time, std::sqrt(2 / g), 2 * std::sqrt(2 * 4 * epsilon / g));
  EXPECT_NEAR(y[0], 0.0, 1e-14);
}

TEST(BouncingBall, GoesOnAtRestWithTheEquationsOfRest) {
  State y{1.0, 0.0};
  const auto bounce = Events(barrier(height, restitution(0.5)));
  const auto result = integrate_with_events(fall, y, 0, 10, precise, bounce);
  ASSERT_EQ(result.status, EventStatus::accumulation);
  // Resting: z'' = 0 under gravity and N = m g, until N would pull.
  y = {0.0, 0.0};
  double reaction = 1.0;
  const auto rest = [&](double, const State& s, State& dydt) noexcept {
    reaction = g;
    dydt = {s[1], reaction - g};
    return Evaluation::ok;
  };
  const auto contact = Events(stop_at([&](double, const State&) { return reaction; }, Crossing::falling));
  const auto at_rest = integrate_with_events(rest, y, result.accumulation_time, 10, precise, contact);
  EXPECT_EQ(at_rest.status, EventStatus::reached_end);
  EXPECT_EQ(y, (State{0.0, 0.0}));
}

TEST(BouncingBall, MayBeDeclaredAtRestEarlier) {
  State y{1.0, 0.0};
  Events events(barrier(height, restitution(0.9)));
  events.options.accumulation = 1e-3;
  const auto result = integrate_with_events(fall, y, 0, 100, precise, events);
  EXPECT_EQ(result.status, EventStatus::accumulation);
  EXPECT_LT(result.fired[0], 120);  // 0.9^n of 8.6 s reaches 1e-3 s at n = 86
  EXPECT_NEAR(result.accumulation_time, bouncing[2].end, 1e-9);
}

// A ball thrown up to a ceiling at H = 1 with v0² = 2 g H (1 + excess).
template <class Method>
void expect_ceiling(const Method& method, double excess, bool impact, bool grazing) {
  const double v0 = std::sqrt(2 * g * (1 + excess));
  State y{0.0, v0};
  double touched = -1.0, before = 0.0, after = 0.0;
  const auto events = Events(barrier([](double, const State& s) noexcept { return 1.0 - s[0]; },
                                     [&](double, State& s) noexcept {
                                       before = s[1];
                                       after = s[1] *= -0.5;
                                     }),
                             stop_at(height, Crossing::falling));
  const auto result = integrate_with_events(fall, y, 0, 10, method, events, [&](const Event<double, 2>& event) {
    if (event.guard == 0) touched = event.time;
  });
  EXPECT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  EXPECT_EQ(result.guard, 1U);
  EXPECT_EQ(result.fired[0], impact ? 1 : 0);
  EXPECT_EQ(result.grazed[0], grazing ? 1 : 0);
  if (grazing) {
    EXPECT_NEAR(touched, 0.451523640985730904450811, 1e-13);
  }
  if (impact) {
    // v² = 2 g H excess, known to a rounding of H: 2 g ε/v.
    const double v = std::sqrt(v0 * v0 - 2 * g);
    EXPECT_NEAR(before, v, 16 * g * epsilon / v);
    EXPECT_EQ(after, -0.5 * before);
  } else {
    EXPECT_NEAR(result.time, 2 * v0 / g, 4 * epsilon);
    EXPECT_NEAR(y[1], -v0, 16 * epsilon * v0);
  }
}

TEST(Ceiling, IsTouchedWithoutAnImpactAndHitByALittleMore) {
  const auto expect_all = [](const auto& method) {
    expect_ceiling(method, 0.0, false, true);
    expect_ceiling(method, 1e-12, true, false);
    expect_ceiling(method, -1e-12, false, false);
  };
  // Steps that go far beyond the landing would give the height a rounding of hundreds of metres.
  expect_all(DormandPrince54{.largest_step = 0.2});
  expect_all(RungeKutta4{.step = 0.03});
  // The touch falls on the end of a step.
  expect_all(RungeKutta4{.step = 0.451523640985730904450811 / 16});
  expect_all(Midpoint{.step = 0.03});
}

// A billiard ball: v, ω, sliding velocity u = v - R ω; friction μ g against u until it is zero, then rolling.
struct Ball {
  static constexpr double mu = 0.2, R = 0.05;
  double friction = 0.0;  // acceleration of the centre
  Evaluation operator()(double, const std::array<double, 3>& y, std::array<double, 3>& dydt) const noexcept {
    // m a = F, (2/5) m R² ω' = -F R
    dydt = {y[1], friction, -2.5 * friction / R};
    return Evaluation::ok;
  }
};

template <class Method>
void expect_rolling(const Method& method, double v0, double spin0) {
  Ball ball{-Ball::mu * g};
  std::array<double, 3> y{0.0, v0, spin0};
  double t_roll = 0.0, distance = 0.0;
  const auto sliding = [](double, const std::array<double, 3>& s) noexcept { return s[1] - Ball::R * s[2]; };
  const auto events = Events(reset_at(sliding, Crossing::falling, [&](double t, std::array<double, 3>& s) noexcept {
    t_roll = t;
    distance = s[0];
    ball.friction = 0.0;
    s[2] = s[1] / Ball::R;
  }));
  const auto result = integrate_with_events(ball, y, 0, 2, method, events);
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(result.fired[0], 1);
  const double u0 = v0 - Ball::R * spin0;
  const double t = 2 * u0 / (7 * Ball::mu * g), v = 5 * v0 / 7 + 2 * Ball::R * spin0 / 7;
  EXPECT_NEAR(t_roll, t, 8 * epsilon);
  EXPECT_NEAR(y[1], v, 16 * epsilon * v0);
  EXPECT_NEAR(y[2], v / Ball::R, 16 * epsilon * v0 / Ball::R);
  EXPECT_NEAR(distance, v0 * t - Ball::mu * g * t * t / 2, 16 * epsilon);
  EXPECT_NEAR(y[0], distance + v * (2 - t_roll), 16 * epsilon);
}

TEST(BilliardBall, SlidesThenRolls) {
  expect_rolling(DormandPrince54{}, 2.0, 0.0);
  expect_rolling(RungeKutta4{.step = 0.05}, 2.0, 0.0);
  // Published digits of the case without spin.
  EXPECT_NEAR(2 * 2.0 / (7 * 0.2 * g), 0.2912479976700160186398719, 1e-15);
  EXPECT_NEAR(12 * 4.0 / (49 * 0.2 * g), 0.4992822817200274605254946, 1e-15);
}

TEST(BilliardBall, WithBackspinStopsDead) { expect_rolling(DormandPrince54{}, 2.0, -2.5 * 2.0 / Ball::R); }

TEST(Guards, AreAllFoundInOneLongStep) {
  // y' = 1, one step over ten; a guard with nine pairs of roots 1e-4 apart, and one with a double root.
  const auto clock = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  };
  const double omega = 2 * std::numbers::pi / 1.2, level = std::cos(omega * 5e-5);
  const auto pairs = [&](double, const One& y) { return std::cos(omega * (y[0] - 0.1)) - level; };
  const auto twice = [](double, const One& y) { return (y[0] - 3.3) * (y[0] - 3.3); };
  std::vector<double> found;
  double touched = 0.0;
  One y{0.0};
  const DormandPrince54 one_step{.relative_tolerance = 1e-3, .absolute_tolerance = 1e-3, .first_step = 10.0};
  const auto result = integrate_with_events(clock, y, 0, 10, one_step, Events(note(pairs), note(twice)),
                                            [&](const Event<double, 1>& event) {
                                              if (event.guard == 0) found.push_back(event.time);
                                              if (event.grazing) touched = event.time;
                                            });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(result.integration.statistics.accepted, 1);
  ASSERT_EQ(found.size(), 18U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double root = 0.1 + 1.2 * static_cast<double>(i / 2) + (i % 2 == 0 ? -5e-5 : 5e-5);
    // A rounding of the cosine, divided by its slope ω² 5e-5.
    EXPECT_NEAR(found[i], root, 16 * epsilon / (omega * omega * 5e-5));
  }
  EXPECT_EQ(result.grazed[1], 1);
  EXPECT_NEAR(touched, 3.3, 1e-7);
}

TEST(Guards, AreLocatedToTheNeighbouringNumber) {
  const auto clock = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  };
  const double root = std::numbers::pi;
  One y{0.0};
  const auto by_time = [&](double t, const One&) { return std::sin(t); };
  const auto result = integrate_with_events(clock, y, 1, 5, precise, Events(stop_at(by_time, Crossing::falling)));
  EXPECT_EQ(result.status, EventStatus::stopped_at_event);
  // π rounded down, at which the sine is still positive, and its neighbour.
  EXPECT_EQ(result.time, std::nextafter(root, 4.0));
}

TEST(Guards, MindTheDirectionOfCrossing) {
  const auto count_of = [](Crossing crossing) {
    State y{1.0, 0.0};  // cos t
    return integrate_with_events(oscillator, y, 0, 10, precise, Events(note(height, crossing))).fired[0];
  };
  EXPECT_EQ(count_of(Crossing::falling), 2);  // π/2, 5π/2
  EXPECT_EQ(count_of(Crossing::rising), 1);   // 3π/2
  EXPECT_EQ(count_of(Crossing::either), 3);
}

TEST(Guards, WorkBackwardsInTime) {
  State y{1.0, 0.0};
  const auto result = integrate_with_events(oscillator, y, 0, -10, precise, Events(stop_at(height, Crossing::rising)));
  EXPECT_EQ(result.status, EventStatus::stopped_at_event);
  EXPECT_NEAR(result.time, -1.5 * std::numbers::pi, 1e-11);  // tolerance × 10
}

TEST(Guards, AtZeroAtTheStartHaveNoEventUntilTheyHaveLeft) {
  State y{0.0, 1.0};  // sin t
  std::vector<double> times;
  const auto result = integrate_with_events(oscillator, y, 0, 4, precise, Events(note(height)),
                                            [&](const Event<double, 2>& event) { times.push_back(event.time); });
  ASSERT_TRUE(result);
  ASSERT_EQ(times.size(), 1U);
  EXPECT_NEAR(times[0], std::numbers::pi, 1e-11);
}

TEST(Guards, AtTheSameTimeAreDealtWithInTheirOrder) {
  // Two balls fall from the same height; the second guard sees the velocity that the first reset has left.
  using Two = std::array<double, 4>;
  const auto two = [](double, const Two& y, Two& dydt) noexcept {
    dydt = {y[1], -g, y[3], -g};
    return Evaluation::ok;
  };
  Two y{1.0, 0.0, 1.0, 0.0};
  std::vector<std::size_t> order;
  double seen = 0.0;
  const auto events = Events(barrier([](double, const Two& s) { return s[2]; }, [](double, Two& s) { s[3] *= -0.5; }),
                             barrier([](double, const Two& s) { return s[0]; },
                                     [&](double, Two& s) {
                                       seen = s[3];
                                       s[1] *= -0.5;
                                     }));
  const auto result = integrate_with_events(two, y, 0, 0.8, precise, events,
                                            [&](const Event<double, 4>& event) { order.push_back(event.guard); });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1}));
  EXPECT_GT(seen, 0.0);
  EXPECT_NEAR(y[0], y[2], 1e-15);
}

TEST(Guards, OfOneTypeMayBeMany) {
  const auto clock = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  };
  struct At {
    double time;
    double operator()(double, const One& y) const { return y[0] - time; }
  };
  std::array<Guard<At>, 40> guards;
  for (std::size_t i = 0; i < guards.size(); ++i) guards[i] = note(At{4.0 - 0.1 * static_cast<double>(i)});
  One y{0.0};
  double last = 0.0;
  bool sorted = true;
  const auto result =
      integrate_with_events(clock, y, 0, 5, precise, EventArray(guards), [&](const Event<double, 1>& event) {
        sorted = sorted && event.time > last;
        last = event.time;
      });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_TRUE(sorted);
  for (const auto fired : result.fired) EXPECT_EQ(fired, 1);
}

TEST(Guards, OnStepsOfTheMethodAreRighterThanOnTheInterpolant) {
  const DormandPrince54 method{.relative_tolerance = 1e-8, .absolute_tolerance = 1e-8};
  const auto error = [&](bool by_stepping) {
    State y{1.0, 0.0};
    Events events(stop_at(height, Crossing::falling));
    events.options.by_stepping = by_stepping;
    const auto result = integrate_with_events(oscillator, y, 0, 3, method, events);
    EXPECT_EQ(result.status, EventStatus::stopped_at_event);
    return std::abs(result.time - std::numbers::pi / 2);
  };
  EXPECT_LT(error(true), 2e-8);  // tolerance × 1.6 s
  EXPECT_LT(error(false), 2e-7);
  EXPECT_LT(error(true), error(false));
}

TEST(Guards, ThatOscillateFarFasterThanTheStepAreFollowedOrReported) {
  const auto clock = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  };
  One y{0.0};
  const DormandPrince54 one_step{.relative_tolerance = 1e-3, .absolute_tolerance = 1e-3, .first_step = 10.0};
  const auto fast = [](double t, const One&) { return std::sin(100 * t + 0.5); };
  const auto result = integrate_with_events(clock, y, 0, 10, one_step, Events(note(fast)));
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(result.fired[0], 318);  // 100 × 10 + 0.5 = 318.47 π
}

TEST(Guards, ThatAreNoNumberEndWithAStatus) {
  State y{1.0, 0.0};
  const auto bad = [](double, const State& s) { return std::sqrt(s[0]); };
  const auto result = integrate_with_events(fall, y, 0, 2, precise, Events(note(bad)));
  EXPECT_EQ(result.status, EventStatus::guard_not_followed);
  y = {std::numeric_limits<double>::quiet_NaN(), 0.0};
  const auto no_start = integrate_with_events(fall, y, 0, 2, precise, Events(note(height)));
  EXPECT_EQ(no_start.status, EventStatus::integration_failed);
  EXPECT_EQ(no_start.integration.status, IntegrationStatus::invalid_options);
}

TEST(Guards, BeyondABarrierAtTheStartAreReported) {
  State y{-0.1, 0.0};
  const auto result = integrate_with_events(fall, y, 0, 2, precise, Events(barrier(height, restitution(0.5))));
  EXPECT_EQ(result.status, EventStatus::beyond_barrier);
  EXPECT_EQ(result.time, 0.0);
}

TEST(Guards, StopWhereTheObserverOrAResetSaysSo) {
  State y{1.0, 0.0};
  const auto stopped = integrate_with_events(fall, y, 0, 2, precise, Events(note(height)),
                                             [](const Event<double, 2>&) { return false; });
  EXPECT_EQ(stopped.status, EventStatus::stopped_by_observer);
  EXPECT_NEAR(stopped.time, std::sqrt(2 / g), 4 * epsilon);
  y = {1.0, 0.0};
  const auto by_reset =
      integrate_with_events(fall, y, 0, 2, precise, Events(barrier(height, [](double, State&) { return false; })));
  EXPECT_EQ(by_reset.status, EventStatus::stopped_at_event);
}

TEST(Guards, LoseNoRootOfRandomPolynomials) {
  const auto clock = [](double, const One&, One& dydt) noexcept {
    dydt[0] = 1.0;
    return Evaluation::ok;
  };
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> place(0.1, 9.9), exponent(-5.0, -1.0);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> roots;
    while (roots.size() < 5) {  // two pairs as near as 1e-5, and one alone
      const double root = place(random), pair = root + std::pow(10.0, exponent(random));
      roots.push_back(root);
      if (roots.size() < 5) roots.push_back(pair);
    }
    std::sort(roots.begin(), roots.end());
    const auto product = [&](double, const One& y) {
      double value = 1.0;
      for (const double root : roots) value *= y[0] - root;
      return value;
    };
    std::vector<double> found;
    One y{0.0};
    const DormandPrince54 steps{.relative_tolerance = 1e-3, .first_step = 7.0};
    const auto result = integrate_with_events(clock, y, 0, 10.5, steps, Events(note(product)),
                                              [&](const Event<double, 1>& event) { found.push_back(event.time); });
    ASSERT_TRUE(result) << describe(result.status);
    ASSERT_EQ(found.size(), roots.size()) << trial;
    for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found[i], roots[i], 8 * epsilon * roots[i]) << trial;
  }
}

TEST(Barriers, KeepManyBallsInABoxForEver) {
  // Six balls in a box of width 1 without gravity, reflected: positions fold back, |v| stays.
  constexpr std::size_t n = 6;
  using Balls = std::array<double, 2 * n>;
  const auto free = [](double, const Balls& y, Balls& dydt) noexcept {
    for (std::size_t i = 0; i < n; ++i) dydt[i] = y[n + i], dydt[n + i] = 0.0;
    return Evaluation::ok;
  };
  struct Wall {
    std::size_t ball;
    bool upper;
    double operator()(double, const Balls& y) const { return upper ? 1 - y[ball] : y[ball]; }
  };
  struct Reflect {
    std::size_t ball;
    void operator()(double, Balls& y) const { y[n + ball] = -y[n + ball]; }
  };
  std::array<Guard<Wall, Reflect>, 2 * n> walls;
  Balls y{};
  for (std::size_t i = 0; i < n; ++i) {
    walls[2 * i] = barrier(Wall{i, false}, Reflect{i});
    walls[2 * i + 1] = barrier(Wall{i, true}, Reflect{i});
    y[i] = 0.1 + 0.13 * static_cast<double>(i);
    y[n + i] = i < 2 ? 0.7 : 0.3 + 0.21 * static_cast<double>(i);
  }
  const Balls start = y;
  const auto result = integrate_with_events(free, y, 0, 100, precise, EventArray(walls));
  ASSERT_TRUE(result) << describe(result.status);
  for (std::size_t i = 0; i < n; ++i) {
    const double unfolded = start[i] + 100 * start[n + i], turns = std::floor(unfolded);
    const double folded = std::fmod(turns, 2.0) == 0.0 ? unfolded - turns : 1 - (unfolded - turns);
    EXPECT_NEAR(y[i], folded, 1000 * epsilon * 100);  // a thousand steps and resets
    EXPECT_EQ(result.fired[2 * i] + result.fired[2 * i + 1], static_cast<std::int64_t>(turns));
  }
}

TEST(Events, ShowStepsCutAtResetsToObservers) {
  std::vector<double> times, heights;
  const auto record = [&](double t, const State& s) {
    times.push_back(t);
    heights.push_back(s[0]);
  };
  EquallySpaced observer(0.0, 0.1, record);
  const auto see = [&](const auto& step) -> bool requires requires { step.start; }
  { return observer(step); };
  State y{1.0, 0.0};
  const auto result = integrate_with_events(fall, y, 0, 1, DormandPrince54{}, Events(barrier(height, restitution(0.8))),
                                            IgnoreSteps{}, see);
  ASSERT_TRUE(result) << describe(result.status);
  ASSERT_EQ(times.size(), 11U);
  const double t1 = std::sqrt(2 / g), v1 = 0.8 * g * t1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i];
    const double z = t < t1 ? 1 - g * t * t / 2 : v1 * (t - t1) - g * (t - t1) * (t - t1) / 2;
    EXPECT_NEAR(heights[i], z, 1e-13);  // roundings of steps over metres
  }
}

}  // namespace
}  // namespace events_test
