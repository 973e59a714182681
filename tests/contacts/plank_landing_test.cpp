// SPDX-License-Identifier: GPL-3.0-or-later
// A plank that falls flat on seven points, and bounces until it rests on all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/contacts/contact_solver.hpp"

namespace plank_landing_test {
namespace {

using namespace simple_systems;

using Places = std::array<double, 7>;
constexpr Places in_order{-1, -0.8, -0.35, 0, 0.2, 0.7, 1};
/// The middle one first: alone it would hold the plank.
constexpr Places middle_first{0, 1, -1, 0.7, -0.8, -0.35, 0.2};
constexpr Places others{0.2, -0.35, 1, 0, 0.7, -1, -0.8};
constexpr double f = 0.3;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

/// A thin plank of length 2 and mass 1 that touches at these places along it: q = (x, z, φ).
ByHand<3, 3, 7> plank(const Places& places, double e) {
  ByHand<3, 3, 7> system{{}, [places](double, const auto& y, auto& r) {
                           r.M.setIdentity();
                           r.M(2, 2) = 4.0 / 12;
                           r.F << 0, -g, 0;
                           const double c = std::cos(y[2]), s = std::sin(y[2]);
                           for (std::size_t i = 0; i < places.size(); ++i) {
                             const double x = places[i] * c, z = -places[i] * s;
                             const int n = 2 * static_cast<int>(i);
                             r.gap[i] = y[1] + z;
                             r.J.row(n) << 0, 1, -x;
                             r.J.row(n + 1) << 1, 0, z;
                             r.w(n) = y[4] - x * y[5];
                             r.w(n + 1) = y[3] + z * y[5];
                             r.drift(n) = -z * y[5] * y[5];
                             r.drift(n + 1) = -x * y[5] * y[5];
                           }
                         }};
  system.rules.fill({.tangents = 1, .friction = f, .restitution = e});
  return system;
}

/// Where it stops: each impact takes f (1 + e) w of its speed along the floor, and then the floor f g of it a second.
double stop_of(double speed, double height, double e) {
  double w = std::sqrt(2 * g * height), x = speed * w / g;
  for (; w > 1e-17; w *= e) {
    speed = std::max(0.0, speed - f * (1 + e) * w);
    x += speed * 2 * e * w / g;
  }
  return x + speed * speed / (2 * f * g);
}

// Once regimes alternated without end where the plank had landed with the middle point named first, until the limit of events.
TEST(PlankLanding, BouncesSlidesAndRestsInAnyOrderOfItsPoints) {
  for (const Places& places : {in_order, middle_first, others}) {
    for (const double speed : {0.0, 2.0}) {
      std::array<double, 6> y{0, 0.2, 0, speed, 0, 0};
      ContactOptions options;
      options.event_limit = 200;
      const ContactResult result = integrate_contacts(plank(places, 0.5), y, 0, 0.9, precise, options);
      ASSERT_TRUE(result) << describe(result.status) << ' ' << speed << ' ' << places[0];
      EXPECT_NEAR(y[0], stop_of(speed, 0.2, 0.5), 1e-11);
      EXPECT_NEAR(y[1], 0, 1e-16);
      EXPECT_NEAR(y[2], 0, 1e-16);
      for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(y[i], 0, 1e-15);
    }
  }
}

// Late on the clock a rounding of the time is a gap that is not zero: all points strike together, and none before the others.
TEST(PlankLanding, IsFlatHoweverLate) {
  for (const double start : {0.0, 1e5, 1e6, 1e7}) {
    for (const double height : {0.05, 0.5, 0.8, 1.3, 5.0}) {
      std::array<double, 6> y{0, height, 0, 0, 0, 0};
      const double end = start + 1.5 * std::sqrt(2 * height / g);
      const ContactResult result = integrate_contacts(plank(in_order, 0.3), y, start, end, precise);
      ASSERT_TRUE(result) << describe(result.status) << ' ' << start << ' ' << height;
      EXPECT_NEAR(y[5], 0, 1e-12) << start << ' ' << height;
    }
  }
}

// At rest each of the points may bear a part of the weight: the middle one alone, which sweeps find first, is no unique answer.
TEST(PlankLanding, RestsOnPointsWhoseReactionsAreIndeterminate) {
  for (const Places& places : {in_order, middle_first, others}) {
    const auto system = plank(places, 0);
    ContactReading reading({3, 3, 7, 0}, 14);
    ASSERT_EQ(system.read(0, {}, reading), Evaluation::ok);
    ContactProblem problem;
    problem.count = 7;
    for (std::size_t i = 0; i < 7; ++i) problem.laws[i] = system.rules[i].law();
    problem.W = reading.J * Eigen::Vector3d(1, 1, 3).asDiagonal() * reading.J.transpose();  // one over M
    problem.q = reading.J * reading.F;
    const ContactAnswer answer = solve_contacts(problem);
    EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
    double weight = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(answer.best().regimes[i], ContactRegime::sticks);
      weight += answer.best().r(2 * static_cast<int>(i));
    }
    EXPECT_NEAR(weight, g, 1e-14);
  }
}

// The same under a block of mass 1 that is pulled along it by 3 N: all together do not rest, but the plank does.
TEST(PlankLanding, RestsOnAllPointsUnderABlockThatSlides) {
  for (const Places& places : {in_order, middle_first, others}) {
    const auto system = plank(places, 0);
    ContactReading reading({3, 3, 7, 0}, 14);
    ASSERT_EQ(system.read(0, {}, reading), Evaluation::ok);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(16, 5);
    J.topLeftCorner(14, 3) = reading.J;
    J.row(14) << 0, -1, 0, 0, 1;
    J.row(15) << -1, 0, 0, 1, 0;
    Eigen::VectorXd inverse(5), forces(5);
    inverse << 1, 1, 3, 1, 1;
    forces << reading.F, 3, -g;
    ContactProblem problem;
    problem.count = 8;
    problem.laws.fill(coulomb(1, 0.5));
    problem.laws[7] = coulomb(1, 0.1);
    problem.W = J * inverse.asDiagonal() * J.transpose();
    problem.q = J * inverse.cwiseProduct(forces);
    for (const ContactAnswer& answer : {solve_contacts(problem), iterate_contacts(problem, ContactVector::Zero(16))}) {
      EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
      for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(answer.best().regimes[i], ContactRegime::sticks) << i;
        EXPECT_GT(answer.best().r(2 * static_cast<int>(i)), 0) << i;  // farthest from bounds
      }
      EXPECT_NEAR(answer.best().u(15), 3 - 0.1 * g, 1e-13);
    }
  }
}

}  // namespace
}  // namespace plank_landing_test
