// SPDX-License-Identifier: GPL-3.0-or-later
// Two rods of length and mass 1 in a chain that falls on a rough floor: its joint, the end of the first and the end of the
// second touch. Where it lies flat, three rows of friction are one, and reactions are not unique.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/told_motion.hpp"

namespace chain_on_floor_test {
namespace {

using namespace told_motion;
using Chain = ByHand<4, 4, 3>;

// q = place (x, z) of the joint, angles of the rods above the horizontal.
Chain chain(double f, double static_friction, double e) {
  const ContactRule end{.tangents = 1, .friction = f, .static_friction = static_friction, .restitution = e};
  return {{end, end, end}, [](double, const auto& y, ContactReading& r) {
            r.M.setZero();
            r.M(0, 0) = r.M(1, 1) = 2;
            r.F << 0, -2 * g, 0, 0;
            r.J.setZero();
            r.drift.setZero();
            for (int i = 0; i < 3; ++i) {
              r.J(2 * i, 1) = r.J(2 * i + 1, 0) = 1;
              r.gap[static_cast<std::size_t>(i)] = y[1];
              r.w(2 * i) = y[5];
              r.w(2 * i + 1) = y[4];
            }
            for (int k = 0; k < 2; ++k) {
              const auto rod = static_cast<std::size_t>(k);
              const double turning = y[6 + rod], c = std::cos(y[2 + rod]), s = std::sin(y[2 + rod]);
              r.M(0, 2 + k) = r.M(2 + k, 0) = -s / 2;
              r.M(1, 2 + k) = r.M(2 + k, 1) = c / 2;
              r.M(2 + k, 2 + k) = 1.0 / 3;
              r.F(0) += c * turning * turning / 2;
              r.F(1) += s * turning * turning / 2;
              r.F(2 + k) -= g * c / 2;
              const int n = 2 * (k + 1), t = n + 1;
              r.gap[rod + 1] += s;
              r.J(n, 2 + k) = c;
              r.J(t, 2 + k) = -s;
              r.w(n) += c * turning;
              r.w(t) -= s * turning;
              r.drift(n) = -s * turning * turning;
              r.drift(t) = -c * turning * turning;
            }
          }};
}
constexpr std::array<double, 8> thrown{0, 1.2, 0.3, 2.5, 0.5, 0, 1, -2};

// When the second rod bounces alone, the rest of the chain lies still, and it is a pendulum with a = 3 g/2. A flight that begins
// at w rises to sin θ = m = w²/(2 a), and lasts (2 w/a) (1 + 4 m²/15) but for parts m⁴: with energy, and s = m (1 - u²), it is
// (2 w/a) ∫ du/sqrt(1 - m² (1 - u²)²) from 0 to 1.
TEST(ChainOnFloor, BouncesOfItsLastRodEndWhereTheirSumSays) {
  constexpr double e = 0.4, a = 1.5 * g;
  std::array<double, 8> y = thrown;
  const Motion motion = move(chain(0.3, 0.39, e), y, 2);
  const auto impacts = motion.all(ContactEventKind::impact);
  const auto alone = std::find_if(impacts.begin(), impacts.end(), [](const Told& told) {
    const auto& state = told.state;
    return state[7] > 0.1 && state[7] < 0.2 && std::abs(state[4]) + std::abs(state[5]) + std::abs(state[6]) < 1e-12;
  });
  ASSERT_NE(alone, impacts.end());
  double end = alone->time;
  for (double w = alone->state[7]; w > 1e-18; w *= e) {
    const double m = w * w / (2 * a);
    end += 2 * w / a * (1 + 4 * m * m / 15);
  }
  ASSERT_FALSE(motion.all(ContactEventKind::accumulation).empty());
  EXPECT_NEAR(motion.all(ContactEventKind::accumulation).back().time, end, 1e-12);
  for (std::size_t i = 1; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-14) << i;
}

// Each of the three impacts falls within a step, and changes the velocity along the floor by less than 1 m/s: the place at the
// end is off by less than 3 h, and by less than h more for the smooth pieces between.
TEST(ChainOnFloor, LiesWhereStepsTendTo) {
  for (const double f : {0.3, 0.8}) {
    std::array<double, 8> exact = thrown;
    move(chain(f, f, 0), exact, 2);
    for (const long steps : {1000L, 4000L, 16000L}) {
      std::array<double, 8> y = thrown;
      ASSERT_EQ(step_contacts(chain(f, f, 0), y, 0, 2, {.count = steps}), ContactStatus::reached_end);
      EXPECT_NEAR(y[0], exact[0], 4 * 2.0 / static_cast<double>(steps)) << steps;
    }
  }
}

// The problem of a step in which sweeps settle nowhere. To go on from it takes no more than to try all regimes.
TEST(ChainOnFloor, GoesOnWhereSweepsCircle) {
  const std::array<double, 8> y{0.568587, -3.42114e-49, 3.85186e-33, 1.08387e-07, -1.55915e-07, -0.0249449, 0.0321966, 0.0366329};
  const Chain scene = chain(0.3, 0.3, 0.4);
  ContactReading reading({4, 4, 3, 0}, 6);
  ASSERT_EQ(scene.read(0, y, reading), Evaluation::ok);
  const Eigen::MatrixXd inverse = reading.M.inverse();
  ContactProblem problem;
  problem.count = 3;
  for (std::size_t i = 0; i < 3; ++i) problem.laws[i] = scene.rules[i].law();
  problem.W = reading.J * inverse * reading.J.transpose();
  problem.q = reading.w + 1e-3 * (reading.J * (inverse * reading.F));
  for (int i = 0; i < 3; ++i) problem.q(2 * i) += 0.4 * std::min(0.0, reading.w(2 * i));
  const ContactVector none = ContactVector::Zero(6);
  EXPECT_FALSE(iterate_contacts(problem, none));
  const ContactAnswer found = go_on_contacts(problem, none), all = solve_contacts(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found.best().r, all.best().r);
  EXPECT_LE(found.best().residual, 1e-13);
}

}  // namespace
}  // namespace chain_on_floor_test
