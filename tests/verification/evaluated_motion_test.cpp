// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/evaluated_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/verification/dormand_prince_853.hpp"
#include "torsor/generator/verification/gauss_collocation.hpp"
#include "torsor/generator/verification/radau_iia_5.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::evaluated_motion_test {
namespace {

using namespace torsor::literals;

Expression unit(const char* number, const char* of) { return Expression::quantity(number, of); }

// y'' = −y from (1, 0): the end of a circle. Some 60 steps, each within the tolerance, on a motion without growth.
TEST(DormandPrince853, FollowsACircle) {
  DormandPrince853 motion(
      [](double, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {y[1], -y[0]};
        return true;
      },
      {}, {1.0, 0.0}, 1e-13);
  ASSERT_TRUE(motion.advance(10.0));
  EXPECT_EQ(motion.time(), 10.0);
  EXPECT_NEAR(motion.state()[0], std::cos(10.0), 1e-11);
  EXPECT_NEAR(motion.state()[1], -std::sin(10.0), 1e-11);
}

// y' = y² from 1 leaves at t = 1.
TEST(DormandPrince853, SaysWhereASolutionEnds) {
  DormandPrince853 motion(
      [](double, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {y[0] * y[0]};
        return std::isfinite(rates[0]);
      },
      {}, {1.0}, 1e-10);
  EXPECT_FALSE(motion.advance(2.0));
  EXPECT_NEAR(motion.time(), 1.0, 1e-6);
  EXPECT_NE(motion.status(), "");
}

// The same circle: steps of 0.05 of a method of order 6 leave some 10 · 0.05⁶ / 2000; the radius stays, for circles are
// quadratic invariants.
TEST(GaussCollocation6, FollowsACircleAndKeepsItsRadius) {
  const auto off = [](double step) {
    GaussCollocation6 motion(
        [](double, const std::vector<double>& y, std::vector<double>& rates) {
          rates = {y[1], -y[0]};
          return true;
        },
        {}, {1.0, 0.0}, step);
    EXPECT_TRUE(motion.advance(10.0));
    EXPECT_NEAR(std::hypot(motion.state()[0], motion.state()[1]), 1.0, 1e-13);
    return std::abs(motion.state()[1] + std::sin(10.0));
  };
  EXPECT_LT(off(0.1), 1e-8);
  EXPECT_NEAR(std::log2(off(0.4) / off(0.2)), 6.0, 0.1);
}

// y' = −λ (y − cos t) − sin t has the solution cos t; an explicit method would need some λ · 10/6 steps. A stiffly
// accurate method errs by a part of 1/λ where λ h is large, whatever its tolerance (Hairer & Wanner II, IV.15).
TEST(RadauIia5, FollowsWhatIsSlowInAStiffMotion) {
  constexpr double lambda = 1e6;
  RadauIia5 motion(
      [](double t, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {-lambda * (y[0] - std::cos(t)) - std::sin(t)};
        return true;
      },
      {}, {1.0}, 1e-8);
  ASSERT_TRUE(motion.advance(10.0)) << motion.status();
  EXPECT_NEAR(motion.state()[0], std::cos(10.0), 1 / lambda);
  EXPECT_LT(motion.steps(), 2000);
}

// Steps far below 1e-8 of a motion, more than are allowed where a slope jumps: a vibration bends in each of them.
TEST(DormandPrince853, FollowsAVibrationThatIsShortBesideTheMotion) {
  DormandPrince853 motion(
      [](double, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {y[1], -y[0]};
        return true;
      },
      {}, {1.0, 0.0}, 1e-10);
  motion.expect(1e12);
  ASSERT_TRUE(motion.advance(20000.0)) << motion.status();
  EXPECT_GT(motion.steps(), 20000);
  // Each step errs by 1e-10 (1 + |y|) at most, and the oscillator keeps the length of what was added.
  EXPECT_NEAR(motion.state()[0], std::cos(20000.0), 2e-10 * static_cast<double>(motion.steps()));
}

TEST(RadauIia5, FollowsACircle) {
  RadauIia5 motion(
      [](double, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {y[1], -y[0]};
        return true;
      },
      {}, {1.0, 0.0}, 1e-10);
  ASSERT_TRUE(motion.advance(10.0)) << motion.status();
  EXPECT_NEAR(motion.state()[0], std::cos(10.0), 1e-8);
}

// An atom on its spring goes round in some 1e-14 s: no second is short or long by itself.
template <class Method>
void expect_to_follow_an_atom(double tolerance, double allowed) {
  constexpr double w = 1e14;
  Method motion(
      [](double, const std::vector<double>& y, std::vector<double>& rates) {
        rates = {w * y[1], -w * y[0]};
        return true;
      },
      {}, {1.0, 0.0}, tolerance);
  for (int k = 1; k <= 20; ++k) {
    const double time = k * 5e-15;
    ASSERT_TRUE(motion.advance(time)) << motion.status();
    EXPECT_EQ(motion.time(), time);
    EXPECT_NEAR(motion.state()[0], std::cos(w * time), allowed) << k;
  }
}

TEST(DormandPrince853, FollowsAnAtom) { expect_to_follow_an_atom<DormandPrince853>(1e-13, 1e-11); }

TEST(RadauIia5, FollowsAnAtom) { expect_to_follow_an_atom<RadauIia5>(1e-10, 1e-8); }

/// Two bars and a slider on the line y = 0: the coordinates of a crank with the closure of a loop.
Scene crank() {
  Scene scene("crank", "");
  const Expression r = scene.parameter("r", "m", 1), l = scene.parameter("l", "m", 3);
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  scene.initial(a, 1, unit("2", "rad/s"));
  const FrameHandle bar = scene.revolute("bar", scene.ground(), axis::z, a);
  const FrameHandle rod = scene.revolute("rod", bar, axis::z, b - a, {.origin = {r, 0, 0}});
  scene.body("bar", bar, Inertia::rod(unit("1", "kg"), r, 0).at({r / 2, 0, 0}));
  scene.body("rod", rod, Inertia::rod(unit("2", "kg"), l, 0).at({l / 2, 0, 0}));
  scene.holonomic("slider", r * sin(a) + l * sin(b));
  return scene;
}

// From an open loop the nearest closed state in the metric of masses: r sin a + l sin b = 0 and its rate.
TEST(EvaluatedMotion, ClosesConstraints) {
  EvaluatedMotion motion(crank(), {}, {}, {});
  std::vector<double> y = motion.start({{"b", 0.3}});
  ASSERT_TRUE(motion.settle(0.0, y));
  EXPECT_NEAR(std::sin(y[0]) + 3 * std::sin(y[1]), 0.0, 1e-14);
  EXPECT_NEAR(std::cos(y[0]) * y[2] + 3 * std::cos(y[1]) * y[3], 0.0, 1e-14);
  EXPECT_NE(y[0], 1.0);
}

// Without gravity and forces T is constant: some 200 steps of 1e-12 each, energies of some 5 J.
TEST(EvaluatedMotion, KeepsEnergyOnConstraints) {
  EvaluatedMotion motion(crank(), {}, {}, {});
  std::vector<double> y = motion.start({});
  ASSERT_TRUE(motion.settle(0.0, y));
  const double before = motion.observe(0.0, y)[2];
  DormandPrince853 integrator([&](double t, const std::vector<double>& at, std::vector<double>& rates) { return motion.slope(t, at, rates); },
                              [&](double t, std::vector<double>& at) { return motion.settle(t, at); }, y, 1e-12);
  ASSERT_TRUE(integrator.advance(5.0));
  EXPECT_NEAR(motion.observe(5.0, integrator.state())[2], before, 1e-9 * std::abs(before));
  EXPECT_NEAR(std::sin(integrator.state()[0]) + 3 * std::sin(integrator.state()[1]), 0.0, 1e-13);
}

// A free body that turns about a principal axis: its quaternion keeps norm 1 and turns by half the angle.
TEST(EvaluatedMotion, TurnsAQuaternion) {
  EvaluatedMotion motion(testing_mechanisms::torque_free_body(), {}, {}, {});
  EXPECT_TRUE(motion.needs_settling());
  DormandPrince853 integrator([&](double t, const std::vector<double>& at, std::vector<double>& rates) { return motion.slope(t, at, rates); },
                              [&](double t, std::vector<double>& at) { return motion.settle(t, at); },
                              motion.start({{"e_omega_z", 0.5}}), 1e-13);
  ASSERT_TRUE(integrator.advance(4.0));
  EXPECT_NEAR(integrator.state()[0], std::cos(1.0), 1e-12);
  EXPECT_NEAR(integrator.state()[3], std::sin(1.0), 1e-12);
}

TEST(EvaluatedMotion, TakesParametersByName) {
  EXPECT_NEAR(EvaluatedMotion(crank(), {}, {{"r", 2.0}}, {}).start({})[0], 1.0, 0.0);
  EvaluatedMotion longer(crank(), {}, {{"r", 2.0}}, {});
  std::vector<double> y = longer.start({});
  ASSERT_TRUE(longer.settle(0.0, y));
  EXPECT_NEAR(2 * std::sin(y[0]) + 3 * std::sin(y[1]), 0.0, 1e-14);
  EXPECT_THROW(EvaluatedMotion(crank(), {}, {{"radius", 2.0}}, {}), UsageError);
  EXPECT_THROW(EvaluatedMotion(crank(), {}, {}, {{"push", 2.0}}), UsageError);
  EXPECT_THROW((void)EvaluatedMotion(crank(), {}, {}, {}).start({{"c", 2.0}}), UsageError);
}

}  // namespace
}  // namespace torsor::evaluated_motion_test
