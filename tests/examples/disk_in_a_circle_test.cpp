// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/disk_in_a_circle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/events/contact_regime.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::disk_in_a_circle_test {
namespace {

using namespace torsor::runtime;
using Disk = disk_in_a_circle::Mechanism<double>;
using State = StateVector<Disk>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
constexpr double g = 9.81, m = 1.0, rounding = 1.1e-16;

/// Euler's theorem by hand for a disk whose axis goes round a cone. Along e_r outwards, e_t the way it goes, z up:
/// GI = -h z + d e_r, the axis k = (h e_r + d z)/rho, u = -GI/rho; the angular velocity is w z + s k and no slip says
/// w (R + d) + s rho = 0. The momentum about G, C (w·k) k + A (w·u) u, is carried round: its rate is w z ∧ it = M e_t.
/// The reaction N z + F e_r has N = m g, F = -m R w², and the moment -(h F + d N) e_t.
struct Circle {
  double rho, R, h;
  double d() const { return std::sqrt(rho * rho - h * h); }
  /// Σ moments - rate of the momentum at the rate w, along e_t, for unit mass.
  double imbalance(double w) const {
    const double A = rho * rho / 4, C = rho * rho / 2, s = -w * (R + d()) / rho;
    const double along_k = C * (w * d() / rho + s), along_u = A * w * h / rho;
    const double rate = w * (along_k * h / rho - along_u * d() / rho);  // z ∧ k = h/rho e_t, z ∧ u = -d/rho e_t
    return h * R * w * w - d() * g - rate;
  }
  /// It is a + b w².
  double turning() const { return std::sqrt(imbalance(0.0) / (imbalance(0.0) - imbalance(1.0))); }
};

Disk::State state_on(const Circle& circle, double w) {
  Disk::State s{};
  s.q = {0.0, -circle.R, circle.h, 0.0, std::asin(circle.h / circle.rho), 0.0};
  s.v = {circle.R * w, 0.0, 0.0, w, 0.0, -w * (circle.R + circle.d()) / circle.rho};
  return s;
}

constexpr std::array<Circle, 4> circles{{{2, 10, 1}, {2, 10, 1.9}, {2, 100, 1.9}, {0.3, 2, 0.25}}};

// Question 1: V_G = R sqrt(4 g d/(h (6 R + d))); 10.49 m/s for rho = 2, R = 10, h = 1.
TEST(DiskInACircle, GoesRoundAtTheSpeedOfEulersTheorem) {
  for (const Circle& circle : circles) {
    const double w = circle.turning(), d = circle.d();
    EXPECT_NEAR(w, std::sqrt(4 * g * d / (circle.h * (6 * circle.R + d))), 20 * rounding * w);
    Disk::Accelerations a{};
    Disk::Multipliers reaction{};
    const auto precomputed = Disk::precompute({circle.rho});
    ASSERT_EQ(Disk::forward_dynamics(precomputed, state_on(circle, w), {}, a, reaction), torsor::Status::ok);
    // Accelerations of some 100, solved with a condition below 1e4 (radii of 100 m beside angles): 1e4 roundings.
    EXPECT_NEAR(a.theta, 0.0, 1e-10);
    EXPECT_NEAR(a.psi, 0.0, 1e-10);
    EXPECT_NEAR(a.phi, 0.0, 1e-10);
    EXPECT_NEAR(a.x, 0.0, 1e-10);
    EXPECT_NEAR(a.y, circle.R * w * w, 1e-10);  // towards the centre, from (0, -R)
    // At another rate the disk falls or rises.
    ASSERT_EQ(Disk::forward_dynamics(precomputed, state_on(circle, 1.01 * w), {}, a, reaction), torsor::Status::ok);
    EXPECT_GT(a.theta, 1e-3);
    ASSERT_EQ(Disk::forward_dynamics(precomputed, state_on(circle, 0.99 * w), {}, a, reaction), torsor::Status::ok);
    EXPECT_LT(a.theta, -1e-3);
  }
}

// Question 2: f_min = |T|/N = R w²/g = 4 R d/(h (6 R + d)), from the reaction computed; question 3: 1.1223.
TEST(DiskInACircle, NeedsTheFrictionOfTheReactionComputed) {
  for (const Circle& circle : circles) {
    const double w = circle.turning();
    Disk::Accelerations a{};
    Disk::Multipliers reaction{};
    ASSERT_EQ(Disk::forward_dynamics(Disk::precompute({circle.rho}), state_on(circle, w), {}, a, reaction),
              torsor::Status::ok);
    EXPECT_NEAR(reaction.N, m * g, 1e-10);
    EXPECT_NEAR(reaction.X, 0.0, 1e-10);
    EXPECT_NEAR(reaction.Y, m * circle.R * w * w, 1e-10);
    const double d = circle.d(), needed = 4 * circle.R * d / (circle.h * (6 * circle.R + d));
    EXPECT_NEAR(required_friction(reaction.N, tangential(reaction.X, reaction.Y)), needed, 1e-11);
  }
  const Circle exercise = circles[0];
  EXPECT_NEAR(exercise.R * exercise.turning(), 10.493, 5e-4);
  EXPECT_NEAR(exercise.R * std::pow(exercise.turning(), 2) / g, 1.1223, 5e-5);
}

// Steady: after 2 s the angles have turned at constant rates and G is where the circle says. 1e-13 a step, some hundred
// steps, times what the flow amplifies.
TEST(DiskInACircle, StaysOnItsCircle) {
  const auto motion = equations_of_motion<Disk>();
  const Circle circle = circles[0];
  const double w = circle.turning();
  const auto start = Disk::initial_state();
  const auto expected = pack<Disk>(state_on(circle, w));
  EXPECT_LE(examples::largest_difference(pack<Disk>(start), expected), 20 * 10 * rounding);
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (const double t : {0.5, 2.0}) {
    const State y = examples::state_at(motion, motion.initial(), 0.0, t, precise);
    const double allowed = 1e-12 * growth.until(t);
    EXPECT_LT(allowed, 1e-8);
    const auto s = unpack<Disk>(t, y);
    EXPECT_NEAR(s.q.x, circle.R * std::sin(w * t), allowed);
    EXPECT_NEAR(s.q.y, -circle.R * std::cos(w * t), allowed);
    EXPECT_NEAR(s.q.z, circle.h, allowed);
    EXPECT_NEAR(s.q.theta, std::asin(circle.h / circle.rho), allowed);
    EXPECT_NEAR(s.q.psi, w * t, allowed);
    EXPECT_NEAR(s.q.phi, start.v.phi * t, allowed);
  }
}

// The committed reference is the steady motion too, here read in double.
TEST(DiskInACircle, HasACommittedReferenceOnTheCircle) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/disk_in_a_circle.reference.csv");
  const double w = circles[0].turning();
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const auto s = unpack<Disk>(0.0, reference.state<12>(row));
    const double t = reference.times[row];
    EXPECT_NEAR(s.q.x, 10 * std::sin(w * t), 40 * rounding * 10);
    EXPECT_NEAR(s.q.y, -10 * std::cos(w * t), 40 * rounding * 10);
    EXPECT_NEAR(s.q.z, 1.0, 4 * rounding);
  }
}

// The reaction works with what the point of contact may do beside its constraints by truncation alone.
TEST(DiskInACircle, ObeysTheEnergyTheoremOffItsCircle) {
  const auto motion = equations_of_motion<Disk>();
  const auto balance = examples::energy_balance<Disk>(
      motion, 2.0, 1e-12, [&](const Disk::State& s, const Disk::Accelerations&, const Disk::Multipliers& reaction) {
        Disk::Constraints c{};
        Disk::constraints(motion.precomputed(), s, c);
        return reaction.N * c.rate[0] + reaction.X * c.rate[1] + reaction.Y * c.rate[2];
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_LT(balance.work, 1e-8);
}

}  // namespace
}  // namespace torsor::disk_in_a_circle_test
