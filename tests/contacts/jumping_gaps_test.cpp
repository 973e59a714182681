// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps given by formulas that jump, as that over a floor with a step: no law says what happens at the wall of the step,
// and what leaves a table over its edge falls.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/contacts/contact_exchange.hpp"

namespace jumping_gaps_test {
namespace {

using namespace simple_systems;

/// A particle of mass 1 over a floor of the height z(x): q = (x, z).
ByHand<2, 2, 1> over_floor(double e, const std::function<double(double)>& height, const std::function<double(double)>& slope) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [=](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << 0, -g;
            r.gap[0] = y[1] - height(y[0]);
            r.J << -slope(y[0]), 1;
            r.w << y[3] - slope(y[0]) * y[2];
            r.drift << 0;
          }};
}
/// Level but for a step at x = 1.
ByHand<2, 2, 1> over_step(double e, double step) {
  return over_floor(e, [step](double x) { return x < 1 ? 0 : step; }, [](double) { return 0; });
}

// Once the particle slid through the wall to the top of the step, with the status of a motion that has reached its end.
// At 1 m/s the step is reached after 1 - x.
TEST(JumpingGaps, EndAMotionThatSlidesOntoThem) {
  for (const double step : {0.5, 1e-6}) {
    for (const double tolerance : {1e-13, 1e-8}) {
      std::array<double, 4> y{0.9, 0, 1, 0};
      const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      const ContactResult result = integrate_contacts(over_step(0, step), y, 0, 0.3, method);
      EXPECT_EQ(result.status, ContactStatus::no_point) << step << ": " << describe(result.status);
      EXPECT_EQ(result.contact, 0);
      EXPECT_NEAR(result.time, 0.1, 1e-12);
      EXPECT_NEAR(y[0], 1, 1e-12);
      EXPECT_EQ(y[1], 0);
    }
  }
}

// A rough table from x = 0.9 to its edge at 1: 0.1 = t - f g t²/2. Two contacts of one body leave it together, and a
// third one that goes on touches on.
TEST(JumpingGaps, LetWhatLeavesAnEdgeFall) {
  for (const double f : {0.0, 0.3}) {
    for (const double tolerance : {1e-13, 1e-8}) {
      SCOPED_TRACE(testing::Message() << "f " << f << ", tolerance " << tolerance);
      const ContactRule rough{.tangents = 1, .friction = f};
      const ByHand<3, 3, 3> off_a_table{{rough, rough, ContactRule{.tangents = 0}}, [](double, const auto& y, auto& r) {
                                          r.M.setIdentity();
                                          r.F << 0, -g, -g;
                                          r.gap[0] = r.gap[1] = y[1] + (y[0] < 1 ? 0 : 0.5);
                                          r.gap[2] = y[2];
                                          r.J << 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1;
                                          r.w << y[4], y[3], y[4], y[3], y[5];
                                          r.drift.setZero();
                                        }};
      std::array<double, 6> y{0.9, 0, 0, 1, 0, 0};
      const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      std::vector<ContactEvent> told;
      std::vector<double> heights;
      const ContactResult result =
          integrate_contacts(off_a_table, y, 0, 0.6, method, {}, [&](const ContactEvent& event) {
            told.push_back(event);
            heights.push_back(event.state[1]);
            return true;
          });
      ASSERT_TRUE(result) << describe(result.status);
      ASSERT_EQ(told.size(), 3U);
      const double leaves = f > 0 ? (1 - std::sqrt(1 - 0.2 * f * g)) / (f * g) : 0.1, lands = leaves + std::sqrt(1 / g);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(told[k].kind, ContactEventKind::opens);
        EXPECT_EQ(told[k].contact, static_cast<int>(k));
        EXPECT_NEAR(told[k].time, leaves, 1e-13);
        EXPECT_NEAR(heights[k], 0, 1e-15);
      }
      EXPECT_EQ(told[2].kind, ContactEventKind::impact);
      EXPECT_NEAR(told[2].time, lands, 1e-12);
      EXPECT_EQ(result.events, 3);
      EXPECT_NEAR(y[1], -0.5, 1e-15);
      EXPECT_EQ(y[2], 0);
      const double speed = 1 - f * g * leaves;
      // Both contacts take the impulse together: w_T falls by f w_N.
      const double left = std::max(0.0, speed - f * std::sqrt(g));
      EXPECT_NEAR(told[2].energy_lost, (g + speed * speed - left * left) / 2, 1e-11);
    }
  }
}

// Steps towards an edge end within roundings of the time and of the way that was asked for: after a moment of a long way,
// and after a long time as well.
TEST(JumpingGaps, LetFallWhateverTheTimeOfTheEdge) {
  const auto edge = over_floor(0, [](double x) { return x < 0 ? 0 : -1e9; }, [](double) { return 0; });
  for (const double time : {1e-5, 1e-3, 1.0}) {
    for (const double end : {2 * time, 1.0, 100.0, 1000.0}) {
      if (end <= time) continue;
      std::array<double, 4> y{-time, 0, 1, 0};
      const ContactResult result = integrate_contacts(edge, y, 0, end);
      ASSERT_TRUE(result) << time << " " << end << ": " << describe(result.status);
      const double fall = end - time;
      EXPECT_NEAR(y[1], -g * fall * fall / 2, 1e-9 * (1 + g * fall * end)) << time << " " << end;
    }
  }
}

// The other edge of a gap that rises is a wall.
TEST(JumpingGaps, EndAMotionBackOntoAnEdge) {
  std::array<double, 4> y{1.1, -0.5, -1, 0};
  const ContactResult result = integrate_contacts(over_step(0, -0.5), y, 0, 0.3);
  EXPECT_EQ(result.status, ContactStatus::no_point);
  EXPECT_NEAR(result.time, 0.1, 1e-12);
}

constexpr double pawl_slope = 0.2, pawl_press = 100;

/// A pawl of mass 1 pressed against teeth that rise at its slope and end each 0.1 s.
ByHand<1, 1, 1> pawl() {
  return {{ContactRule{.tangents = 0}}, [](double t, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << -pawl_press;
            r.gap[0] = y[0] - pawl_slope * (t - 0.1 * std::floor(10 * t));
            r.J << 1;
            r.w << y[1] - pawl_slope;
            r.drift << 0;
          }};
}

// A pawl is driven over teeth of a ratchet, each 0.1 long and 0.02 high, at 1 m/s, pressed by its weight and a spring
// that is soft: it rises with the slope, leaves the tip upwards with its speed, and lands on the next slope.
TEST(JumpingGaps, LetAPawlFallOverTheTipsOfTeeth) {
  constexpr double slope = pawl_slope, press = pawl_press;
  std::array<double, 2> y{0, slope};
  std::vector<double> times;
  const ContactResult result =
      integrate_contacts(pawl(), y, 0, 0.35, DormandPrince853{}, {}, [&times](const ContactEvent& event) {
        times.push_back(event.time);
        return true;
      });
  ASSERT_TRUE(result) << describe(result.status);
  // 0.02 + slope t - press t²/2 = slope t
  const double flight = std::sqrt(0.04 / press);
  ASSERT_EQ(times.size(), 6U);
  for (std::size_t k = 0; k < 3; ++k) {
    const double tip = 0.1 * static_cast<double>(k + 1);
    EXPECT_NEAR(times[2 * k], tip, 1e-13);
    EXPECT_NEAR(times[2 * k + 1], tip + flight, 1e-13);
  }
  EXPECT_NEAR(y[0], slope * 0.05, 1e-14);
}

// A state may have room for more numbers: what stands there is not touched. Once it was read, beyond the end of an array.
TEST(JumpingGaps, LeaveTheRoomOfAStateAlone) {
  const auto system = pawl();
  const ContactMechanismOf mechanism(system);
  std::array<double, 64> y{0, pawl_slope};
  IgnoreSteps ignore;
  ContactRun<64, 1, DormandPrince853, IgnoreSteps> run(mechanism, y, {}, {}, ignore);
  ASSERT_TRUE(run.start(0) && run.advance(0.35)) << describe(run.result().status);
  EXPECT_EQ(run.result().events, 6);
  EXPECT_NEAR(y[0], pawl_slope * 0.05, 1e-13);
  for (std::size_t k = 2; k < y.size(); ++k) EXPECT_EQ(y[k], 0);
}

// Once the wall was struck as a floor is. Where the particle flies over the wall, nothing happens.
TEST(JumpingGaps, EndAMotionThatFliesIntoThem) {
  for (const double height : {0.2, 0.5, 0.55}) {
    std::array<double, 4> y{0.9, height, 1, 0};
    int told = 0;
    const ContactResult result = integrate_contacts(over_step(0.5, 0.5), y, 0, 0.1005, DormandPrince853{}, {},
                                                    [&told](const ContactEvent&) { return ++told > 0; });
    EXPECT_EQ(told, 0);
    if (height > 0.54) {  // it falls by 0.0495 m
      EXPECT_EQ(result.status, ContactStatus::reached_end);
      continue;
    }
    EXPECT_EQ(result.status, ContactStatus::no_point) << describe(result.status);
    EXPECT_NEAR(result.time, 0.1, 1e-12);
    EXPECT_NEAR(y[1], height - g * 0.1 * 0.1 / 2, 1e-12);
    EXPECT_NEAR(y[3], -g * 0.1, 1e-12);
  }
}

// A ramp into which the way is steep is no step: the particle bounces on it where it falls on it.
TEST(JumpingGaps, AreNoSteepGaps) {
  constexpr double steep = 1e4;
  const auto ramp = over_floor(0.5, [](double x) { return steep * (x - 1); }, [](double) { return steep; });
  std::array<double, 4> y{0.9, 0.2, 1, 0};
  const ContactResult result = integrate_contacts(ramp, y, 0, 0.12);
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_EQ(result.impacts, 1);
  // 0.2 - g t²/2 = steep (t - 0.1), to first order beside t = 0.1. Its normal velocity is reversed by half, M being 1.
  const double t = 0.1 + (0.2 - g * 0.005) / (steep + g * 0.1) - g / 2 * std::pow((0.2 - g * 0.005) / steep, 2) / steep;
  const double w = -g * t - steep, P = -1.5 * w / (1 + steep * steep);
  EXPECT_NEAR(y[2], 1 - steep * P, 1e-9);
  EXPECT_NEAR(y[0], 0.9 + t + (1 - steep * P) * (0.12 - t), 1e-12);
}

// An importer of FMI that integrates: its step is refused, whether the particle slides or flies into the wall.
TEST(JumpingGaps, AreRefusedToImporters) {
  const auto floor = over_step(0.5, 0.5);
  const ContactMechanismOf<ByHand<2, 2, 1>> mechanism(floor);
  for (const double height : {0.0, 0.2}) {
    ContactExchange unit(mechanism, {}, 1e-10);
    std::array<double, 4> y{0.9, height, 1, 0};
    ASSERT_TRUE(unit.start(0, y));
    const double fall = height > 0 ? g * 0.11 * 0.11 / 2 : 0;
    y = {1.01, height - fall, 1, height > 0 ? -g * 0.11 : 0};
    EXPECT_NE(unit.complete(0.11, y), Evaluation::ok);
    EXPECT_EQ(unit.result().status, ContactStatus::no_point);
  }
  // Deep below a floor without a step it has struck.
  const auto level = over_step(0.5, 0);
  const ContactMechanismOf<ByHand<2, 2, 1>> below(level);
  ContactExchange unit(below, {}, 1e-10);
  std::array<double, 4> y{0.9, 0.02, 1, 0};
  ASSERT_TRUE(unit.start(0, y));
  y = {1.01, 0.02 - g * 0.11 * 0.11 / 2, 1, -g * 0.11};
  EXPECT_EQ(unit.complete(0.11, y), Evaluation::ok);
  ASSERT_TRUE(unit.update(0.11, y));
  EXPECT_NEAR(y[3], 0.5 * g * 0.11, 1e-15);
}

}  // namespace
}  // namespace jumping_gaps_test
