// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/sprung_absorber.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::sprung_absorber_test {
namespace {

using namespace torsor::runtime;
using Absorber = sprung_absorber::Mechanism<double>;
using State = StateVector<Absorber>;
using Complex = std::complex<double>;

// The values of the scene.
constexpr double m1 = 1.0, m2 = 0.1, k1 = 100.0, rounding = 1.1e-16;

Absorber::Linearisation linearised(const Absorber::Parameters& parameters) {
  Absorber::Linearisation linear{};
  EXPECT_EQ(Absorber::linearisation(Absorber::precompute(parameters), {}, {}, {}, {}, linear), torsor::Status::ok);
  return linear;
}

/// Complex amplitudes of the steady motion: (K + i omega C - omega² M) X = F at t = 0.
std::array<Complex, 2> amplitudes(const Absorber::Parameters& p) {
  const auto linear = linearised(p);
  std::array<Complex, 4> z;
  for (std::size_t i = 0; i < 4; ++i) {
    z[i] = Complex(linear.K[i] - p.omega * p.omega * linear.M[i], p.omega * linear.C[i]);
  }
  const Complex determinant = z[0] * z[3] - z[1] * z[2];
  return {(z[3] * linear.F[0] - z[2] * linear.F[1]) / determinant,
          (z[0] * linear.F[1] - z[1] * linear.F[0]) / determinant};
}

TEST(SprungAbsorber, HasTheMatricesOfTwoMassesAndTwoSprings) {
  const Absorber::Parameters p{.k2 = 8.0, .c2 = 0.3, .f = 2.0, .omega = 7.0};
  const auto linear = linearised(p);
  const std::array<double, 4> M{m1, 0.0, 0.0, m2}, C{p.c2, -p.c2, -p.c2, p.c2}, K{k1 + p.k2, -p.k2, -p.k2, p.k2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(linear.M[i], M[i]);
    EXPECT_DOUBLE_EQ(linear.C[i], C[i]);
    EXPECT_DOUBLE_EQ(linear.K[i], K[i]);
  }
  EXPECT_DOUBLE_EQ(linear.F[0], p.f);
  EXPECT_EQ(linear.F[1], 0.0);
}

// At omega² = k2/m2 the machine stands still and the absorber answers with f/k2. Its spring turns numbers of 100 N/m
// into 0: ten roundings of them, over the determinant k2².
TEST(SprungAbsorber, KeepsTheMachineStillAtItsOwnFrequency) {
  const auto [x1, x2] = amplitudes(Absorber::default_parameters());
  EXPECT_NEAR(std::abs(x1), 0.0, 10 * rounding);
  EXPECT_NEAR(x2.real(), -0.1, 10 * rounding);
  // The same in time: the scene starts on that motion. 1e-12 a step, 2000 steps at most.
  const auto motion = equations_of_motion<Absorber>();
  const auto end = examples::state_at(motion, motion.initial(), 0.0, 5.0,
                                      DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  EXPECT_NEAR(end[0], 0.0, 2e-9);
  EXPECT_NEAR(end[1], -0.1 * std::cos(50.0), 2e-9);
}

// The roots of det(K - omega² M): the absorber splits the machine's resonance in two.
TEST(SprungAbsorber, HasTwoResonances) {
  const auto linear = linearised(Absorber::default_parameters());
  for (const double omega : {8.543089535574103800624004, 11.7053671957424831326229}) {
    const double s = omega * omega;
    const double determinant = (linear.K[0] - s * linear.M[0]) * (linear.K[3] - s * linear.M[3]) -
                               (linear.K[1] - s * linear.M[1]) * (linear.K[2] - s * linear.M[2]);
    EXPECT_NEAR(determinant, 0.0, 20 * 1500 * rounding);  // products below 1500
  }
}

// Den Hartog: for mu = m2/m1 = 0.1 the tuning 1/(1 + mu) brings the two points through which the curves of all dampings
// pass to one height, sqrt(1 + 2/mu) static deflections; the damping sqrt(3 mu/(8 (1 + mu)³)) makes them nearly the
// tops.
TEST(SprungAbsorber, IsDampedBestByDenHartogsRule) {
  constexpr double mu = m2 / m1, tuning = 0.9090909090909090909, zeta = 0.1678520331536355446376009;
  const double own = tuning * std::sqrt(k1 / m1);
  Absorber::Parameters p{.k2 = m2 * own * own, .c2 = 0.0, .f = 1.0, .omega = 0.0};
  const double height = 4.582575694955840006588047 / k1;
  // The fixed points are where the curve without damping meets that of the two masses as one, with opposite signs.
  int found = 0;
  for (const double sign : {-1.0, 1.0}) {
    // (omega/omega1)² = (1 ± sqrt(mu/(2 + mu)))/(1 + mu)  (Den Hartog, 1956, 3.3)
    p.omega = std::sqrt((1.0 + sign * std::sqrt(mu / (2.0 + mu))) / (1.0 + mu) * k1 / m1);
    for (const double damping : {0.0, 0.05, 0.168, 0.3, 1.0}) {
      p.c2 = 2.0 * m2 * std::sqrt(k1 / m1) * damping;
      EXPECT_NEAR(std::abs(amplitudes(p)[0]), height, 1e-13);  // no pole nearby: a hundred roundings of numbers near 1
      ++found;
    }
  }
  EXPECT_EQ(found, 10);
  p.c2 = 2.0 * m2 * std::sqrt(k1 / m1) * zeta;
  double top = 0.0, top_less = 0.0, top_more = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    p.omega = 5.0 + 0.005 * i;
    auto q = p;
    top = std::fmax(top, std::abs(amplitudes(p)[0]));
    q.c2 = 0.8 * p.c2;
    top_less = std::fmax(top_less, std::abs(amplitudes(q)[0]));
    q.c2 = 1.2 * p.c2;
    top_more = std::fmax(top_more, std::abs(amplitudes(q)[0]));
  }
  EXPECT_GE(top, height);
  EXPECT_LT(top, 1.01 * height);  // the rule is the average of two dampings that make one fixed point a top each
  EXPECT_GT(top_less, 1.02 * height);
  EXPECT_GT(top_more, 1.02 * height);
}

TEST(SprungAbsorber, ObeysTheEnergyTheorem) {
  const Absorber::Parameters p{.k2 = 8.0, .c2 = 0.3, .f = 1.0, .omega = 9.0};
  const auto balance = examples::energy_balance<Absorber>(equations_of_motion<Absorber>(p), 10.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-7);
  EXPECT_GT(balance.work, 1e-3);
}

}  // namespace
}  // namespace torsor::sprung_absorber_test
