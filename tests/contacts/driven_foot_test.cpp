// SPDX-License-Identifier: GPL-3.0-or-later
// A plate that slides with a spin on three feet and on a fourth that a slider drives: how the feet share the weight is not
// determined, so that each instant has a continuum of motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "tests/contacts/simple_systems.hpp"

namespace driven_foot_test {
namespace {

using namespace simple_systems;

struct Foot { double x, y, speed = 0; };

/// Feet A, B and D of a plate at (0, 0), (1, 1) and (0, 1) m, and a driven one; its centre of mass at (x, y).
struct Plate {
  double x = 0.3, y = 0.6, height = 0.05, mass = 2, about_x = 2.02 / 12, about_z = 4.0 / 12, friction = 0.3;
  std::array<Foot, 4> feet;
};
using Moving = ByHand<6, 6, 4>;

Moving moving(const Plate& plate) {
  std::array<ContactRule, 4> rules;
  rules.fill(ContactRule{.friction = plate.friction});
  return {rules, [plate](double t, const auto& y, auto& r) {
            r.M.setZero();
            r.M.diagonal() << plate.mass, plate.mass, plate.mass, plate.about_x, plate.about_x, plate.about_z;
            r.F << 0, 0, -plate.mass * g, 0, 0, 0;
            r.J.setZero();
            // Angles of tilt stay small: offsets of feet are turned by the yaw alone.
            const double c = std::cos(y[5]), s = std::sin(y[5]), turns = y[11];
            for (int i = 0; i < 4; ++i) {
              const Foot& foot = plate.feet[static_cast<std::size_t>(i)];
              const double x = foot.x + foot.speed * t - plate.x, across = foot.y - plate.y;
              const double X = c * x - s * across, Y = s * x + c * across, vx = c * foot.speed, vy = s * foot.speed;
              const double ax = -turns * (turns * X + 2 * vy), ay = turns * (2 * vx - turns * Y);
              r.gap[static_cast<std::size_t>(i)] = y[2] - plate.height + y[3] * Y - y[4] * X;
              r.J.row(3 * i) << 0, 0, 1, Y, -X, y[3] * X + y[4] * Y;
              r.J.row(3 * i + 1) << 1, 0, 0, 0, -plate.height, -Y;
              r.J.row(3 * i + 2) << 0, 1, 0, plate.height, 0, X;
              const Eigen::Map<const Eigen::Matrix<double, 6, 1>> v(y.data() + 6);
              r.w.segment(3 * i, 3) = r.J.middleRows(3 * i, 3) * v + Eigen::Vector3d(y[3] * vy - y[4] * vx, vx, vy);
              const double tilts = y[9] * (turns * X + vy) - y[10] * (vx - turns * Y);
              r.drift.segment(3 * i, 3) << 2 * tilts + y[3] * ay - y[4] * ax, ax, ay;
            }
          }};
}

/// Foot A moves with this velocity, and the plate turns.
Moving::State thrown(const Plate& plate, double vx, double vy, double turns) {
  return {0, 0, plate.height, 0, 0, 0, vx - turns * plate.y, vy + turns * plate.x, 0, 0, 0, turns};
}

struct Told {
  ContactResult result;
  int slips_ended = 0;
};

Told run(const Plate& plate, Moving::State& y, double tolerance) {
  Told told;
  const auto count = [&told](const ContactEvent& event) {
    told.slips_ended += event.kind == ContactEventKind::slip_ends ? 1 : 0;
  };
  const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
  told.result = integrate_contacts(moving(plate), y, 0, 1, method, {.event_limit = 3000}, count);
  return told;
}

// Foot B was left to slide where A does not press, which is one end of the continuum, and to stick inside of it, four thousand
// million times a second.
TEST(DrivenFoot, LetsThePlateTurnAboutOneFootAndComeToRest) {
  Plate plate;
  plate.feet = {Foot{0, 0}, Foot{1, 1}, Foot{-0.5, 0.05, 1}, Foot{0, 1}};
  Moving::State y = thrown(plate, 1, 0, 0.3);
  const Told told = run(plate, y, 1e-11);
  ASSERT_TRUE(told.result) << describe(told.result.status) << " at " << told.result.time;
  EXPECT_EQ(told.slips_ended, 3);
  EXPECT_LE(told.result.events, 4);
  for (std::size_t i = 6; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-15);
}

// Slips that begin where reactions are not unique, and normal forces that fall to zero together, alternated as fast.
TEST(DrivenFoot, MovesOnWhateverThePlate) {
  for (const unsigned seed : {46U, 53U, 140U}) {
    std::mt19937 random(seed);
    const auto between = [&random](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
    Plate plate;
    plate.friction = between(0.05, 0.8);
    plate.mass = std::pow(10, between(-1, 1));
    plate.about_x = plate.mass * between(0.05, 0.3);
    plate.about_z = plate.mass * between(0.05, 0.4);
    plate.height = between(0, 0.2);
    Foot driven;
    driven.x = between(-1, 1);
    driven.y = between(-0.5, 1);
    driven.speed = between(-2, 2);
    plate.feet = {Foot{0, 0}, Foot{1, 1}, driven, Foot{0, 1}};
    if (seed % 3 == 2) {
      plate.feet[1].x += between(-0.3, 0.3);
      plate.feet[1].y += between(-0.3, 0.3);
      plate.feet[1].speed = between(-0.2, 0.2);
    }
    const double u = between(0.05, 0.9);
    plate.x = between(0.05, 0.95 - u);
    plate.y = u + plate.x;
    const double turns = between(-2, 2) * (seed % 4 == 0 ? 0.2 : 1), vy = between(-1, 1), vx = between(-1, 1);
    Moving::State y = thrown(plate, vx, vy, turns), other = y;
    const double tolerance = seed % 2 == 1 ? 1e-11 : 1e-8, finer = 1e-10;
    const Told told = run(plate, y, tolerance), again = run(plate, other, finer);
    EXPECT_TRUE(told.result) << seed << ": " << describe(told.result.status) << " at " << told.result.time;
    EXPECT_TRUE(again.result) << seed << ": " << describe(again.result.status) << " at " << again.result.time;
    EXPECT_LE(told.result.worst_residual, 1e-9) << seed;
    // One motion, whatever reactions are held: what steps are off by grows while the plate slips.
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], other[i], 1e3 * std::max(tolerance, finer)) << seed << ' ' << i;
  }
}

}  // namespace
}  // namespace driven_foot_test
