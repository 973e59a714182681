// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/loading_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/motion.hpp"

#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::loading_robot_test {
namespace {

using namespace torsor::runtime;
using Robot = loading_robot::Mechanism<double>;

// The values of the scene.
constexpr double h = 0.5, L1 = 0.3, L2 = 0.4, L3 = 0.2, m1 = 60.0, m2 = 25.0, m3 = 8.0, I1 = 30.0, I2 = 6.0, I3 = 0.5,
                 g = 9.81;

struct Efforts {
  double C01, F12, C23, Y12;
};

// By the theorems of Newton and Euler, in the plane, with complex numbers for the vectors of the plane: x1 is the
// factor e^{i alpha}, y1 is i e^{i alpha}; J a + w . velocity terms follow from differentiating positions twice.
//
// Positions seen from Oo along x1, y1, so that p = (u + i v) e^{i alpha}:
//   G1 = L1 + i h,   G2 = x + L2 + i h,   O2 = x + i h,   G3 = O2 - L3 e^{i beta}.
// With w = alpha', a point c(t) e^{i alpha} has the acceleration (c'' + 2 i w c' + (i w' - w^2) c) e^{i alpha}, whose
// components along x1 and y1 are the real and imaginary part of the bracket:
//   G2: c' = x', c'' = x'':
//       a2x = x'' - w' h - w^2 (x + L2),                 a2y = 2 w x' + w' (x + L2) - w^2 h
//   O2: aOx = x'' - w' h - w^2 x,                        aOy = 2 w x' + w' x - w^2 h
//   G3 = O2 - L3 x3, and x3 turns at W = alpha' + beta': a3 = aO - L3 (W' y3 - W^2 x3), so with
//   x3 = (cos b, sin b), y3 = (-sin b, cos b) in x1, y1:
//       a3x = aOx + L3 (W' sin b + W^2 cos b),           a3y = aOy - L3 (W' cos b - W^2 sin b).
// Gravity is -g y0 with y0 = sin(alpha) x1 + cos(alpha) y1; a - g_vector adds g sin(alpha) to every x component and
// g cos(alpha) to every y component: call the sums "loads".
//
// S3 alone, moments about O2, which moves: d/dt of the moment of momentum about G3 + O2G3 ^ m3 a3 = C23 - moment of
// weight. With IG3 = I3 - m3 L3^2 and O2G3 = -L3 (cos b, sin b):
//   C23 = IG3 W' + m3 (-L3) (cos b load3y - sin b load3x).
// S2 and S3, along x1 (S1 gives no force along x1 but the motor's, the slide being ideal) and along y1:
//   F12 = m2 load2x + m3 load3x,     Y12 = m2 load2y + m3 load3y.
// The whole robot, moments about the fixed Oo, where only C01 and the weights have one:
//   S1: I1 w' + m1 g times the horizontal arm of G1, L1 cos(alpha) - h sin(alpha);
//   S2: IG2 w' + (OoG2 ^ m2 load2),  IG2 = I2 - m2 L2^2;   S3: IG3 W' + (OoG3 ^ m3 load3).
Efforts by_newton_and_euler(const Robot::State& s, const Robot::Accelerations& a) {
  const double w = s.v.alpha, dw = a.alpha, W = w + s.v.beta, dW = dw + a.beta;
  const double x = s.q.x, dx = s.v.x, ddx = a.x;
  const double sine = std::sin(s.q.beta), cosine = std::cos(s.q.beta);
  const double gx = g * std::sin(s.q.alpha), gy = g * std::cos(s.q.alpha);
  const double aOx = ddx - dw * h - w * w * x, aOy = 2.0 * w * dx + dw * x - w * w * h;
  const double load2x = aOx - w * w * L2 + gx, load2y = aOy + dw * L2 + gy;
  const double load3x = aOx + L3 * (dW * sine + W * W * cosine) + gx;
  const double load3y = aOy - L3 * (dW * cosine - W * W * sine) + gy;
  const double IG2 = I2 - m2 * L2 * L2, IG3 = I3 - m3 * L3 * L3;
  Efforts efforts{};
  efforts.C23 = IG3 * dW - m3 * L3 * (cosine * load3y - sine * load3x);
  efforts.F12 = m2 * load2x + m3 * load3x;
  efforts.Y12 = m2 * load2y + m3 * load3y;
  const double G3x = x - L3 * cosine, G3y = h - L3 * sine;
  efforts.C01 = I1 * dw + m1 * (L1 * gy - h * gx) + IG2 * dw + m2 * ((x + L2) * load2y - h * load2x) + IG3 * dW +
                m3 * (G3x * load3y - G3y * load3x);
  return efforts;
}

auto samples() { return examples::random_samples<Robot>(20); }

// Loads up to 60 m/s^2 on 93 kg with arms up to 3 m: terms below 2e4, of which some twenty roundings remain.
constexpr double tolerance = 20 * 2e4 * 1.1e-16;

TEST(LoadingRobot, HasTheMotorActionsOfNewtonAndEuler) {
  const auto precomputed = Robot::precompute({});
  for (const auto& [state, a] : samples()) {
    const Efforts expected = by_newton_and_euler(state, a);
    Robot::GeneralizedForces forces{};
    Robot::inverse_dynamics(precomputed, state, a, {}, forces);
    EXPECT_NEAR(forces.alpha, expected.C01, tolerance);
    EXPECT_NEAR(forces.x, expected.F12, tolerance);
    EXPECT_NEAR(forces.beta, expected.C23, tolerance);
  }
}

TEST(LoadingRobot, HasTheReactionAcrossTheSlide) {
  const auto precomputed = Robot::precompute({});
  for (const auto& [state, a] : samples()) {
    Robot::Reactions reactions{};
    // The motors act along other directions: whatever they do, Y12 follows from the motion.
    Robot::reactions(precomputed, state, a, {}, {3.0, -5.0, 7.0}, reactions);
    EXPECT_NEAR(reactions.Y12, by_newton_and_euler(state, a).Y12, tolerance);
  }
}

/// The unknowns of joints that enter one of the six equations.
std::vector<std::string> entering(const torsor::IsolationReport& report, std::size_t equation) {
  std::vector<std::string> names;
  for (const auto& unknown : report.unknowns) {
    if (unknown.enters[equation]) names.push_back(unknown.name);
  }
  return names;
}

// Question 2: which theorem gives which unknown. An equation that no unknown of a joint enters gives the motor that
// works with it when the motion is known.
TEST(LoadingRobot, FindsEachUnknownByOneEquationOfTheGeneralTheorems) {
  using Names = std::vector<std::string>;
  constexpr std::size_t resultant_x = 0, resultant_y = 1, moment_z = 5;
  const torsor::Equations equations(loading_robot_scene());
  const auto slide = torsor::isolation_report(equations, {"S2", "S3"}, {Scene::point("O2"), "S1"});
  EXPECT_EQ(slide.text,
            "Newton-Euler for S2, S3 at O2 along the axes of S1\n"
            "  joint S2: Y, Z, L, M, N\n"
            "  resultant, x: no unknown component, an equation of motion\n"
            "  resultant, y: S2 Y\n"
            "  resultant, z: S2 Z\n"
            "  moment, x: S2 L\n"
            "  moment, y: S2 M\n"
            "  moment, z: S2 N\n");
  EXPECT_EQ(entering(slide, resultant_x), Names{});                                                   // F12
  EXPECT_EQ(entering(slide, resultant_y), Names{"S2 Y"});                                             // Y12
  EXPECT_EQ(entering(torsor::isolation_report(equations, {"S3"}, {Scene::point("O2"), "S1"}), moment_z), Names{});  // C23
  EXPECT_EQ(entering(torsor::isolation_report(equations, {"S1", "S2", "S3"}, {Scene::point("Oo"), "ground"}), moment_z),
            Names{});  // C01
  // S1 and S2 taken alone, or another point, bring reactions in.
  EXPECT_EQ(entering(torsor::isolation_report(equations, {"S2"}, {Scene::point("O2"), "S1"}), resultant_x), (Names{"S3 X", "S3 Y"}));
  EXPECT_EQ(entering(torsor::isolation_report(equations, {"S3"}, {Scene::point("Oo"), "ground"}), moment_z), (Names{"S3 X", "S3 Y"}));
}

// The formulas of the page for F12, Y12 and C23.
TEST(LoadingRobot, MeetsTheFormulasOfItsPage) {
  const auto precomputed = Robot::precompute({});
  for (const auto& [s, a] : samples()) {
    const double sine = std::sin(s.q.beta), cosine = std::cos(s.q.beta);
    const double omega = s.v.alpha + s.v.beta, rate = a.alpha + a.beta, square = s.v.alpha * s.v.alpha;
    const double along = a.x - h * a.alpha - s.q.x * square + g * std::sin(s.q.alpha);
    const double across = 2 * s.v.x * s.v.alpha + s.q.x * a.alpha - h * square + g * std::cos(s.q.alpha);
    Robot::GeneralizedForces forces{};
    Robot::inverse_dynamics(precomputed, s, a, {}, forces);
    Robot::Reactions reactions{};
    Robot::reactions(precomputed, s, a, {}, {}, reactions);
    EXPECT_NEAR(forces.x, (m2 + m3) * along - m2 * L2 * square + m3 * L3 * (rate * sine + omega * omega * cosine),
                tolerance);
    EXPECT_NEAR(reactions.Y12,
                (m2 + m3) * across + m2 * L2 * a.alpha - m3 * L3 * (rate * cosine - omega * omega * sine), tolerance);
    EXPECT_NEAR(forces.beta, I3 * rate - m3 * L3 * (across * cosine - along * sine), tolerance);
  }
}

// The same unknowns the other way round. The mass matrix has a condition number below 1e3 here.
TEST(LoadingRobot, MovesAsItsMotorsDemand) {
  const auto precomputed = Robot::precompute({});
  for (const auto& [state, a] : samples()) {
    const Efforts efforts = by_newton_and_euler(state, a);
    Robot::Accelerations found{};
    Robot::Multipliers none{};
    ASSERT_EQ(Robot::forward_dynamics(precomputed, state, {efforts.C01, efforts.F12, efforts.C23}, found, none),
              torsor::Status::ok);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], a[i], 1e3 * tolerance);
  }
}

// Roundings of a thousand steps a second, times what the flow amplifies.
TEST(LoadingRobot, MeetsItsCommittedReference) {
  examples::expect_reference(equations_of_motion<Robot>(), "loading_robot", {.error = 1e-13});
}

}  // namespace
}  // namespace torsor::loading_robot_test
