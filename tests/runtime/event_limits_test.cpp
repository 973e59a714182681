// SPDX-License-Identifier: GPL-3.0-or-later
// What ends an integration that would not end by itself, or that a reset has spoiled.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"

namespace event_limits_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 2>;

struct Fall {
  static constexpr bool second_order = true;
  Evaluation operator()(double, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -9.81};
    return Evaluation::ok;
  }
};

TEST(EventLimits, CountCrossingsThatAreOnlyNoted) {
  auto events = Events(note([](double t, const State&) { return std::sin(1e6 * t); }));
  events.options.event_limit = 10;
  State y{1, 0};
  const auto result = integrate_with_events(Fall{}, y, 0, 0.1, DormandPrince54{}, events);
  EXPECT_EQ(result.status, EventStatus::too_many_events);
  EXPECT_EQ(result.fired[0], 10);
  EXPECT_NEAR(y[0], 1 - 9.81 / 2 * result.time * result.time, 1e-15);
}

TEST(EventLimits, SeeNotedCrossingsThatAccumulate) {
  // θ = -π log2(1 - t): zeros of sin θ at 1 - 2^-k, which end at 1.
  constexpr double pi = 3.14159265358979324;
  const auto winding = [](double t, const std::array<double, 1>&, std::array<double, 1>& dydt) noexcept {
    dydt[0] = pi / std::log(2.0) / (1 - t);
    return Evaluation::ok;
  };
  auto events = Events(note([](double, const std::array<double, 1>& y) { return std::sin(y[0]); }));
  events.options.accumulation = 1e-6;
  std::array<double, 1> y{0.5};
  const auto result = integrate_with_events(winding, y, 0, 2, DormandPrince853{}, events);
  EXPECT_EQ(result.status, EventStatus::accumulation);
  EXPECT_NEAR(std::log2(1 - result.time), -20, 1);  // 2^-20 is the first below 1e-6
  // The places are right to the tolerance of 1e-9 of θ to 60, a share of what is left of the time.
  EXPECT_NEAR(result.accumulation_time, 1, 1e-6 * 1e-9 * 60 * 16);
}

TEST(EventLimits, KeepTheLastGoodStateWhenAResetWritesWhatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto floor = barrier([](double, const State& y) { return y[0]; }, [bad](double, State& y) { y[1] = bad; });
    State y{1, 0};
    const auto result = integrate_with_events(Fall{}, y, 0, 1, DormandPrince853{}, Events(floor));
    EXPECT_EQ(result.status, EventStatus::integration_failed);
    EXPECT_EQ(result.integration.status, IntegrationStatus::model_failure);
    EXPECT_EQ(result.integration.evaluation, Evaluation::not_finite);
    EXPECT_NEAR(result.time, std::sqrt(2 / 9.81), 1e-9);
    EXPECT_NEAR(y[0], 0, 1e-9);
    EXPECT_NEAR(y[1], -std::sqrt(2 * 9.81), 1e-8);
  }
}

template <class Method>
void expect_limited(Method method) {
  // 1e12 steps would take a day.
  State y{1, 0};
  const State before = y;
  method.step = 1e-12;
  EXPECT_EQ(integrate(Fall{}, y, 0, 1, method).status, IntegrationStatus::too_many_steps);
  EXPECT_EQ(y, before);
  method.step = 0.125;
  method.step_limit = 7;
  EXPECT_EQ(integrate(Fall{}, y, 0, 1, method).status, IntegrationStatus::too_many_steps);
  method.step_limit = 8;
  EXPECT_TRUE(integrate(Fall{}, y, 0, 1, method));
}
TEST(FixedStep, HasALimitOfSteps) {
  expect_limited(RungeKutta4{});
  expect_limited(Midpoint{});
  expect_limited(StoermerVerlet{});
  expect_limited(GaussCollocation<2>{});
}

// The bob of a clock: y' = 1, guards of y. Everything about them is known.
constexpr auto clock_hand = [](double, const State&, State& dydt) noexcept {
  dydt = {1.0, 0.0};
  return Evaluation::ok;
};

// 1 - cos y touches zero at every turn.
TEST(EventLimits, CountGrazingsAndTellTheirStates) {
  constexpr double turn = 6.283185307179586;
  auto events = Events(note([](double, const State& y) { return 1.0 - std::cos(y[0]); }));
  events.options.event_limit = 3;
  State y{1.0, 0.0};
  int told = 0;
  const auto on_event = [&](const Event<double, 2>& event) {
    EXPECT_TRUE(event.grazing);
    EXPECT_NEAR(event.time, ++told * turn - 1.0, 1e-7);  // a minimum is known to the root of rounding
    EXPECT_NEAR(event.state[0], event.time + 1.0, 1e-14 * turn * told);
  };
  const auto result =
      integrate_with_events(clock_hand, y, 0, 100, DormandPrince54{.largest_step = 1.0}, events, on_event);
  EXPECT_EQ(result.status, EventStatus::too_many_events);
  EXPECT_EQ(result.grazed[0], 3);
  EXPECT_EQ(told, 3);
}

// Twenty guards at once are no series of events of one of them.
TEST(EventLimits, KnowWhichGuardAnEventIsOf) {
  const auto half = note([](double, const State& y) { return y[0] - 0.5; });
  std::array<decltype(half), 20> guards{half, half, half, half, half, half, half, half, half, half,
                                        half, half, half, half, half, half, half, half, half, half};
  State y{0.0, 0.0};
  const auto result = integrate_with_events(clock_hand, y, 0, 1, DormandPrince54{}, EventArray(guards));
  EXPECT_EQ(result.status, EventStatus::reached_end);
  for (const auto fired : result.fired) EXPECT_EQ(fired, 1);
}

// Times 1 - 2^-k, and the same backwards.
TEST(AccumulationWatch, FindsTheEndInBothDirectionsOfTime) {
  for (const double direction : {1.0, -1.0}) {
    AccumulationWatch<double> watch;
    int k = 1;
    while (!watch(direction * (1.0 - std::ldexp(1.0, -k)), 1e-6) && k < 40) ++k;
    EXPECT_EQ(k, 20);  // 2^-20 is the first below 1e-6
    EXPECT_NEAR(watch.limit(), direction, 1e-15);
  }
}

// Bounces of e = 0.5 or 0.8 that end at t = 0, where a rounding of the time is nothing.
TEST(AccumulationWatch, FindsAnEndAtTimeZero) {
  for (const double e : {0.5, 0.8}) {
    const auto ball = [](double, const State& y, State& dydt) noexcept {
      dydt = {y[1], -9.81};
      return Evaluation::ok;
    };
    const auto floor = barrier([](double, const State& y) { return y[0]; }, [e](double, State& y) { y[1] *= -e; });
    const double lasts = std::sqrt(2 / 9.81) * (1 + 2 * e / (1 - e));
    State y{1.0, 0.0};
    const auto result = integrate_with_events(ball, y, -lasts, 1, DormandPrince54{}, Events(floor));
    EXPECT_EQ(result.status, EventStatus::accumulation) << e;
    EXPECT_NEAR(result.accumulation_time, 0, 1e-11) << e;
    EXPECT_LT(result.fired[0], 400) << e;
  }
}

// In one long step, whichever way time runs.
TEST(Guards, ComeInTheOrderOfTime) {
  const auto events = Events(note([](double, const State& y) { return y[0] - 0.3; }),
                             note([](double, const State& y) { return y[0] - 0.5; }));
  for (const bool backwards : {false, true}) {
    std::array<std::size_t, 2> order{9, 9};
    std::size_t told = 0;
    const auto on_event = [&](const Event<double, 2>& event) {
      if (told < 2) order[told++] = event.guard;
      EXPECT_NEAR(event.time, event.guard == 0 ? 0.3 : 0.5, 1e-15);
    };
    const double from = backwards ? 1.0 : 0.0;
    State y{from, 0.0};
    const DormandPrince54 method{.relative_tolerance = 1e3, .first_step = 1.0};
    ASSERT_TRUE(integrate_with_events(clock_hand, y, from, 1.0 - from, method, events, on_event));
    EXPECT_EQ(told, 2U);
    EXPECT_EQ(order, (backwards ? std::array<std::size_t, 2>{1, 0} : std::array<std::size_t, 2>{0, 1}));
  }
}

// What the result counts is what the system was asked, over all pieces and in the watch too.
TEST(Events, CountEveryEvaluation) {
  const auto floor = barrier([](double, const State& y) { return y[0]; }, [](double, State& y) { y[1] *= -0.8; });
  const auto expect = [&](const auto& method, auto events) {
    long asked = 0;
    const auto fall = [&asked](double, const State& y, State& dydt) noexcept {
      ++asked;
      dydt = {y[1], -9.81};
      return Evaluation::ok;
    };
    State y{1.0, 0.0};
    const auto result = integrate_with_events(fall, y, 0, 2, method, events);
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_GE(result.fired[0], 3);
    EXPECT_EQ(result.integration.statistics.calls, asked);
  };
  expect(DormandPrince54{}, Events(floor));
  expect(RungeKutta4{.step = 0.01}, Events(floor));
  auto by_stepping = Events(floor);
  by_stepping.options.by_stepping = true;
  expect(DormandPrince853{}, by_stepping);
}

}  // namespace
}  // namespace event_limits_test
