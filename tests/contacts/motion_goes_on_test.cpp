// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that are asked for again and again: what a method knows of the equations is kept from one time to the next.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"

namespace motion_goes_on_test {
namespace {

using namespace simple_systems;

/// A block on a floor without friction, q = (x, z), driven to x = `aim` by a stiff motor.
struct Driven {
  static constexpr std::size_t nq = 2, nv = 2, contacts = 1;
  static constexpr double k = 1e4, c = 1001;  // e^(-10.09 t) and e^(-990.9 t) of a mass of 1 kg
  double aim = 1;
  long* reads = nullptr;
  [[nodiscard]] ContactRule rule(int) const { return {.tangents = 1}; }
  [[nodiscard]] Evaluation read(double, const std::array<double, 4>& y, ContactReading& r) const {
    if (reads != nullptr) ++*reads;
    r.M.setIdentity();
    r.F << k * (aim - y[0]) - c * y[2], -g;
    r.gap[0] = y[1];
    r.J << 0, 1, 1, 0;
    r.w << y[3], y[2];
    r.drift.setZero();
    return Evaluation::ok;
  }
  void coordinate_rates(double, const std::array<double, 4>& y, std::array<double, 2>& rates) const { rates = {y[2], y[3]}; }
};

/// x'' + c x' + k x = 0 for a time.
std::pair<double, double> exact(double x, double v, double time) {
  const double root = std::sqrt(Driven::c * Driven::c / 4 - Driven::k);
  const double slow = -Driven::k / (Driven::c / 2 + root), fast = -Driven::c / 2 - root;
  const double a = (v - fast * x) / (slow - fast), b = x - a;
  const double first = a * std::exp(slow * time), second = b * std::exp(fast * time);
  return {first + second, slow * first + fast * second};
}

constexpr RadauIia5 stiff{.relative_tolerance = 1e-8, .absolute_tolerance = 1e-8};

template <class Method>
struct Moved {
  Method method;
  Driven block{};
  const ContactMechanismOf<Driven> mechanism{block};
  std::array<double, 4> y{};
  IgnoreSteps none{};
  ContactRun<4, 1, Method, IgnoreSteps> run{mechanism, y, method, {}, none};
};

TEST(MotionThatGoesOn, KeepsTheJacobianAndTheStep) {
  Moved<RadauIia5> moved{.method = stiff};
  ASSERT_TRUE(moved.run.start(0));
  for (int i = 1; i <= 1000; ++i) ASSERT_TRUE(moved.run.advance(1e-3 * i)) << i;
  const auto [x, v] = exact(-1, 0, 1);
  EXPECT_NEAR(moved.y[0], 1 + x, 1e-7);
  EXPECT_NEAR(moved.y[2], v, 1e-6);
  EXPECT_LE(moved.run.result().integration.statistics.jacobians, 40);  // once each time before
  EXPECT_LE(moved.run.result().integration.statistics.rejected, 20);
}

// Each time the motor is sent elsewhere: the slope that was is of other equations.
TEST(MotionThatGoesOn, TakesWhatTheMechanismSaysNow) {
  Moved<RadauIia5> moved{.method = stiff};
  ASSERT_TRUE(moved.run.start(0));
  double x = 0, v = 0;
  for (int i = 1; i <= 200; ++i) {
    moved.block.aim = i % 2 == 0 ? 1 : -2;
    ASSERT_TRUE(moved.run.advance(0.01 * i)) << i;
    std::tie(x, v) = exact(x - moved.block.aim, v, 0.01);
    x += moved.block.aim;
    ASSERT_NEAR(moved.y[0], x, 1e-6) << i;
  }
}

// A limit of steps is one of each call: motions that are taken in small parts for ever do not come to it.
TEST(MotionThatGoesOn, CountsItsStepsAnew) {
  Moved<DormandPrince853> moved{.method = {.relative_tolerance = 1e-8, .absolute_tolerance = 1e-8, .step_limit = 20}};
  ASSERT_TRUE(moved.run.start(0));
  for (int i = 1; i <= 300; ++i) ASSERT_TRUE(moved.run.advance(1e-3 * i)) << i;
  EXPECT_GT(moved.run.result().integration.statistics.accepted, 290);
}

// A new start is one of another motion, and another method one that knows nothing.
TEST(MotionThatGoesOn, BeginsAnewWhereItIsStartedAgain) {
  Moved<RadauIia5> moved{.method = stiff};
  std::array<double, 4> first{};
  for (const bool again : {false, true}) {
    moved.y = {};
    ASSERT_TRUE(moved.run.start(0) && moved.run.advance(0.01) && moved.run.advance(0.02));
    if (again) {
      EXPECT_EQ(moved.y, first);
    }
    first = moved.y;
  }
  moved.run.use({.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  ASSERT_TRUE(moved.run.advance(0.03));
  auto [x, v] = exact(first[0] - 1, first[2], 0.01);
  EXPECT_NEAR(moved.y[0], 1 + x, 1e-11);
}

// All guards read one state in turn: where they went from one to the other and back, a step took two readings a guard more.
TEST(MotionThatGoesOn, ReadsAMechanismAtRestSeldom) {
  long reads = 0;
  Moved<RadauIia5> moved{.method = stiff, .block = {.aim = 0, .reads = &reads}};
  ASSERT_TRUE(moved.run.start(0) && moved.run.advance(1));
  reads = 0;
  for (int i = 1; i <= 100; ++i) ASSERT_TRUE(moved.run.advance(1 + 0.01 * i)) << i;
  EXPECT_LE(reads, 100 * 26);
}

}  // namespace
}  // namespace motion_goes_on_test
