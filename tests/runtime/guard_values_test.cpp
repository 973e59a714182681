// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/events/guard_values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/events.hpp"

namespace guard_values_test {
namespace {

using namespace torsor::runtime;
using State = std::array<double, 2>;

constexpr auto clock_hand = [](double, const State&, State& dydt) noexcept {
  dydt = {1.0, 0.0};
  return Evaluation::ok;
};

/// The clock's hand from 0 to 1, which counts how often it is asked.
struct CountedStep {
  double start = 0, end = 1;
  int* asked;
  State operator()(double t) const {
    ++*asked;
    return {t, 2.0};
  }
};

constexpr auto line = [](double, const State& y) { return 3 * y[0] - y[1]; };
constexpr auto square = [](double, const State& y) { return y[0] * y[0]; };

TEST(GuardValues, ReadAStateOnceForAllThatAreWatched) {
  const auto set = Events(note(line), note(square));
  GuardValues<decltype(set), double, 2> values(set);
  values.watched = {true, true};
  int asked = 0;
  const CountedStep step{.asked = &asked};
  EXPECT_EQ(values.value(0, step, 0.25), 3 * 0.25 - 2);
  EXPECT_EQ(values.value(1, step, 0.25), 0.0625);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(values.value(0, step, 0.75), 3 * 0.75 - 2);
  EXPECT_EQ(values.value(1, step, 0.25), 0.0625);
  EXPECT_EQ(asked, 2);
  values.forget();
  EXPECT_EQ(values.value(0, step, 0.25), 3 * 0.25 - 2);
  EXPECT_EQ(asked, 3);
}

// More times than are kept.
TEST(GuardValues, AreThoseOfTheirTimes) {
  const auto set = Events(note(square));
  GuardValues<decltype(set), double, 2> values(set);
  values.watched = {true};
  int asked = 0;
  const CountedStep step{.asked = &asked};
  for (int repeat = 0; repeat < 2; ++repeat) {
    for (int k = 0; k <= 1000; ++k) {
      const double t = k / 1000.0;
      ASSERT_EQ(values.value(0, step, t), t * t) << t;
    }
  }
}

// 3 y0 - y1 at y = (0.25, 2), y0 up to 1 in the step: terms of 3 + 2 of the state, none of the time; it rises by 3 a second.
TEST(GuardValues, KnowTheRoundingOfEachGuard) {
  const auto set = Events(note(line), note(square));
  GuardValues<decltype(set), double, 2> values(set);
  values.watched = {true, true};
  int asked = 0;
  const CountedStep step{.asked = &asked};
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(values.rounding(0, step, 0.25), (64 * 5 + 8 * 0.25 * 3) * epsilon, 1e-6 * 64 * 5 * epsilon);
  const int read = asked;
  EXPECT_NEAR(values.rounding(1, step, 0.25), (64 * 0.5 + 8 * 0.25 * 0.5) * epsilon, 0.01 * 64 * 0.5 * epsilon);
  EXPECT_EQ(asked, read);
}

// A guard that cannot be followed beyond an event, where the motion does not come, spoils nothing.
TEST(Guards, AreFollowedUpToTheFirstEvent) {
  const auto root = note([](double, const State& y) { return std::sqrt(0.6 - y[0]) + 1; });  // no number beyond 0.6
  const auto end = stop_at([](double, const State& y) { return 0.3 - y[0]; });
  const DormandPrince54 method{.relative_tolerance = 1e3, .first_step = 1.0};
  for (const bool root_first : {true, false}) {
    State y{0.0, 0.0};
    const auto status = root_first ? integrate_with_events(clock_hand, y, 0, 1, method, Events(root, end)).status
                                   : integrate_with_events(clock_hand, y, 0, 1, method, Events(end, root)).status;
    EXPECT_EQ(status, EventStatus::stopped_at_event) << root_first;
    EXPECT_NEAR(y[0], 0.3, 1e-15);
  }
  State y{0.0, 0.0};
  EXPECT_EQ(integrate_with_events(clock_hand, y, 0, 1, method, Events(root)).status, EventStatus::guard_not_followed);
}

// What comes near zero before the first event in the same step has been there.
TEST(Guards, GrazeBeforeAnEventOfAnotherInTheSameStep) {
  const auto touching = note([](double, const State& y) { return (y[0] - 0.2) * (y[0] - 0.2); });
  const auto end = stop_at([](double, const State& y) { return 0.7 - y[0]; });
  State y{0.0, 0.0};
  const DormandPrince54 method{.relative_tolerance = 1e3, .first_step = 1.0};
  const auto result = integrate_with_events(clock_hand, y, 0, 1, method, Events(touching, end));
  EXPECT_EQ(result.status, EventStatus::stopped_at_event);
  EXPECT_EQ(result.grazed[0], 1);
}

// Two at once, or apart by a rounding of the time, and one later, which is declared first.
TEST(Guards, ThatPassZeroTogetherAreOneEvent) {
  const auto at = [](double place) {
    return [place](double, const State& y) { return place - y[0]; };
  };
  const auto near = at(0.4), later = at(0.4 * (1 + 1e-16)), after = at(0.5);
  State y{0.0, 0.0};
  const DormandPrince54 method{.relative_tolerance = 1e3, .first_step = 1.0};
  int told = 0;
  const auto on_event = [&](const Event<double, 2>& event) {
    EXPECT_NEAR(event.time, told < 2 ? 0.4 : 0.5, 1e-15);
    ++told;
  };
  ASSERT_TRUE(integrate_with_events(clock_hand, y, 0, 1, method, Events(note(after), note(later), note(near)), on_event));
  EXPECT_EQ(told, 3);
}

// Both lie between the same samples of the step, and the later one is declared first.
TEST(Guards, ComeInTheOrderOfTimeBetweenSamples) {
  const auto events = Events(note([](double, const State& y) { return 0.35 - y[0]; }),
                             note([](double, const State& y) { return 0.33 - y[0]; }));
  State y{0.0, 0.0};
  const DormandPrince54 method{.relative_tolerance = 1e3, .first_step = 1.0};
  std::vector<std::size_t> order;
  const auto on_event = [&](const Event<double, 2>& event) {
    order.push_back(event.guard);
    EXPECT_NEAR(event.time, event.guard == 0 ? 0.35 : 0.33, 1e-15);
  };
  ASSERT_TRUE(integrate_with_events(clock_hand, y, 0, 1, method, events, on_event));
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 0}));
}

// Both are dealt with, whatever the first one does, and whichever way their values are rounded.
TEST(Guards, AtTheSameTimeAsAResetAreNotLost) {
  const auto pass = [](double place, double factor) {
    return [=](double, const State& y) { return factor * (place - y[0]); };
  };
  const auto nothing = [](double, State&) {};
  const DormandPrince54 method{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9};
  for (int k = 1; k < 200; ++k) {
    const double place = 0.004 * k, factor = 0.01 * k;
    const auto guard = pass(place, 1), other = pass(place, factor);
    State y{0.0, 0.0};
    const auto first = reset_at(guard, Crossing::either, nothing), second = reset_at(other, Crossing::either, nothing);
    const auto noted = integrate_with_events(clock_hand, y, 0, 1, method, Events(first, note(other)));
    EXPECT_EQ(noted.fired[0], 1) << k;
    EXPECT_EQ(noted.fired[1], 1) << k;
    y = {0.0, 0.0};
    const auto stopped = integrate_with_events(clock_hand, y, 0, 1, method, Events(first, stop_at(other)));
    EXPECT_EQ(stopped.status, EventStatus::stopped_at_event) << k;
    y = {0.0, 0.0};
    const auto twice = integrate_with_events(clock_hand, y, 0, 1, method, Events(note(other), first, second));
    EXPECT_EQ(twice.fired[0] + twice.fired[1] + twice.fired[2], 3) << k;
  }
}

// As the force of a contact beside others that hold no changed state.
TEST(GuardValues, WithoutAValueBesideTheMotionAreFound) {
  const auto sinks = [](double, const State&, State& dydt) noexcept {
    dydt = {-1.0, 0.0};
    return Evaluation::ok;
  };
  State y{1.0, 0.25};
  const auto level = [](double, const State& s) { return s[1] == 0.25 ? s[0] : std::numeric_limits<double>::quiet_NaN(); };
  const DormandPrince54 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  const auto result = integrate_with_events(sinks, y, 0, 3, method, Events(stop_at(level, Crossing::falling)));
  EXPECT_EQ(result.status, EventStatus::stopped_at_event) << describe(result.status);
  EXPECT_NEAR(result.time, 1, 1e-14);
}

}  // namespace
}  // namespace guard_values_test
