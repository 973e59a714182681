// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/mutual_gravitation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::mutual_gravitation_test {
namespace {

using namespace torsor::runtime;
using Pair = mutual_gravitation::Mechanism<double>;
using torsor::Number;
using torsor::Real;
using torsor::WorkingDigits;

// The values of the scene: both masses, the share of the first, the ellipse.
constexpr double m = 4.0, s = 0.75, a = 1.0, e = 0.6, rounding = 1.1e-16;
constexpr double tolerance = 1e-13;
constexpr DormandPrince54 precise{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};

/// Kepler's equation E − e sin E = n t by Newton's method, then r and the angle from the closest approach. Any scalar:
/// n = sqrt(G m/a³) = 2.
Real anomaly(const Real& t) {
  const Real mean = Real(2) * t;
  const Real eccentricity(Number::rational(3, 5), Real::working_digits());
  Real E = mean;
  for (int i = 0; i < 60; ++i) E -= (E - eccentricity * sin(E) - mean) / (Real(1) - eccentricity * cos(E));
  return E;
}

// 40 digits of r, phi and their rates against Kepler's equation: cos phi = (cos E − e)/(1 − e cos E),
// sin phi = 0.8 sin E/(1 − e cos E), r' = e n sin E/(1 − e cos E), phi' = n 0.8/(1 − e cos E)².
TEST(MutualGravitation, MovesByKeplersEquation) {
  const WorkingDigits precision(55);
  const Real eccentricity(Number::rational(3, 5), 55), minor(Number::rational(4, 5), 55);
  for (const char* time : {"1", "2", "5"}) {
    const auto row = examples::reference_digits("mutual_gravitation", time);
    ASSERT_EQ(row.size(), 8U);
    const Real t = Real::parse(time);
    const Real E = anomaly(t);
    const Real r = Real(1) - eccentricity * cos(E);
    EXPECT_LE(examples::distance(row[0], t / Real(4)), 1e-38);  // the centre of mass drifts evenly
    EXPECT_LE(examples::distance(row[1], -t / Real(8)), 1e-38);
    EXPECT_LE(examples::distance(row[2], r), 1e-38);
    EXPECT_LE(examples::distance(r * cos(row[3]), cos(E) - eccentricity), 1e-38);
    EXPECT_LE(examples::distance(r * sin(row[3]), minor * sin(E)), 1e-38);
    EXPECT_LE(examples::distance(row[6], Real(2) * eccentricity * sin(E) / r), 1e-37);
    EXPECT_LE(examples::distance(row[7], Real(2) * minor / (r * r)), 1e-37);
    // The motion of the kernels in double meets those digits.
    const auto motion = equations_of_motion<Pair>();
    const double end = t.to_double();
    const auto y = examples::state_at(motion, motion.initial(), 0.0, end, precise);
    const double allowed = 1e-12 * std::fmax(1.0, examples::amplification(motion, motion.initial(), 0.0, end));
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(y[i], row[i].to_double(), allowed) << i;
  }
}

/// Positions and velocities of the two masses in the plane.
struct Places {
  std::array<double, 2> p1, p2, v1, v2;
};
Places places(const Pair::State& state) {
  const double c = std::cos(state.q.phi), n = std::sin(state.q.phi), r = state.q.r;
  const std::array<double, 2> arm{r * c, r * n};
  const std::array<double, 2> rate{state.v.r * c - r * state.v.phi * n, state.v.r * n + r * state.v.phi * c};
  Places all{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double center = i == 0 ? state.q.X : state.q.Y, drift = i == 0 ? state.v.X : state.v.Y;
    all.p1[i] = center - (1 - s) * arm[i];
    all.p2[i] = center + s * arm[i];
    all.v1[i] = drift - (1 - s) * rate[i];
    all.v2[i] = drift + s * rate[i];
  }
  return all;
}

// Newton's law for each mass, in Cartesian components by hand: the accelerations of both are along the line between
// them, G times the other's mass over the square of the distance.
TEST(MutualGravitation, AcceleratesEachMassByTheOtherOverTheSquareOfTheDistance) {
  Pair::State state{};
  state.q = {0.3, -0.7, 1.3, 0.9};
  state.v = {0.2, 0.5, -0.4, 1.1};
  Pair::Accelerations acceleration{};
  Pair::Multipliers none{};
  ASSERT_EQ(Pair::forward_dynamics(Pair::precompute({}), state, {}, acceleration, none), torsor::Status::ok);
  const double c = std::cos(0.9), n = std::sin(0.9);
  const double along = acceleration.r - state.q.r * state.v.phi * state.v.phi;
  const double across = state.q.r * acceleration.phi + 2.0 * state.v.r * state.v.phi;
  const double pull = m / (state.q.r * state.q.r);  // of both, on their distance
  const double x2 = acceleration.X + s * (along * c - across * n), y2 = acceleration.Y + s * (along * n + across * c);
  EXPECT_NEAR(x2, -s * pull * c, 30 * rounding);
  EXPECT_NEAR(y2, -s * pull * n, 30 * rounding);
}

// Gradients of the invariants are below 30 near the closest approach; 6 revolutions are some 4000 steps of local error
// 1e-13 each: 3e-9 as a random walk times the gradient is 2e-10, all alike 1e-8.
TEST(MutualGravitation, KeepsEnergyMomentaAndLaplacesVector) {
  static_assert(Pair::first_integral_count == 4);
  const auto motion = equations_of_motion<Pair>();
  auto y = motion.initial();
  double worst = 0.0, off_the_conic = 0.0;
  const double energy = 0.5 * m * (0.25 * 0.25 + 0.125 * 0.125) - m * m * s * (1 - s) / (2 * a);
  const double spin = m * s * (1 - s) * std::sqrt(m * a * (1 - e * e));
  const auto result = integrate(motion, y, 0.0, 6 * std::numbers::pi, precise, [&](double t, const auto& now) {
    const auto state = unpack<Pair>(t, now);
    Pair::FirstIntegrals kept{};
    Pair::first_integrals(motion.precomputed(), state, kept);
    const Places at = places(state);
    // The same by hand, from the two masses in the plane.
    const double m1 = s * m, m2 = (1 - s) * m;
    const double dx = at.p2[0] - at.p1[0], dy = at.p2[1] - at.p1[1], d = std::hypot(dx, dy);
    const double by_hand = 0.5 * m1 * (at.v1[0] * at.v1[0] + at.v1[1] * at.v1[1]) +
                           0.5 * m2 * (at.v2[0] * at.v2[0] + at.v2[1] * at.v2[1]) - m1 * m2 / d;
    EXPECT_NEAR(kept.energy, by_hand, 50 * 20 * rounding);
    EXPECT_NEAR(kept.momentum_X, m1 * at.v1[0] + m2 * at.v2[0], 50 * 20 * rounding);
    EXPECT_NEAR(kept.momentum_Y, m1 * at.v1[1] + m2 * at.v2[1], 50 * 20 * rounding);
    const double vx = at.v2[0] - at.v1[0], vy = at.v2[1] - at.v1[1], turning = dx * vy - dy * vx;
    EXPECT_NEAR(kept.momentum_phi, m * s * (1 - s) * turning, 50 * 20 * rounding);
    // Laplace's vector (v ∧ L)/Gm − r/|r| points to the closest approach, as long as e.
    for (const double change :
         {kept.energy - energy, kept.momentum_phi - spin, vy * turning / m - dx / d - e, -vx * turning / m - dy / d}) {
      worst = std::fmax(worst, std::abs(change));
    }
    off_the_conic = std::fmax(off_the_conic, std::abs(a * (1 - e * e) / d - 1 - e * std::cos(state.q.phi)));
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(worst, 1e-8);
  EXPECT_LT(off_the_conic, 1e-8);
}

// The attraction does work only through the distance: P = −G m1 m2 r r'/r³, negative while the masses part. With the
// minus that the course loses once, T − U would grow.
TEST(MutualGravitation, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Pair>(equations_of_motion<Pair>(), 4.0, tolerance);
  examples::expect_kept(balance, 1.0);
  EXPECT_EQ(balance.work, 0.0);
  Pair::State state{};
  state.q = {0, 0, 2.0, 0};
  state.v = {0, 0, 1.0, 0};
  Pair::GeneralizedForces bias{};
  Pair::bias(Pair::precompute({}), state, bias);
  EXPECT_NEAR(-bias.r * state.v.r, -m * m * s * (1 - s) * 2.0 * 1.0 / 8.0, 20 * rounding);
}

}  // namespace
}  // namespace torsor::mutual_gravitation_test
