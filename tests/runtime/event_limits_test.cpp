// SPDX-License-Identifier: GPL-3.0-or-later
// What ends an integration that would not end by itself, or that a reset has spoiled.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "runtime/integration/dormand_prince_54.hpp"
#include "runtime/integration/dormand_prince_853.hpp"
#include "runtime/integration/events.hpp"
#include "runtime/integration/gauss_collocation.hpp"
#include "runtime/integration/midpoint.hpp"
#include "runtime/integration/runge_kutta_4.hpp"
#include "runtime/integration/stoermer_verlet.hpp"

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

}  // namespace
}  // namespace event_limits_test
