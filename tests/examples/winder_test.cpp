// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/winder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

#include "torsor/generator/dynamics/structure/mobility.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::winder_test {
namespace {

using namespace torsor::runtime;
using Winder = winder::Mechanism<double>;

// The values of the scene.
constexpr double m = 0.5, b = 0.2, a = 0.3, k = 400.0, g = 9.81, pi = std::numbers::pi, rounding = 1.1e-16;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

/// The motor's torque by the moment of momentum of Sigma and S about (O, w), whose rate it is alone: the thread pulls G
/// towards that axis, weight and the axis' force have no moment about it that is not internal.
double torque(const Winder::Parameters& p, double lambda, double rate, double acceleration) {
  const double sine = std::sin(p.slope);
  return m * (2.0 * p.omega * sine * sine * lambda * rate - b * sine * acceleration);
}

// Three bodies, the frame among them: a pivot, driven, and a cylindrical joint; nothing closes a loop.
TEST(Winder, HasTheJointsOfTheCourse) {
  const torsor::StructureGraph graph = torsor::structure_graph(winder_scene());
  EXPECT_EQ(graph.bodies.size(), 3U);
  ASSERT_EQ(graph.joints.size(), 2U);
  EXPECT_EQ(graph.joints[0].type, torsor::JointType::revolute);
  EXPECT_EQ(graph.joints[1].type, torsor::JointType::cylindrical);
  const torsor::MobilityCount count = torsor::analyse_mobility(winder_scene()).generic;
  EXPECT_EQ(count.parameters, 3);
  EXPECT_EQ(count.loops, 0);
  EXPECT_EQ(count.mobility, 3);
  EXPECT_EQ(count.redundancy, 0);
}

// The resultant theorem for S along z, where the axis gives no force: lambda'' = (k a - g) cos(slope) - (k - omega²
// sin²(slope)) lambda. The moment theorem at G along z, where it gives no moment: phi' + omega cos(slope) = constant.
// Accelerations of 300 m/s², thirty roundings.
TEST(Winder, MovesItsBobbinAsTheTwoEquationsFreeOfReactionsSay) {
  for (const double slope : {0.0, 0.4, pi / 3.0, pi / 2.0}) {
    for (const double omega : {0.0, 10.0, 25.0}) {
      const Winder::Parameters p{.omega = omega, .slope = slope};
      const auto motion = equations_of_motion<Winder>(p);
      for (int i = 0; i < 10; ++i) {
        Winder::State s{};
        s.time = 0.1 * i;
        s.q = {0.1 * i - 0.4, 0.3 * i};
        s.v = {1.0 - 0.3 * i, 4.0 - i};
        Winder::Accelerations found{};
        Winder::Multipliers none{};
        ASSERT_EQ(motion.accelerations(s, found, none), Evaluation::ok);
        const double sine = std::sin(slope), cosine = std::cos(slope);
        const double expected = (k * a - g) * cosine - (k - omega * omega * sine * sine) * s.q.lambda;
        EXPECT_NEAR(found.lambda, expected, 30 * 300 * rounding);
        EXPECT_NEAR(found.phi, 0.0, 30 * 300 * rounding);
        Winder::Reactions reactions{};
        Winder::reactions(motion.precomputed(), s, found, {}, {}, reactions);
        EXPECT_NEAR(reactions.motor, torque(p, s.q.lambda, s.v.lambda, found.lambda), 30 * 300 * rounding);
      }
    }
  }
}

// Below omega sin(slope) = sqrt(k) G oscillates about (k a - g) cos(slope) / (k - omega² sin²(slope)), above it leaves.
TEST(Winder, OscillatesInClosedForm) {
  const auto motion = equations_of_motion<Winder>();
  const double square = k - 100.0 * 0.75, centre = (k * a - g) * 0.5 / square, w = std::sqrt(square);
  auto y = motion.initial();
  double t = 0.0;
  for (const double end : {0.3, 1.0, 3.0}) {
    y = examples::state_at(motion, y, t, end, precise);
    t = end;
    // Errors of 1e-13 (1 + |y|), |y| below 15, at each of some 2000 steps, none of which grows by more than w.
    EXPECT_NEAR(y[0], centre + (0.05 - centre) * std::cos(w * t), 2e-10);
    EXPECT_NEAR(y[2], -(0.05 - centre) * w * std::sin(w * t), 2e-10 * w);
    EXPECT_NEAR(y[3], 5.0, 1e-12);
  }
  Winder::Linearisation linear{};
  const auto stiffness = [&linear](double omega) {
    const auto turned = Winder::precompute({.omega = omega, .slope = pi / 2.0});
    EXPECT_EQ(Winder::linearisation(turned, Winder::State{}, {}, {}, {}, linear), torsor::Status::ok);
    return linear.K[0];
  };
  EXPECT_GT(stiffness(19.99), 0.0);
  EXPECT_LT(stiffness(20.01), 0.0);
  EXPECT_NEAR(stiffness(10.0), m * 300.0, 30 * 200 * rounding);
}

TEST(Winder, ObeysTheEnergyTheoremWithTheMotorsPower) {
  const Winder::Parameters p = Winder::default_parameters();
  const auto balance = examples::energy_balance<Winder>(
      equations_of_motion<Winder>(), 3.0, 1e-12,
      [&p](const Winder::State& s, const Winder::Accelerations& acceleration, const Winder::Multipliers&) {
        return p.omega * torque(p, s.q.lambda, s.v.lambda, acceleration.lambda);
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 1.0);
}

}  // namespace
}  // namespace torsor::winder_test
