// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/kapitza_pendulum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::kapitza_pendulum_test {
namespace {

using namespace torsor::runtime;
using Pendulum = kapitza_pendulum::Mechanism<double>;
using State = StateVector<Pendulum>;

// The values of the scene.
constexpr double m = 1.0, L = 1.0, g = 9.81, a = 0.1, rounding = 1.1e-16;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

auto shaken_at(double omega) {
  Pendulum::Parameters parameters = Pendulum::default_parameters();
  parameters.omega = omega;
  return equations_of_motion<Pendulum>(parameters);
}

// Independent truth of theta'' = (g - 0.1 omega² cos(omega t)) sin(theta) from 0.2 at rest: 25 digits at 100 rad/s, and
// at 40 rad/s, where a omega is below sqrt(2 g L) = 4.43 m/s, a fall.
TEST(KapitzaPendulum, MeetsItsIndependentReferences) {
  const auto row = examples::reference_digits("kapitza_pendulum", "2");
  ASSERT_EQ(row.size(), 2U);
  examples::expect_digits(row[0], "0.1895318802312945945552548", 1e-24, "theta");
  examples::expect_digits(row[1], "1.5286678084217681813518", 1e-21, "theta'");
  struct Truth {
    double omega, theta;
  };
  for (const auto& [omega, theta] :
       {Truth{100.0, 0.1895318802312945945552548}, Truth{40.0, 2.379494705031047892817021}}) {
    const auto motion = shaken_at(omega);
    const State y = examples::state_at(motion, motion.initial(), 0.0, 2.0, precise);
    EXPECT_NEAR(y[0], theta, 1e-13 * examples::amplification(motion, motion.initial(), 0.0, 2.0)) << omega;
  }
}

/// Trace of the motion over one period of the shaking, linearised about the upright rest: Floquet's roots have the
/// product 1 (no friction), so the rest is stable where |trace| < 2. An independent derivation: Runge-Kutta on Hill's
/// equation.
double trace_of_hill(double omega) {
  constexpr int steps = 4000;
  const double h = 2.0 * std::numbers::pi / omega / steps;
  const auto stiffness = [omega](double t) { return g / L - a / L * omega * omega * std::cos(omega * t); };
  double trace = 0.0;
  for (const std::array<double, 2> start : {std::array{1.0, 0.0}, std::array{0.0, 1.0}}) {
    double x = start[0], v = start[1];
    for (int i = 0; i < steps; ++i) {
      const double t = i * h, k0 = stiffness(t), k1 = stiffness(t + h / 2.0), k2 = stiffness(t + h);
      const double v1 = v, a1 = k0 * x, v2 = v + h / 2.0 * a1, a2 = k1 * (x + h / 2.0 * v1);
      const double v3 = v + h / 2.0 * a2, a3 = k1 * (x + h / 2.0 * v2), v4 = v + h * a3, a4 = k2 * (x + h * v3);
      x += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
      v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    trace += start[0] == 1.0 ? x : v;
  }
  return trace;
}

/// The same trace from the generated equations, by differences of 1e-6 rad: theta³/6 leaves 1e-12 of it, rounding
/// 1e-10.
double trace_of_motion(double omega) {
  const auto motion = shaken_at(omega);
  const double period = 2.0 * std::numbers::pi / omega;
  constexpr double step = 1e-6;
  const State angle = examples::state_at(motion, State{step, 0.0}, 0.0, period, precise);
  const State rate = examples::state_at(motion, State{0.0, step * omega}, 0.0, period, precise);
  return angle[0] / step + rate[1] / (step * omega);
}

// The averaged threshold a omega = sqrt(2 g L) is 44.3 rad/s; with a/L = 0.1 the exact one, of Hill's equation, is
// close.
TEST(KapitzaPendulum, StandsUprightAboveTheThreshold) {
  for (const double omega : {30.0, 40.0, 44.0, 45.0, 46.0, 60.0, 100.0}) {
    EXPECT_NEAR(trace_of_motion(omega), trace_of_hill(omega), 1e-6) << omega;
  }
  EXPECT_GT(trace_of_motion(40.0), 2.0);
  EXPECT_LT(std::abs(trace_of_motion(46.0)), 2.0);
  EXPECT_LT(std::abs(trace_of_motion(100.0)), 2.0);
  double below = 40.0, above = 46.0;
  while (above - below > 1e-6) {
    const double middle = 0.5 * (below + above);
    (trace_of_motion(middle) > 2.0 ? below : above) = middle;
  }
  // Averaging has an error of the relative order of a/L squared, 1 % (found: 0.5 %).
  EXPECT_NEAR(above, std::sqrt(2.0 * g * L) / a, 0.01 * 44.3);
  // The slow frequency, sqrt(a² omega²/2 - g) at 100 rad/s by averaging; by Floquet, trace = 2 cos(frequency * period).
  const double slow = std::acos(trace_of_motion(100.0) / 2.0) * 100.0 / (2.0 * std::numbers::pi);
  EXPECT_NEAR(slow, 6.339558344238185177899774, 0.01 * 6.34);
}

// By hand: what the shaker gives is m (g + z''), z = a cos(omega t) + L cos(theta).
TEST(KapitzaPendulum, TakesItsEnergyFromTheShaker) {
  constexpr double omega = 100.0;
  const auto motion = shaken_at(omega);
  const auto force = [](const Pendulum::State& s, const Pendulum::Accelerations& acceleration) {
    return m * (g - a * omega * omega * std::cos(omega * s.time) - L * std::sin(s.q.theta) * acceleration.theta -
                L * std::cos(s.q.theta) * s.v.theta * s.v.theta);
  };
  for (int i = 0; i < 20; ++i) {
    Pendulum::State s{};
    s.time = 0.013 * i;
    s.q.theta = 0.3 * i - 3.0;
    s.v.theta = 2.0 - 0.2 * i;
    const Pendulum::Accelerations acceleration{3.0 - 0.4 * i};
    Pendulum::Reactions reactions{};
    Pendulum::reactions(motion.precomputed(), s, acceleration, {}, {}, reactions);
    // 1000 N, whose phase, up to 25 rad, is rounded twice: forty roundings.
    EXPECT_NEAR(reactions.shaker, force(s, acceleration), 40 * 1000 * rounding);
  }
  const auto balance = examples::energy_balance<Pendulum>(
      motion, 2.0, 1e-12,
      [&](const Pendulum::State& s, const Pendulum::Accelerations& acceleration, const Pendulum::Multipliers&) {
        return -force(s, acceleration) * a * omega * std::sin(omega * s.time);
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 10.0);
}

}  // namespace
}  // namespace torsor::kapitza_pendulum_test
