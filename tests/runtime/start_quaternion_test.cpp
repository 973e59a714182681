// SPDX-License-Identifier: GPL-3.0-or-later
// What a motion starts from is an attitude, whatever norm its quaternion is given.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "generated/quadruped.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"
#include "torsor/runtime/steps/narrow_system.hpp"

namespace torsor::start_quaternion_test {
namespace {

using namespace runtime;
using Robot = quadruped::Mechanism<double>;
using State = StateVector<Robot>;

/// It tumbles as it falls: forces depend on the attitude.
State start(double norm) {
  State y = equations_of_motion<Robot>().initial();
  for (std::size_t i = coordinates_of<Robot>; i < y.size(); ++i) y[i] = 0.3;
  const std::array<double, 4> attitude{0.5, -0.5, 0.5, 0.5};
  for (std::size_t k = 0; k < 4; ++k) y[static_cast<std::size_t>(Robot::quaternions[0]) + k] = norm * attitude[k];
  return y;
}

template <class Method>
void expect_same_motion(const Method& method) {
  const auto motion = equations_of_motion<Robot>();
  State unit = start(1), other = start(2), seen{};
  const auto first = [&seen](double t, const State& y) {
    if (t == 0) seen = y;
  };
  ASSERT_TRUE(integrate(motion, unit, 0.0, 0.05, method));
  ASSERT_TRUE(integrate(motion, other, 0.0, 0.05, method, first));
  EXPECT_EQ(seen, start(1));  // all roundings are those of powers of two
  EXPECT_EQ(other, unit);
  other = start(4);
  const std::array<double, 2> times{0.02, 0.05};
  State through = start(1);
  ASSERT_TRUE(integrate_through(motion, through, 0.0, times, method, IgnoreSteps{}));
  ASSERT_TRUE(integrate_through(motion, other, 0.0, times, method, IgnoreSteps{}));
  EXPECT_EQ(other, through);
}

TEST(StartQuaternion, GivesTheMotionOfItsAttitude) {
  expect_same_motion(RungeKutta4{.step = 0.01});
  expect_same_motion(DormandPrince853{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9});
}

TEST(StartQuaternion, IsLeftAloneWhereItHasItsNorm) {
  State y = start(1);
  ASSERT_EQ(equations_of_motion<Robot>().settle_start(y), Evaluation::ok);
  EXPECT_EQ(y, start(1));
}

// Systems around equations of motion start as these do.
TEST(StartQuaternion, IsAnAttitudeOfAnglesWithinATurnToo) {
  const auto motion = angles_within_a_turn(equations_of_motion<Robot>(), std::array<std::size_t, 0>{});
  State unit = start(1), other = start(2), none = start(0);
  ASSERT_TRUE(integrate(motion, unit, 0.0, 0.05, RungeKutta4{.step = 0.01}));
  ASSERT_TRUE(integrate(motion, other, 0.0, 0.05, RungeKutta4{.step = 0.01}));
  EXPECT_EQ(other, unit);
  EXPECT_EQ(integrate(motion, none, 0.0, 0.05, RungeKutta4{.step = 0.01}).status, IntegrationStatus::model_failure);
}

TEST(StartQuaternion, IsAnAttitudeOfKernelsInFloatToo) {
  const auto motion = narrow_system<float>(equations_of_motion<quadruped::Mechanism<float>>());
  State unit = start(1), other = start(2), none = start(0);
  ASSERT_TRUE(integrate(motion, unit, 0.0, 0.05, RungeKutta4{.step = 0.01}));
  ASSERT_TRUE(integrate(motion, other, 0.0, 0.05, RungeKutta4{.step = 0.01}));
  EXPECT_EQ(other, unit);
  EXPECT_EQ(integrate(motion, none, 0.0, 0.05, RungeKutta4{.step = 0.01}).status, IntegrationStatus::model_failure);
  State with_digits = start(1);
  with_digits[0] = 1.0 + 0x1p-40;  // no float
  EXPECT_EQ(motion.settle_start(with_digits), Evaluation::ok);
  EXPECT_EQ(with_digits[0], 1.0 + 0x1p-40);
}

/// A start that is settled in float alone: to 1, or, from below zero, to nothing.
struct StartsAtOne {
  Evaluation operator()(float, const std::array<float, 2>&, std::array<float, 2>& rate) const noexcept {
    rate = {};
    return Evaluation::ok;
  }
  [[nodiscard]] Evaluation settle_start(std::array<float, 2>& y) const noexcept {
    if (y[0] < 0.0F) return Evaluation::singular;
    y[0] = 1.0F;
    return Evaluation::ok;
  }
};

TEST(StartQuaternion, IsSettledInFloatWhereItMust) {
  const auto motion = narrow_system<float>(StartsAtOne{});
  std::array<double, 2> y{1.25, 1.0 + 0x1p-40};
  ASSERT_TRUE(integrate(motion, y, 0, 1, RungeKutta4{.step = 0.5}));
  EXPECT_EQ(y, (std::array<double, 2>{1.0, 1.0 + 0x1p-40}));
  y[0] = -1.25;
  EXPECT_EQ(integrate(motion, y, 0, 1, RungeKutta4{.step = 0.5}).evaluation, Evaluation::singular);
}

TEST(StartQuaternion, OfZerosBeginsNothing) {
  const auto motion = equations_of_motion<Robot>();
  State y = start(0);
  const Result<double> result = integrate(motion, y, 0.5, 1.0, RungeKutta4{.step = 0.01});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::not_finite);
  EXPECT_EQ(result.time, 0.5);
  EXPECT_EQ(result.statistics.calls, 0);
  EXPECT_EQ(y, start(0));
}

TEST(StartQuaternion, IsAnAttitudeBeforeTheFirstEventToo) {
  const auto motion = equations_of_motion<Robot>();
  const Events events(note([](double t, const State&) { return 0.03 - t; }));
  State unit = start(1), other = start(2), none = start(0);
  const DormandPrince853 method{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9};
  ASSERT_TRUE(integrate_with_events(motion, unit, 0.0, 0.05, method, events));
  ASSERT_TRUE(integrate_with_events(motion, other, 0.0, 0.05, method, events));
  EXPECT_EQ(other, unit);
  EXPECT_EQ(integrate_with_events(motion, none, 0.0, 0.05, method, events).status, EventStatus::integration_failed);
}

}  // namespace
}  // namespace torsor::start_quaternion_test
