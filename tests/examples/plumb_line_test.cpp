// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/plumb_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"

namespace torsor::plumb_line_test {
namespace {

using namespace torsor::runtime;
using Plumb = plumb_line::Mechanism<double>;

// The values of the scene and of the course.
constexpr double K = 6.67e-11, earth = 5.9742e24, m = 1.0, l = 1.0, pi = std::numbers::pi, rounding = 1.1e-16;
constexpr double omega = 2.0 * pi / 86400.0, radius = 6371000.0;

/// Apparent gravity at r n, latitude alpha, as the course derives it: components along n (upwards) and t (northwards).
struct Gravity {
  double normal, tangential;
};
Gravity apparent_gravity(double r, double latitude) {
  return {-K * earth / (r * r) + r * omega * omega * std::pow(std::cos(latitude), 2),
          -r * omega * omega * std::cos(latitude) * std::sin(latitude)};
}

struct Rest {
  Plumb::State state{};
  Plumb::Linearisation linear{};
  double tension = 0.0;
};

/// The plumb line at rest, by Newton's method on the generated equations.
Rest rest(double r, double latitude) {
  Rest at;
  const auto place = Plumb::precompute({.r = r, .latitude = latitude});
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(Plumb::linearisation(place, at.state, {}, {}, {}, at.linear), torsor::Status::ok);
    at.state.q.delta += at.linear.F[0] / at.linear.K[0];
  }
  Plumb::Reactions reactions{};
  Plumb::reactions(place, at.state, {}, {}, {}, reactions);
  at.tension = reactions.tension;
  return at;
}

// The bob is at r n but for l (1 - cos(delta)) and l sin(delta), below 10 mm of 6371 km: 2e-9 of g at most. Its tension
// is m g, its direction that of -g.
TEST(PlumbLine, ShowsTheApparentGravityOfTheCourse) {
  for (const double altitude : {0.0, 5e5, 5e6}) {
    for (const double latitude : {-1.2, -0.5, 0.0, 0.3, pi / 4.0, 1.5}) {
      const Rest at = rest(radius + altitude, latitude);
      const Gravity g = apparent_gravity(radius + altitude, latitude);
      const double allowed = 2e-9 * std::abs(g.normal);
      EXPECT_NEAR(-at.tension * std::cos(at.state.q.delta) / m, g.normal, allowed);
      EXPECT_NEAR(at.tension * std::sin(at.state.q.delta) / m, g.tangential, allowed);
      EXPECT_EQ(at.state.q.epsilon, 0.0);
    }
  }
}

// Exactly where the bob is, in axes that turn with the earth: T = m (Gamma(G) - attraction). Numbers of 10 N, ten
// roundings; sines of 1e-3 rad, and 6371 km rounded to 1 nm, leave 2e-16 of them.
TEST(PlumbLine, BalancesAttractionAndCentripetalForceExactly) {
  for (const double latitude : {-0.5, 0.3, pi / 4.0}) {
    const Rest at = rest(radius, latitude);
    Plumb::Kinematics where{};
    Plumb::kinematics(Plumb::precompute({.r = radius, .latitude = latitude}), at.state, where);
    const auto& G = where.G_position;
    const double distance = std::hypot(G[0], G[1], G[2]), pull = K * earth * m / std::pow(distance, 3);
    const double up = latitude - at.state.q.delta;  // of the thread, in the meridian plane; it points to the south of n
    EXPECT_NEAR(at.tension * std::cos(up), pull * G[0] - m * omega * omega * G[0], 20 * 10 * rounding);
    EXPECT_NEAR(at.tension * std::sin(up), pull * G[2], 20 * 10 * rounding);
    EXPECT_EQ(G[1], 0.0);
  }
}

// The course: the tangential part stays below 1 % of the normal one up to 5000 km (here: of altitude, at any latitude).
TEST(PlumbLine, LeansByLessThanOnePerCentUpTo5000Kilometres) {
  const auto worst = [](double altitude) {
    double ratio = 0.0;
    for (int i = 0; i <= 900; ++i)
      ratio = std::fmax(ratio, std::abs(std::tan(rest(radius + altitude, i * pi / 1800.0).state.q.delta)));
    return ratio;
  };
  const double on_ground = worst(0.0), at_5000_km = worst(5e6), at_5100_km = worst(5.1e6);
  EXPECT_NEAR(on_ground, 1.72e-3, 0.01e-3);
  EXPECT_LT(at_5000_km, 0.01);
  EXPECT_GT(at_5000_km, 0.0098);
  EXPECT_GT(at_5100_km, 0.01);  // the claim is sharp
}

// Foucault: the swings' plane turns at omega sin(latitude). Small motions about the rest, gyroscopic with
// 2 m l² omega sin(up) between delta and epsilon, up the direction of the thread, K the same for both but for omega².
TEST(PlumbLine, TurnsThePlaneOfItsSwings) {
  for (const double latitude : {-0.5, 0.3, pi / 4.0, 1.5}) {
    const Rest at = rest(radius, latitude);
    const auto& C = at.linear.C;  // column by column
    const double up = latitude - at.state.q.delta;
    const double gyroscopic = 2.0 * m * l * l * omega * std::sin(up);
    EXPECT_NEAR(C[0], 0.0, 1e-20);
    EXPECT_NEAR(C[3], 0.0, 1e-20);
    EXPECT_NEAR(std::abs(C[1]), std::abs(gyroscopic), 20 * 1e-4 * rounding);
    EXPECT_NEAR(C[1], -C[2], 20 * 1e-4 * rounding);
    EXPECT_NEAR(at.linear.K[0] / at.linear.K[3], 1.0, 1e-6);
  }
}

// What turns the earth works on the bob through the thread: tension times the velocity of its upper end,
// omega (r + l) cos(latitude) to the east. The thread's direction there, n cos(delta) cos(epsilon) + east sin(epsilon)
// - ...
TEST(PlumbLine, ObeysTheEnergyTheoremWithThePowerOfTheTurningEarth) {
  const Plumb::Parameters parameters = Plumb::default_parameters();
  const auto motion = equations_of_motion<Plumb>(parameters);
  const auto balance = examples::energy_balance<Plumb>(
      motion, 10.0, 1e-13, [&](const Plumb::State& s, const Plumb::Accelerations& a, const Plumb::Multipliers&) {
        Plumb::Reactions reactions{};
        Plumb::reactions(motion.precomputed(), s, a, {}, {}, reactions);
        const double speed = omega * (parameters.r + l) * std::cos(parameters.latitude);
        return reactions.tension * std::sin(s.q.epsilon) * speed;
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-5);
  EXPECT_GT(balance.work, 1e-4);
}

}  // namespace
}  // namespace torsor::plumb_line_test
