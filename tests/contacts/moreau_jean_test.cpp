// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/contacts/moreau_jean.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include "tests/contacts/simple_systems.hpp"

namespace moreau_jean_test {
namespace {

using namespace simple_systems;

// The largest error of coordinates and velocities at the end, with so many steps.
template <class S, std::size_t size>
double error_after(const S& system, std::array<double, size> y, double end, long steps,
                   const std::array<double, size>& exact) {
  EXPECT_EQ(step_contacts(system, y, 0, end, {.count = steps}), ContactStatus::reached_end);
  double worst = 0;
  for (std::size_t i = 0; i < size; ++i) worst = std::max(worst, std::abs(y[i] - exact[i]));
  return worst;
}

// Coulomb's disc: the path is straight. The error of the stop is a part of a step times the velocity.
TEST(MoreauJean, StopsABlockOnTheStraightLineOfItsVelocity) {
  const double angle = std::numbers::pi / 8;
  std::array<double, 6> y{0, 0, 0, 2 * std::cos(angle), 2 * std::sin(angle), 0};
  ASSERT_EQ(step_contacts(block_on_plane(0.3), y, 0, 1, {.count = 1000}), ContactStatus::reached_end);
  EXPECT_NEAR(y[1] / y[0], std::tan(angle), 1e-13);
  EXPECT_NEAR(std::hypot(y[0], y[1]), 2 * 2 / (2 * 0.3 * g), 0.001 * 0.001 * 0.3 * g);
  EXPECT_EQ(std::hypot(y[3], y[4]), 0.0);
}

// A gap that is open at the start closes within the first step: no gap of a step before is known then.
TEST(MoreauJean, ClosesWithinTheFirstStepWhatBeginsOpen) {
  constexpr double h = 1e-3, speed = 2;
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double theta : {0.5, 0.75, 1.0}) {
      for (const double part : {0.05, 0.4, 0.6, 0.95}) {
        SCOPED_TRACE(testing::Message() << e << ", " << theta << ", " << part);
        std::array<double, 2> y{part * h * speed, -speed}, exact = y;
        for (int step = 0; step < 2; ++step) {
          const auto status = step_contacts(ball(e), y, step * h, (step + 1) * h, {.count = 1, .theta = theta});
          ASSERT_EQ(status, ContactStatus::reached_end);
          EXPECT_GE(y[0], -1e-17);
        }
        ASSERT_TRUE(integrate_contacts(ball(e), exact, 0, 2 * h));
        // An impact is felt up to a step late, at the speed there, and gravity acts for two.
        EXPECT_NEAR(y[0], exact[0], h * (1 + e) * speed + 2 * h * h * g);
        EXPECT_NEAR(y[1], exact[1], 3 * h * g);
      }
    }
  }
}

// A ball dropped, bouncing to rest, and a sphere that bounces down a slope and then rolls: by events and by steps.
TEST(MoreauJean, TendsToTheMotionFromEventToEvent) {
  const auto sphere = sphere_on_slope(0.3, 0.2, 0.6, 0.05);
  const std::array<double, 6> start{0, 0.55, 0, 0, 0, 0};
  auto exact = start;
  ASSERT_TRUE(integrate_contacts(sphere, exact, 0, 2));
  exact[2] = exact[5] = 0;
  const auto error = [&](long steps) {
    auto y = start;
    EXPECT_EQ(step_contacts(sphere, y, 0, 2, {.count = steps}), ContactStatus::reached_end);
    y[2] = y[5] = 0;  // 20 times the others
    double worst = 0;
    for (std::size_t i = 0; i < 6; ++i) worst = std::max(worst, std::abs(y[i] - exact[i]));
    return worst;
  };
  // Of first order: errors of impacts' times, each a part of a step, times velocities of some m/s.
  const double coarse = error(200), fine = error(2000), finest = error(20000);
  EXPECT_LT(coarse, 10 * 2.0 / 200);
  EXPECT_LT(fine, coarse / 5);
  EXPECT_LT(finest, fine / 5);
}

// A rod that stands on its rough foot and falls over. With θ = 1 the gap at the start of a step, which the one before has put back,
// was above zero by a rounding or more: every step was free, and the rod fell through the floor.
TEST(MoreauJean, StandsOnAFootWithEveryTheta) {
  const auto rod = rod_on_its_foot();
  const std::array<double, 6> start{0, std::cos(0.2), 0.2, 0, 0, 0};
  auto exact = start;
  ASSERT_TRUE(integrate_contacts(rod, exact, 0, 0.4));
  for (const double theta : {0.5, 0.75, 1.0}) {
    double last = 0;
    for (const long steps : {100, 400, 1600}) {
      auto y = start;
      EXPECT_EQ(step_contacts(rod, y, 0, 0.4, {.count = steps, .theta = theta}), ContactStatus::reached_end);
      double error = 0;
      for (std::size_t i = 0; i < 6; ++i) error = std::max(error, std::abs(y[i] - exact[i]));
      EXPECT_LT(error, last > 0 ? last / 3 : 0.1) << theta << ' ' << steps;
      last = error;
    }
  }
}

TEST(MoreauJean, LetsNothingSink) {
  const auto system = ball(0.8);
  std::array<double, 2> y{1, 0};
  MoreauJean scheme(system);
  double carried = 0;
  for (int k = 0; k < 6000; ++k) {
    ASSERT_TRUE(scheme.step(1e-3 * k, 1e-3, y));
    ASSERT_GE(y[0], -1e-14);
    ASSERT_LE(scheme.residual(), 1e-12);
    if (k >= 5000) carried += scheme.impulses()(0);
  }
  // At rest it rises by no more than it falls in a step, and is carried by m g h a step, but for what it has at the
  // ends.
  EXPECT_LE(y[0], g * 1e-6);
  EXPECT_NEAR(carried, g, 2 * g * 1e-3);
}

TEST(MoreauJean, SaysHowDeepAStepWentBeforeItWasPutBack) {
  const auto system = ball(0);
  std::array<double, 2> y{0.5 * 1e-3, -1};
  MoreauJean scheme(system, 1);
  ASSERT_TRUE(scheme.step(0, 1e-3, y));
  // Closed at the start of the step only: it falls through by the half of what it moves, and a g h².
  EXPECT_NEAR(scheme.depth(), 0.5e-3 + g * 1e-6, 1e-15);
  EXPECT_NEAR(y[0], 0, 1e-15);
}

/// A ball of 1 kg that falls through what resists by d v, and tells so.
struct ResistedBall : ByHand<1, 1, 1> {
  double d = 0;
  void damping(double, const State&, std::array<double, 1>& rates) const { rates[0] = d; }
};

// Of v' = -g - d v a step makes v+ = v - h (g + d v) / (1 + θ h d): with θ = 1 what is not yet the velocity -g/d of a
// steady fall shrinks by 1 + h d = 41 a step, where explicit steps multiply it by 1 - h d = -39.
TEST(MoreauJean, TakesDampingThatItIsToldOfImplicitly) {
  constexpr double d = 4000, h = 0.01;
  ByHand<1, 1, 1> silent = ball(0);
  silent.fill = [](double, const auto& y, auto& r) {
    r.M(0, 0) = 1;
    r.F(0) = -g - d * y[1];
    r.gap[0] = y[0];
    r.J(0, 0) = 1;
    r.w(0) = y[1];
    r.drift(0) = 0;
  };
  const ResistedBall resisted{{silent}, d};
  MoreauJean scheme(resisted, 1), explicitly(silent, 1);
  std::array<double, 2> y{0.01, 3}, blown_up = y;
  for (int k = 0; k < 8; ++k) {
    ASSERT_TRUE(scheme.step(h * k, h, y));
    ASSERT_TRUE(explicitly.step(h * k, h, blown_up));
    ASSERT_NEAR(y[1] + g / d, (3 + g / d) / std::pow(1 + h * d, k + 1), 1e-15 * (k + 1)) << k;
  }
  EXPECT_GT(std::abs(blown_up[1]), 1e6);
  // Steps end on the floor, at rest.
  for (int k = 8; k < 4000; ++k) ASSERT_TRUE(scheme.step(h * k, h, y));
  EXPECT_EQ(y[1], 0);
  EXPECT_GE(y[0], 0);
  EXPECT_LE(y[0], g / d * h);
}

TEST(MoreauJean, RefusesImpossibleRules) {
  for (const ContactRule& wrong :
       {ContactRule{.friction = -0.1}, ContactRule{.friction = 0.3, .static_friction = 0.2}, ContactRule{.restitution = 1.5},
        ContactRule{.bound = -1}, ContactRule{.restitution = NAN}, ContactRule{.friction = 0.3, .static_friction = -1},
        ContactRule{.static_bound = -1}, ContactRule{.tangents = 1, .normal = false, .pressed_by = -1}}) {
    auto system = block_on_plane(0.3);
    system.rules[0] = wrong;
    std::array<double, 6> y{0, 0, 0, 1, 0, 0};
    MoreauJean scheme(system);
    EXPECT_FALSE(scheme.step(0, 1e-3, y));
    EXPECT_EQ(scheme.status(), ContactStatus::invalid_rule);
    EXPECT_EQ(scheme.contact(), 0);
    EXPECT_EQ(y[3], 1);
  }
}

// A box whose angles stay small: q = (x, y, z, rotations), its corners at (±0.1, ±0.08, -0.05).
ByHand<6, 6, 4> box_on_corners(double f) {
  ByHand<6, 6, 4> box{{}, [](double, const auto& y, auto& r) {
                        r.M.setIdentity();
                        r.M.diagonal().tail(3) << 0.003, 0.004, 0.005;
                        r.F << 0, 0, -g, 0, 0, 0;
                        r.J.setZero();
                        for (int i = 0; i < 4; ++i) {
                          const double rx = i / 2 == 0 ? -0.1 : 0.1, ry = i % 2 == 0 ? -0.08 : 0.08, rz = -0.05;
                          r.gap[static_cast<std::size_t>(i)] = y[2] + rz + ry * y[3] - rx * y[4];
                          r.J.block(3 * i, 0, 3, 6) << 0, 0, 1, ry, -rx, 0, 1, 0, 0, 0, rz, -ry, 0, 1, 0, -rz, 0, rx;
                        }
                        for (int k = 0; k < 12; ++k) {
                          r.w(k) = 0;
                          for (int j = 0; j < 6; ++j) r.w(k) += r.J(k, j) * y[static_cast<std::size_t>(6 + j)];
                        }
                        r.drift.setZero();
                      }};
  box.rules.fill({.tangents = 2, .friction = f});
  return box;
}

// Two corners are above the floor by a part of the gap's rounding: a box that stood on the other two alone tipped over them.
TEST(MoreauJean, SlidesOnCornersThatAreAboveTheFloorByRounding) {
  const auto box = box_on_corners(0.2);
  constexpr double v = 0.8, h = 0.02;
  for (const double tilt : {4e-16, -4e-16}) {
    std::array<double, 12> y{0, 0, 0.05, 0, tilt, 0, v};
    ASSERT_EQ(step_contacts(box, y, 0, 20 * h, {.count = 20}), ContactStatus::reached_end);
    // While it slides the scheme is exact but for rounding: a force that is constant, and θ = 1/2.
    EXPECT_NEAR(y[0], v * 0.4 - 0.2 * g * 0.4 * 0.4 / 2, 1e-14);
    EXPECT_NEAR(y[6], v - 0.2 * g * 0.4, 1e-14);
    EXPECT_NEAR(y[2], 0.05, 1e-15);
    for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(y[i], 0, 1e-14);
  }
}

}  // namespace
}  // namespace moreau_jean_test
