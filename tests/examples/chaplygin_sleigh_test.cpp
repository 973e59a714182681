// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/chaplygin_sleigh.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::chaplygin_sleigh_test {
namespace {

using namespace torsor::runtime;
using torsor::Real;
using Sleigh = chaplygin_sleigh::Mechanism<double>;
using State = StateVector<Sleigh>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene, and the moment about the knife edge.
constexpr double m = 1.0, J = 0.5, a = 0.5, moment = J + m * a * a, rounding = 1.1e-16;

// The exact motion, v the speed along the blade and w = phi': w = 2 sech(kappa t), v = V tanh(kappa t), x and y by
// quadrature.
struct Exact {
  const char *time, *w, *v, *phi, *x, *y;
};
constexpr std::array<Exact, 3> exact{{
    {"1", "1.146715032865116817849888", "1.419078389325574058592747", "1.663112267740495645721386",
     "0.3104174112524833620865433", "0.7097559986894674224631263"},
    {"2", "0.3934021203175827818027108", "1.698212612954344592265505", "2.377766662222529298669602",
     "-0.4743750140853927857643604", "2.07198051320879098026079"},
    {"5", "0.01243527613535366703199468", "1.732017327549172681103881", "2.709929711925617937772627",
     "-4.962552578528138108956621", "4.620878285943257361202337"},
}};

double along_blade(const Sleigh::State& s) { return s.v.x * std::cos(s.q.phi) + s.v.y * std::sin(s.q.phi); }
double across_blade(const Sleigh::State& s) { return -s.v.x * std::sin(s.q.phi) + s.v.y * std::cos(s.q.phi); }

// The exact values are written with 24 digits or so, checked to 22.
TEST(ChaplyginSleigh, HasACommittedReferenceThatAgreesWithTheExactMotionTo22Digits) {
  for (const Exact& at : exact) {
    const auto row = examples::reference_digits("chaplygin_sleigh", at.time);
    ASSERT_EQ(row.size(), 6U);
    Real sine, cosine;
    torsor::sincos(row[2], sine, cosine);
    examples::expect_digits(row[0], at.x, 5e-22, "x");
    examples::expect_digits(row[1], at.y, 5e-22, "y");
    examples::expect_digits(row[2], at.phi, 5e-22, "phi");
    examples::expect_digits(row[5], at.w, 5e-22, "w");
    examples::expect_digits(row[3] * cosine + row[4] * sine, at.v, 5e-22, "v");
  }
}

TEST(ChaplyginSleigh, MeetsTheExactMotionInDouble) {
  const auto motion = equations_of_motion<Sleigh>();
  State y = motion.initial();
  double t = 0.0;
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (const Exact& at : exact) {
    const double end = std::stod(at.time);
    y = examples::state_at(motion, y, t, end, precise);
    t = end;
    const auto s = unpack<Sleigh>(t, y);
    const double allowed = 1e-13 * growth.until(t);
    EXPECT_NEAR(s.q.x, std::stod(at.x), allowed);
    EXPECT_NEAR(s.q.y, std::stod(at.y), allowed);
    EXPECT_NEAR(s.q.phi, std::stod(at.phi), allowed);
    EXPECT_NEAR(s.v.phi, std::stod(at.w), allowed);
    EXPECT_NEAR(along_blade(s), std::stod(at.v), 2 * allowed);  // two rates of x and y
    EXPECT_NEAR(across_blade(s), 0.0, 2 * allowed);
  }
}

// By hand, in the sleigh's axes: v' = a w², w' = -(m a / moment) v w, and across the blade N = m (a w' + v w).
// Vakonomic equations, which vary the motion under the constraint instead, have another w'.
TEST(ChaplyginSleigh, HasTheAccelerationsAndTheForceOfNewtonAndEuler) {
  const auto motion = equations_of_motion<Sleigh>();
  for (int i = 0; i < 30; ++i) {
    const double phi = 0.4 * i, v = 3.0 - 0.2 * i, w = -2.0 + 0.15 * i;
    Sleigh::State s{};
    s.q = {0.3, -0.7, phi};
    s.v = {v * std::cos(phi), v * std::sin(phi), w};
    Sleigh::Accelerations found{};
    Sleigh::Multipliers force{};
    ASSERT_EQ(motion.accelerations(s, found, force), Evaluation::ok);
    const double along = a * w * w, turning = -m * a / moment * v * w;
    // Thirty roundings of numbers below 10.
    constexpr double tolerance = 30 * 10 * rounding;
    EXPECT_NEAR(found.phi, turning, tolerance);
    EXPECT_NEAR(found.x, along * std::cos(phi) - v * w * std::sin(phi), tolerance);
    EXPECT_NEAR(found.y, along * std::sin(phi) + v * w * std::cos(phi), tolerance);
    EXPECT_NEAR(force.N, m * (a * turning + v * w), tolerance);
  }
}

// Backwards, the centre of mass behind the edge, is unstable: the sleigh turns round and ends forwards at the speed
// that m v² + moment w² allows.
TEST(ChaplyginSleigh, TurnsRoundWhenItStartsBackwards) {
  const auto motion = equations_of_motion<Sleigh>();
  Sleigh::State start{};
  start.v = {-1.0, 0.0, 1e-3};
  const double V = std::sqrt((m + moment * 1e-6) / m);
  const State y = examples::state_at(motion, pack<Sleigh>(start), 0.0, 60.0, precise);
  const auto end = unpack<Sleigh>(60.0, y);
  // From tanh: 1 - v/V = 2 exp(-2 kappa (60 - 11.9)), kappa = 2/3, 11.9 s to turn: below rounding. 1e-13 a step, 2000
  // steps.
  EXPECT_NEAR(along_blade(end), V, 1e-11);
  EXPECT_NEAR(end.v.phi, 0.0, 1e-11);
  // w = w_max sech has the area pi w_max / kappa = pi sqrt(moment / m) / a: the angle of the whole turn.
  EXPECT_NEAR(end.q.phi, 3.14159265358979 * std::sqrt(moment * m) / (m * a), 5e-3);
}

// The force is across the velocity of its point: it gives no work, and T = m v²/2 + moment w²/2 stays.
TEST(ChaplyginSleigh, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Sleigh>(
      equations_of_motion<Sleigh>(), 5.0, 1e-12,
      // Beside the constraint by rounding and truncation the force does work: with what is left of the velocity.
      [](const Sleigh::State& s, const Sleigh::Accelerations&, const Sleigh::Multipliers& force) {
        return force.N * across_blade(s);
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-8);
  EXPECT_LT(balance.work, 1e-10);
  const auto end = unpack<Sleigh>(
      5.0, examples::state_at(equations_of_motion<Sleigh>(), pack<Sleigh>(Sleigh::initial_state()), 0.0, 5.0, precise));
  EXPECT_NEAR(m * std::pow(along_blade(end), 2) + moment * end.v.phi * end.v.phi, 4.0 * moment, 1e-11);
}

}  // namespace
}  // namespace torsor::chaplygin_sleigh_test
