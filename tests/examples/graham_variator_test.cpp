// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/graham_variator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::graham_variator_test {
namespace {

using namespace torsor::runtime;
using Eigen::Vector3d;
using Variator = graham_variator::Mechanism<double>;
using State = StateVector<Variator>;
/// Places of the conditions of no slip across the plane x1, y1.
constexpr std::size_t A_z1 = 1, E_z1 = 3;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene.
constexpr double c = 0.1, l = 0.03, p = 0.02, b = 0.06, m2 = 1, A1 = 0.01, A2 = 0.0003, B2 = 0.0008, A3 = 0.02,
                 g = 9.81;
constexpr double delta = std::numbers::pi / 12;
const double r3 = c - l * std::sin(delta) + p * std::cos(delta), r_G = c - b * std::sin(delta);
constexpr std::array<double, 4> settings{0.05, 0.08, 0.1, 0.14};

Variator::Parameters setting(double d) {
  Variator::Parameters parameters = Variator::default_parameters();
  parameters.d = d;
  return parameters;
}
/// beta'/alpha' and gamma'/alpha' of rolling at A and E.
double beta_ratio(double d) { return -c / (d * std::tan(delta)); }
double gamma_ratio(double d) { return 1 + beta_ratio(d) * p / r3; }

Variator::State some_state(int i) {
  Variator::State s{};
  s.q = {0.4 * i - 1.0, 0.7 * i, 0.3 - 0.2 * i};
  s.v = {3.0 - 0.8 * i, 1.2 * i - 4.0, 0.5 + 0.3 * i};
  return s;
}

// Question 1, by composition of twists at any rates: V(A ∈ S2/S4) = V(C ∈ S1/S0) + Omega(S2/S0) ∧ CA, and V(E ∈ S2/S3)
// likewise less gamma' x0 ∧ OE; both along z1 alone: c alpha' + d tan(delta) beta' and r3 (alpha' - gamma') + p beta'.
TEST(GrahamVariator, HasTheConditionsOfNoSlipAtAAndE) {
  for (const double d : settings) {
    for (int i = 0; i < 6; ++i) {
      const auto s = some_state(i);
      const Vector3d x0 = Vector3d::UnitX(), y1(0, std::cos(s.q.alpha), std::sin(s.q.alpha)), z1 = x0.cross(y1);
      const Vector3d x2 = std::cos(delta) * x0 + std::sin(delta) * y1, v = z1.cross(x2);
      const Vector3d omega2 = s.v.alpha * x0 + s.v.beta * x2, C = c * y1;
      const Vector3d CA = -d * x2 + d * std::tan(delta) * v, CE = -l * x2 + p * v;
      const Vector3d at_A = s.v.alpha * x0.cross(C) + omega2.cross(CA);
      const Vector3d at_E = s.v.alpha * x0.cross(C) + omega2.cross(CE) - s.v.gamma * x0.cross(C + CE);
      EXPECT_NEAR((C + CA).dot(y1), c, 1e-16);  // the generatrix is parallel to x0
      EXPECT_NEAR((C + CE).dot(y1), r3, 1e-16);
      Variator::Constraints slip{};
      Variator::constraints(Variator::precompute(setting(d)), s, slip);
      EXPECT_NEAR((at_A - slip.rate[A_z1] * z1).norm(), 0.0, 1e-14);
      EXPECT_NEAR((at_E - slip.rate[E_z1] * z1).norm(), 0.0, 1e-14);
      EXPECT_NEAR(slip.rate[A_z1], c * s.v.alpha + d * std::tan(delta) * s.v.beta, 1e-14);
      EXPECT_NEAR(slip.rate[E_z1], r3 * (s.v.alpha - s.v.gamma) + p * s.v.beta, 1e-14);
      // Along x1 nothing can slip.
      EXPECT_EQ(slip.rate[A_z1 - 1], 0.0);
      EXPECT_EQ(slip.rate[E_z1 - 1], 0.0);
    }
  }
}

// Question 2: omega3/omega1 = 1 - c p/(r3 d tan(delta)), which goes through zero at some d: S3 stands still, then
// turns backwards.
TEST(GrahamVariator, HasTheRatioThatItsRingSets) {
  for (const double d : settings) {
    const auto start = Variator::initial_state(setting(d));
    EXPECT_NEAR(start.v.gamma / start.v.alpha, 1 - c * p / (r3 * d * std::tan(delta)), 1e-15);
    Variator::Constraints slip{};
    Variator::constraints(Variator::precompute(setting(d)), start, slip);
    for (const double rate : slip.rate) EXPECT_NEAR(rate, 0.0, 1e-14);
  }
  EXPECT_LT(gamma_ratio(0.05), 0.0);
  EXPECT_GT(gamma_ratio(0.08), 0.0);
  EXPECT_NEAR(gamma_ratio(c * p / (r3 * std::tan(delta))), 0.0, 1e-15);
}

// Questions 3 and 4: the moment about (O, x0) of S3 alone and of S1 with S2, and that about (C, x2) of S2 alone, hold
// no reaction of a hinge: with T_A and T_E the forces along z1 on S2 and G2 at r_G from (O, x0),
//   A3 gamma'' = C3 - r3 T_E,   A2 (beta'' + alpha'' cos(delta)) = d tan(delta) T_A + p T_E,
//   (A1 + m2 r_G² + B2 sin²(delta)) alpha'' + A2 cos(delta) (beta'' + alpha'' cos(delta))
//     = C1 + c T_A + r3 T_E + m2 g r_G sin(alpha).
TEST(GrahamVariator, MovesAsEulersTheoremsSay) {
  for (const double d : settings) {
    const auto law = [](const Variator::State& s) { return Variator::Inputs{2.0 - s.q.alpha, -0.7}; };
    const auto motion = equations_of_motion<Variator>(setting(d), law);
    for (int i = 0; i < 6; ++i) {
      const auto s = some_state(i);
      const auto inputs = law(s);
      Variator::Accelerations a{};
      Variator::Multipliers force{};
      ASSERT_EQ(motion.accelerations(s, a, force), Evaluation::ok);
      const double own = A2 * (a.beta + a.alpha * std::cos(delta));
      // Moments of some 3 N m, solved with a condition of some 100.
      constexpr double tolerance = 3 * 100 * 10 * 1.1e-16;
      EXPECT_NEAR(A3 * a.gamma, inputs.C3 - r3 * force.T_E, tolerance);
      EXPECT_NEAR(own, d * std::tan(delta) * force.T_A + p * force.T_E, tolerance);
      EXPECT_NEAR((A1 + m2 * r_G * r_G + B2 * std::pow(std::sin(delta), 2)) * a.alpha + std::cos(delta) * own,
                  inputs.C1 + c * force.T_A + r3 * force.T_E + m2 * g * r_G * std::sin(s.q.alpha), tolerance);
      // And rolling goes on.
      EXPECT_NEAR(c * a.alpha + d * std::tan(delta) * a.beta, 0.0, 1e-11);
      EXPECT_NEAR(r3 * (a.alpha - a.gamma) + p * a.beta, 0.0, 1e-11);
    }
  }
}

// The equation of motion that is left: I alpha'' = C1 + (omega3/omega1) C3 + m2 g r_G sin(alpha), integrated here by
// itself.
TEST(GrahamVariator, MovesWithOneFreedom) {
  for (const double d : settings) {
    const double beta = beta_ratio(d), gamma = gamma_ratio(d);
    const double inertia = A1 + m2 * r_G * r_G + A2 * std::pow(std::cos(delta) + beta, 2) +
                           B2 * std::pow(std::sin(delta), 2) + A3 * gamma * gamma;
    const auto alone = [&](double, const std::array<double, 2>& y, std::array<double, 2>& rates) {
      rates = {y[1], (0.5 - gamma * 0.3 + m2 * g * r_G * std::sin(y[0])) / inertia};
      return Evaluation::ok;
    };
    std::array<double, 2> y{0.0, 20.0};
    ASSERT_TRUE(integrate(alone, y, 0.0, 1.0, precise));
    const auto law = [](const Variator::State&) { return Variator::Inputs{0.5, -0.3}; };
    const auto motion = equations_of_motion<Variator>(setting(d), law);
    const State end =
        examples::state_at(motion, pack<Variator>(Variator::initial_state(setting(d))), 0.0, 1.0, precise);
    const auto s = unpack<Variator>(1.0, end);
    // A thousand steps of 1e-13 of coordinates up to 100.
    EXPECT_NEAR(s.q.alpha, y[0], 1e-9);
    EXPECT_NEAR(s.v.alpha, y[1], 1e-9);
    EXPECT_NEAR(s.q.beta, beta * y[0], 1e-9 * std::abs(beta));
    EXPECT_NEAR(s.q.gamma, gamma * y[0], 1e-9);
  }
}

TEST(GrahamVariator, MeetsItsCommittedReference) {
  // A hundred steps of 1e-13 of rates up to 100.
  examples::expect_reference(equations_of_motion<Variator>(), "graham_variator",
                             {.error = 1e-10, .least_amplification = 1.0, .tolerance = 1e-13});
}

TEST(GrahamVariator, ObeysTheEnergyTheorem) {
  const auto law = [](const Variator::State& s) { return Variator::Inputs{std::cos(5 * s.time), -0.4}; };
  const auto motion = equations_of_motion<Variator>(Variator::default_parameters(), law);
  const auto balance = examples::energy_balance<Variator>(
      motion, 1.0, 1e-12,
      [&](const Variator::State& s, const Variator::Accelerations&, const Variator::Multipliers& T) {
        Variator::Constraints slip{};  // what truncation leaves
        Variator::constraints(motion.precomputed(), s, slip);
        return T.T_A * slip.rate[A_z1] + T.T_E * slip.rate[E_z1];
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 0.1);
}

}  // namespace
}  // namespace torsor::graham_variator_test
