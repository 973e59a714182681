// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose velocity changes at once, or faster than a step: nothing is carried along beyond the bound of its friction,
// whatever times the motion is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/contacts/told_motion.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"

namespace jumping_surfaces_test {
namespace {

using namespace told_motion;

constexpr double f = 0.3, a = f * g;

/// Of a surface at a place x and a time: its velocity along x, and the rate of that.
struct Belt {
  double velocity = 0, rate = 0;
};

/// A block of 1 kg on a belt: q = (x, z).
ByHand<2, 2, 1> block_on(const std::function<Belt(double t, double x)>& belt) {
  return {{ContactRule{.tangents = 1, .friction = f}}, [belt](double t, const auto& y, auto& r) {
            const Belt now = belt(t, y[0]);
            r.M.setIdentity();
            r.F << 0, -g;
            r.gap[0] = y[1];
            r.J << 0, 1, 1, 0;
            r.w << y[3], y[2] - now.velocity;
            r.drift << 0, -now.rate;
          }};
}

struct Told {
  ContactEventKind kind;
  double time;
};

/// The motion to the last of these times, each hit.
template <class S, std::size_t size>
std::vector<Told> move_through(const S& system, std::array<double, size>& y, const std::vector<double>& times) {
  std::vector<Told> told;
  const ContactMechanismOf<S> mechanism(system);
  const auto watch = [&](const ContactEvent& event) {
    told.push_back({event.kind, event.time});
    return true;
  };
  ContactRun<size, 1, DormandPrince853, const decltype(watch)> run(mechanism, y, precise, {}, watch);
  EXPECT_TRUE(run.start(0));
  for (const double time : times) EXPECT_TRUE(run.advance(time)) << describe(run.result().status) << ' ' << run.result().time;
  return told;
}

const std::vector<std::vector<double>> grids{{1}, {0.25, 0.5, 0.75, 1}, {0.3, 0.6, 0.9, 1}, {0.1, 0.2, 0.55, 0.8, 1}};

// A belt that starts at 0.5 s, at once or within some time: the block gets up to its speed by friction alone.
TEST(JumpingSurface, ThatStartsCarriesABlockAlongByItsFriction) {
  for (const double within : {0.0, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const auto starts = [within](double t, double) -> Belt {
      if (t < 0.5) return {};
      return t < 0.5 + within ? Belt{(t - 0.5) / within, 1 / within} : Belt{1, 0};
    };
    for (const auto& times : grids) {
      std::array<double, 4> y{};
      const auto told = move_through(block_on(starts), y, times);
      EXPECT_NEAR(y[0], 0.5 - 1 / (2 * a), 1e-9) << within << ' ' << times.size();
      EXPECT_NEAR(y[2], 1, 1e-13);
      ASSERT_EQ(told.size(), 2U);
      EXPECT_EQ(told[0].kind, ContactEventKind::slips);
      EXPECT_NEAR(told[0].time, 0.5, std::max(1e-9, 0.3 * within));
      EXPECT_EQ(told[1].kind, ContactEventKind::slip_ends);
      EXPECT_NEAR(told[1].time, 0.5 + 1 / a, 1e-9);
    }
  }
}

// A slip that passes zero by a jump goes on the other way: it has not ended.
TEST(JumpingSurface, ThatTurnsRoundTurnsASlipRound) {
  const auto turns = [](double t, double) -> Belt { return {t < 0.2 ? 1.0 : -1.0, 0}; };
  for (const std::vector<double>& times : {std::vector{0.5}, {0.1, 0.2, 0.3, 0.4, 0.5}, {0.15, 0.3, 0.5}}) {
    std::array<double, 4> y{};
    const auto told = move_through(block_on(turns), y, times);
    EXPECT_NEAR(y[2], -0.1 * a, 1e-11);
    EXPECT_NEAR(y[0], a * (0.02 + 0.06 - 0.045), 1e-11);
    EXPECT_TRUE(told.empty());
  }
}

// The end of a slip is located to a rounding of the time, in which it goes on to change: late on the clock that is no jump.
TEST(JumpingSurface, IsNotSeenWhereABlockComesToRestLate) {
  for (const double start : {1e4, 1e6, 1e7}) {
    std::array<double, 4> y{0, 0, 1, 0};
    const auto rests = [](double, double) { return Belt{}; };
    const auto result = integrate_contacts(block_on(rests), y, start, start + 1, DormandPrince853{}, {.event_limit = 100});
    EXPECT_TRUE(result) << describe(result.status) << ' ' << start;
    EXPECT_NEAR(y[0], 1 / (2 * a), 1e-8) << start;
    EXPECT_EQ(y[2], 0);
    EXPECT_EQ(result.events, 1);
  }
}

// A caller who sets the belt to another speed between two pieces of a motion.
TEST(JumpingSurface, ThatACallerSetsToAnotherSpeedDragsByFriction) {
  double speed = 0;
  const auto set = [&speed](double, double) { return Belt{speed, 0}; };
  const auto block = block_on(set);
  const ContactMechanismOf<ByHand<2, 2, 1>> mechanism(block);
  for (const double later : {1.0, -1.0, 1e-6}) {
    std::array<double, 4> y{};
    IgnoreSteps none;
    ContactRun<4, 1, DormandPrince853, IgnoreSteps> run(mechanism, y, precise, {}, none);
    speed = 0;
    ASSERT_TRUE(run.start(0) && run.advance(0.5));
    speed = later;
    ASSERT_TRUE(run.advance(1)) << describe(run.result().status);
    EXPECT_NEAR(y[0], 0.5 * later - std::copysign(later * later / (2 * a), later), 1e-12) << later;
    EXPECT_NEAR(y[2], later, 1e-14);
  }
}

// Steps of one length cannot be made shorter: what one leaves of a velocity that is held is taken away, as before.
TEST(JumpingSurface, IsNotSeenInStepsOfOneLength) {
  const auto rod = rod_on_its_foot();
  const std::array<double, 6> start{0, std::cos(0.2), 0.2, 0, 0, 0};
  auto exact = start;
  ASSERT_TRUE(integrate_contacts(rod, exact, 0, 0.4, precise));
  for (const double step : {0.1, 0.02}) {
    auto y = start;
    const auto result = integrate_contacts(rod, y, 0, 0.4, RungeKutta4{.step = step});
    EXPECT_TRUE(result) << describe(result.status) << ' ' << step;
    EXPECT_NEAR(y[2], exact[2], step * step * step * step);
  }
}

// Two conveyors in a row.
TEST(JumpingSurface, OfAnotherPlaceCarriesABlockAlongByItsFriction) {
  for (const double second : {2.0, 0.5}) {
    const auto row = [second](double, double x) -> Belt { return {x < 1 ? 1 : second, 0}; };
    for (const std::vector<double>& times : {std::vector{2.0}, {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2}, {0.3, 0.6, 0.9, 1.2, 2}}) {
      std::array<double, 4> y{0, 0, 1, 0};
      move_through(block_on(row), y, times);
      EXPECT_NEAR(y[0], 1 + second - std::copysign((second - 1) * (second - 1) / (2 * a), second - 1), 1e-9) << second;
      EXPECT_NEAR(y[2], second, 1e-13);
    }
  }
}

// Friction between two bodies, of a bound, one of which is moved.
TEST(JumpingSurface, OfAPartnerDragsByTheBoundOfDryFriction) {
  const ByHand<1, 1, 1> dragged{{ContactRule{.tangents = 1, .normal = false, .bound = 2}}, [](double t, const auto& y, auto& r) {
                                  r.M.setIdentity();
                                  r.F.setZero();
                                  r.J << 1;
                                  r.w << y[1] - (t < 0.5 ? 0 : 1);
                                  r.drift.setZero();
                                }};
  for (const auto& times : grids) {
    std::array<double, 2> y{};
    move_through(dragged, y, times);
    EXPECT_NEAR(y[0], 0.25, 1e-9);
    EXPECT_NEAR(y[1], 1, 1e-13);
  }
}

// A table that is pulled away below a ball within a millisecond, with the velocity of a smooth law: the ball falls freely.
TEST(JumpingSurface, ThatIsPulledAwayLeavesABallToFall) {
  constexpr double w = 1e-3;
  const ByHand<1, 1, 1> ball{{ContactRule{.tangents = 0}}, [](double t, const auto& y, auto& r) {
                               const double part = std::clamp((t - 0.5) / w, 0.0, 1.0);
                               const double way = t > 0.5 ? -(part * part * w / 2 + std::max(t - 0.5 - w, 0.0)) : 0;
                               r.M.setIdentity();
                               r.F << -g;
                               r.gap[0] = y[0] - way;
                               r.J << 1;
                               r.w << y[1] + part;
                               r.drift << (part > 0 && part < 1 ? 1 / w : 0);
                             }};
  for (const std::vector<double>& times : {std::vector{0.6}, {0.3, 0.6}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}) {
    std::array<double, 2> y{};
    const auto told = move_through(ball, y, times);
    EXPECT_NEAR(y[0], -g * 0.01 / 2, 1e-9) << times.size();
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].kind, ContactEventKind::opens);
  }
}

}  // namespace
}  // namespace jumping_surfaces_test
