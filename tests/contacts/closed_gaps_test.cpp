// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of closed contacts are zero to rounding, however coarse the steps are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/contacts/simple_systems.hpp"

namespace closed_gaps_test {
namespace {

using namespace simple_systems;

constexpr double half = 0.5, inertia = half * half / 3;  // of a rod of 1 kg
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A rod whose lower end is on a smooth floor, its attitude a unit vector e = (c, s) as those of bodies in space are unit
/// quaternions: q = (height of its centre, c, s), v = (its rate, ω).
struct RodOnFloor : ByHand<3, 2, 1> {
  RodOnFloor()
      : ByHand{{ContactRule{.tangents = 0}}, [](double, const auto& y, auto& r) {
                 r.M << 1, 0, 0, inertia;
                 r.F << -g, 0;
                 r.gap[0] = y[0] - half * y[2];
                 r.J << 1, -half * y[1];
                 r.w << y[3] - half * y[1] * y[4];
                 r.drift << half * y[2] * y[4] * y[4];
               }} {}
  void coordinate_rates(double, const State& y, std::array<double, nq>& rates) const { rates = {y[3], -y[4] * y[2], y[4] * y[1]}; }
  void normalise(State& y) const {
    const double length = std::hypot(y[1], y[2]);
    y[1] /= length;
    y[2] /= length;
  }
};

// It falls over without a jump: to the floor from 30 degrees beside the vertical it takes some 0.5 s.
TEST(ClosedGaps, StayClosedWhereAnAttitudeLeavesItsUnitLength) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    SCOPED_TRACE(testing::Message() << "tolerance " << tolerance);
    const RodOnFloor rod;
    const double sine = std::sqrt(0.75);
    RodOnFloor::State y{half * sine, 0.5, sine, 0, 0};
    double widest = 0, longest = 0;
    const auto watch = [&](double, const RodOnFloor::State& at) {
      widest = std::max(widest, std::abs(at[0] - half * at[2]));
      longest = std::max(longest, std::abs(std::hypot(at[1], at[2]) - 1));
    };
    const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    const ContactResult result = integrate_contacts(rod, y, 0, 0.35, method, {}, watch);
    EXPECT_TRUE(result) << describe(result.status) << " at " << result.time;
    EXPECT_EQ(result.events, 0);
    EXPECT_LE(widest, 2 * epsilon);
    EXPECT_LE(longest, 2 * epsilon);
    const double energy = (y[3] * y[3] + inertia * y[4] * y[4]) / 2 + g * y[0];
    EXPECT_NEAR(energy, g * half * sine, 30 * tolerance);
  }
}

/// A bar of mass 1 on feet 1 m to either side, its inertia four times that of its mass there, seen while it is level but for
/// 1e-10: q = (z, turn). Where one foot falls by d the least change of places takes the other 0.6 d down.
ByHand<2, 2, 2> bar_on_feet() {
  return {{ContactRule{.tangents = 0, .restitution = 0.5}, ContactRule{.tangents = 0}}, [](double, const auto& y, auto& r) {
            r.M << 1, 0, 0, 4;
            r.F << -g, 0;
            r.gap = {y[0] - y[1], y[0] + y[1]};
            r.J << 1, -1, 1, 1;
            r.w << y[2] - y[3], y[2] + y[3];
            r.drift.setZero();
          }};
}

// The first foot strikes and opens; the second, 5e-11 m above the floor, takes part and rests. The first was left 3e-11 below.
TEST(ClosedGaps, OfOtherFeetDoNotSinkOneThatOpens) {
  for (const double above : {5e-11, 1e-12, -5e-11}) {
    const auto bar = bar_on_feet();
    std::array<double, 4> y{1e-3 + above / 2, above / 2, -1, 0};
    int impacts = 0;
    const auto watch = [&](const ContactEvent& event) {
      EXPECT_GE(event.state[0] - event.state[1], -1e-17) << above;
      EXPECT_GE(event.state[0] + event.state[1], -1e-17) << above;
      return ++impacts < 3;
    };
    (void)integrate_contacts(bar, y, 0, 0.01, DormandPrince853{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10}, {}, watch);
    EXPECT_GE(impacts, 1);
  }
}

/// Balls of radius 0.1 in a row without gravity, each coordinate from where it touches the next: the gaps are sums of lengths
/// that are zero but for their rounding, which no coordinate shows.
ByHand<3, 3, 2> touching_balls(double e) {
  const ContactRule smooth{.tangents = 0, .restitution = e};
  return {{smooth, smooth}, [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F.setZero();
            r.gap = {y[1] + 0.3 - (y[0] + 0.1) - 0.2, y[2] + 0.6 - (y[1] + 0.4) - 0.2};
            r.J << -1, 1, 0, 0, -1, 1;
            r.w << y[4] - y[3], y[5] - y[4];
            r.drift.setZero();
          }};
}

// Their gaps are 0 and -2.8e-17 or so at the start. What had left fell to zero again and again at one time, and was closed.
TEST(ClosedGaps, LetGoWhatPartsFromThem) {
  for (const double speed : {1.0, 1e-3, 1e-8}) {
    for (const double e : {0.5, 1.0}) {
      SCOPED_TRACE(testing::Message() << speed << " m/s, e " << e);
      std::array<double, 6> apart{0, 0, 0, -speed, 0, speed};
      const ContactResult parts = integrate_contacts(touching_balls(e), apart, 0, 0.5);
      EXPECT_TRUE(parts) << describe(parts.status);
      EXPECT_EQ(parts.events, 0);
      EXPECT_NEAR(apart[2], speed / 2, 4 * epsilon);
      // The first two strike at once; the third leaves meanwhile.
      std::array<double, 6> strikes{0, 0, 0, speed, 0, 3 * speed};
      const ContactResult result = integrate_contacts(touching_balls(e), strikes, 0, 0.5);
      EXPECT_TRUE(result) << describe(result.status);
      EXPECT_EQ(result.impacts, 1);
      EXPECT_NEAR(strikes[3], speed * (1 - e) / 2, 1e-15 * speed);
      EXPECT_NEAR(strikes[4], speed * (1 + e) / 2, 1e-15 * speed);
      EXPECT_EQ(strikes[5], 3 * speed);
    }
  }
}

/// A ball whose coordinate is zero where it lies on the table: the gap is rounded as its lengths are.
ByHand<1, 1, 1> ball_from_where_it_lies(double e, double radius, double table) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [=](double, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g;
            const double height = table + radius;
            r.gap[0] = height + y[0] - table - radius;
            r.J(0, 0) = 1;
            r.w(0) = y[1];
            r.drift(0) = 0;
          }};
}

// With e = 1/2 bounces from 1 m end at three times the first fall. Such a motion was once said to meet a jump of the gap.
TEST(ClosedGaps, OfLengthsThatCancelComeToRest) {
  const double fall = std::sqrt(2 / g);
  for (const double radius : {1e-3, 0.0123, 0.32, 0.7, 3.3, 1e3}) {
    for (const double table : {0.0, 0.1, -0.37, 12.3}) {
      SCOPED_TRACE(testing::Message() << "radius " << radius << ", table " << table);
      const auto ball = ball_from_where_it_lies(0.5, radius, table);
      std::array<double, 2> y{1, 0};
      double end = 0;
      const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
      const ContactResult result = integrate_contacts(ball, y, 0, 4 * fall, method, {}, [&](const ContactEvent& event) {
        if (event.kind == ContactEventKind::accumulation) end = event.time;
        return true;
      });
      ASSERT_TRUE(result) << describe(result.status) << " at " << result.time;
      const double rounding = epsilon * (std::abs(table) + radius + 1);
      EXPECT_NEAR(y[0], 0, 4 * rounding);
      EXPECT_EQ(y[1], 0);
      EXPECT_EQ(result.accumulations, 1);
      // A height that is off by ε moves an impact at the speed w by ε/w, and the end by what is left of such impacts.
      EXPECT_NEAR(end, 3 * fall, 1e-12 + 40 * std::sqrt(rounding / g) * 1e-3);
    }
  }
}

/// A ball on a lift that goes up at a constant speed, x from where it lies on it: the gap is the ball's height above the ground
/// less the floor's, which no coordinate shows.
ByHand<1, 1, 1> ball_on_lift(double e, double speed) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [speed](double t, const auto& y, auto& r) {
            const volatile double floor = speed * t, height = floor + y[0];
            r.M(0, 0) = 1;
            r.F(0) = -g;
            r.gap[0] = height - floor;
            r.J(0, 0) = 1;
            r.w(0) = y[1];
            r.drift(0) = 0;
          }};
}

// The rounding of the gap grows with the way. What was measured at the start, nothing, was taken for all of it, and the motion
// said to meet a jump.
TEST(ClosedGaps, OfPlacesThatMoveAwayComeToRest) {
  for (const double speed : {1e3, 1e5, 1e6}) {
    for (const double e : {0.0, 0.5}) {
      SCOPED_TRACE(testing::Message() << "speed " << speed << ", e " << e);
      std::array<double, 2> y{1, 0};
      const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
      const ContactResult result = integrate_contacts(ball_on_lift(e, speed), y, 0, 20, method);
      ASSERT_TRUE(result) << describe(result.status) << " at " << result.time;
      EXPECT_NEAR(y[0], 0, 64 * epsilon * speed * 20);
      EXPECT_EQ(y[1], 0);
      EXPECT_LE(result.events, 60);
    }
  }
}

}  // namespace
}  // namespace closed_gaps_test
