// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "generated/rolling_hoop.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "torsor/runtime/small_motions/steady_states.hpp"

namespace torsor::statics_test {

// Steady motions of generated mechanisms, found without being told the answer.
namespace {

using namespace torsor::runtime;
using Disc = rolling_hoop::Mechanism<double>;

constexpr double pi = std::numbers::pi;

struct Circle {
  double lean, turn, roll;
};
// Published steady circles of a disc r = 1 (lean from the vertical): Omega and the rate of roll it needs.
constexpr std::array<Circle, 3> circles{{{0.3, 1.0, 2.269325911331385589971987},
                                         {0.2, 0.5, 2.734226152284711588284788},
                                         {0.35, 3.0, 1.653006637368953910106479}}};

// Coordinates x, y, psi, theta, phi. Given lean and turn, the rolling rate, the velocity and the acceleration of the
// centre and both forces of contact are unknown: seven, for five equations of motion and the two conditions of rolling
// with their derivatives.
TEST(RollingDisc, FindsItsSteadyCircles) {
  Disc::Parameters parameters = Disc::default_parameters();
  parameters.A = 0.25;
  parameters.C = 0.5;
  const Disc::Precomputed precomputed = Disc::precompute(parameters);
  for (const Circle& circle : circles) {
    StateProblem<Disc> problem;
    problem.state.q.theta = pi / 2 - circle.lean;
    problem.state.v.psi = circle.turn;
    problem.velocities = {0, 1, 4};
    problem.accelerations_unknown = {0, 1};
    problem.lower = Eigen::VectorXd::Constant(5, -10.0);
    problem.upper = Eigen::VectorXd::Constant(5, 10.0);
    problem.options.starts = 20;
    const auto search = find_states<Disc>(precomputed, problem);
    ASSERT_EQ(search.found.size(), 1U);
    const auto& s = search.found[0];
    EXPECT_TRUE(s.isolated);
    EXPECT_NEAR(std::abs(s.state.v.phi), circle.roll, 1e-10);
    // The centre keeps to its own circle of the radius of the contact's less r sin(lean), and is drawn inwards.
    const double speed = std::hypot(s.state.v.x, s.state.v.y);
    const double radius = circle.roll / circle.turn - std::sin(circle.lean);
    EXPECT_NEAR(speed, std::abs(circle.turn * radius), 1e-10);
    EXPECT_NEAR(std::hypot(s.accelerations.x, s.accelerations.y), speed * circle.turn, 1e-9);
  }
}

}  // namespace
}  // namespace torsor::statics_test
