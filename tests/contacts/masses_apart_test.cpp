// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that have nothing to do with each other, of masses far apart, move side by side as each does alone.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace masses_apart_test {
namespace {

using namespace simple_systems;

constexpr double f = 0.5, e = 0.5;

/// What one block on a level table does, whatever its mass: its place along a line of the table at 1 s, and its speed.
struct Course {
  std::string name;
  double height = 0, speed = 0;  ///< at the start
  double pull = 0;               ///< force along that line, for each unit of mass and time
  double x = 0, v = 0;
};

// It loses f g in each second, and ends after v/(f g).
Course slides() { return {.name = "slides", .speed = 2, .x = 2 * 2 / (2 * f * g)}; }
// It begins to slide where p t is f g.
Course is_pulled() {
  constexpr double p = 6, from = f * g / p, left = 1 - from;
  return {.name = "is pulled", .pull = p, .x = p * left * left * left / 6, .v = p * left * left / 2};
}
Course rests() { return {.name = "rests"}; }
// It strikes at √(2 h/g) and (1 + 2 e) times that, and loses f (1 + e) of its speed of approach, which is √(2 g h), then e of it.
Course falls() {
  constexpr double h = 1, v = 10;
  const double first = std::sqrt(2 * h / g), second = (1 + 2 * e) * first, blow = f * (1 + e) * g * first;
  return {.name = "falls", .height = h, .speed = v, .x = v - blow * (1 - first) - e * blow * (1 - second), .v = v - blow * (1 + e)};
}

/// Two such blocks in the plane, of places (x, z), or in space (x, y, z), where they go along (0.6, 0.8).
template <std::size_t axes>
ByHand<2 * axes, 2 * axes, 2> two_blocks(const std::array<double, 2>& masses, const std::array<Course, 2>& courses) {
  constexpr int n = static_cast<int>(axes), tangents = n - 1;
  const ContactRule rule{.tangents = tangents, .friction = f, .restitution = e};
  return {{rule, rule}, [=](double t, const auto& y, auto& r) {
            r.M.setZero();
            r.J.setZero();
            r.drift.setZero();
            for (int b = 0; b < 2; ++b) {
              const auto block = static_cast<std::size_t>(b);
              const double m = masses[block], pull = m * courses[block].pull * t;
              r.M.diagonal().segment(b * n, n).setConstant(m);
              r.F.segment(b * n, n).setZero();
              r.F(b * n) = tangents == 1 ? pull : 0.6 * pull;
              if (tangents == 2) r.F(b * n + 1) = 0.8 * pull;
              r.F(b * n + tangents) = -m * g;
              r.J(b * n, b * n + tangents) = 1;
              for (int k = 0; k < tangents; ++k) r.J(b * n + 1 + k, b * n + k) = 1;
              r.gap[block] = y[block * axes + axes - 1];
            }
            for (int row = 0; row < 2 * n; ++row) {
              r.w(row) = 0;
              for (int j = 0; j < 2 * n; ++j) r.w(row) += r.J(row, j) * y[2 * axes + static_cast<std::size_t>(j)];
            }
          }};
}

// Coordinates and velocities are below 10 and known to 1e-12; some ten events multiply that by less than ten.
template <std::size_t axes>
void expect_each_alone(const std::array<double, 2>& masses, const std::array<Course, 2>& courses) {
  SCOPED_TRACE(testing::Message() << axes << " axes, " << masses[0] << " kg " << courses[0].name << ", " << masses[1] << " kg "
                                  << courses[1].name);
  const auto blocks = two_blocks<axes>(masses, courses);
  const std::array<double, 2> line{axes == 2 ? 1.0 : 0.6, axes == 2 ? 0.0 : 0.8};
  std::array<double, 4 * axes> y{};
  for (std::size_t b = 0; b < 2; ++b) {
    y[b * axes + axes - 1] = courses[b].height;
    for (std::size_t k = 0; k + 1 < axes; ++k) y[(2 + b) * axes + k] = courses[b].speed * line[k];
  }
  const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  const auto result = integrate_contacts(blocks, y, 0, 1, method);
  EXPECT_EQ(result.status, ContactStatus::reached_end) << describe(result.status);
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t k = 0; k + 1 < axes; ++k) {
      EXPECT_NEAR(y[b * axes + k], courses[b].x * line[k], 1e-10) << b;
      EXPECT_NEAR(y[(2 + b) * axes + k], courses[b].v * line[k], 1e-10) << b;
    }
  }
}

TEST(MassesApart, MoveAsEachDoesAlone) {
  const std::array<Course, 4> courses{slides(), is_pulled(), rests(), falls()};
  for (const Course& one : courses) {
    for (const Course& other : courses) {
      expect_each_alone<2>({1e-7, 1e7}, {one, other});
      expect_each_alone<3>({1e-7, 1e7}, {one, other});
    }
  }
}

/// Two planks of 1e-7 and 1e7 kg on three supports each, of which two would do: height and turn of each.
ContactProblem two_planks() {
  ContactProblem problem;
  problem.count = 6;
  problem.W.setZero(6, 6);
  problem.q.resize(6);
  Eigen::Matrix<double, 3, 2> J;
  J << 1, -1, 1, 0, 1, 1;
  for (int k = 0; k < 2; ++k) {
    problem.W.block<3, 3>(3 * k, 3 * k) = J * J.transpose() / (k == 0 ? 1e-7 : 1e7);
    problem.q.segment<3>(3 * k) = J * Eigen::Vector2d(-g, 0);
  }
  for (int i = 0; i < 6; ++i) problem.laws[static_cast<std::size_t>(i)] = coulomb(0, 0);
  return problem;
}

// Each has its weight, to some roundings of it.
TEST(MassesApart, RestOnSupportsThatOneWouldNotNeed) {
  const ContactProblem problem = two_planks();
  for (const ContactAnswer& answer : {solve_contacts(problem), iterate_contacts(problem, ContactVector::Zero(6))}) {
    ASSERT_EQ(answer.verdict, ContactVerdict::indeterminate);
    EXPECT_NEAR(answer.best().r.head(3).sum() / (1e-7 * g), 1, 1e-14);
    EXPECT_NEAR(answer.best().r.tail(3).sum() / (1e7 * g), 1, 1e-14);
    EXPECT_GE(answer.best().r.minCoeff(), 0);
  }
}

// A light block, pulled by a little more or less than friction holds, and a heavy one that rests.
TEST(MassesApart, AreHeldByTheirOwnFrictionOnly) {
  for (const double pull : {1 - 1e-9, 1 + 1e-9}) {
    ContactProblem problem;
    problem.count = 2;
    problem.laws[0] = problem.laws[1] = coulomb(1, f);
    problem.W.setZero(4, 4);
    problem.W.diagonal() << 1e7, 1e7, 1e-7, 1e-7;
    problem.q.resize(4);
    problem.q << -g, pull * f * g, -g, 0;
    const ContactAnswer all = solve_contacts(problem), iterated = iterate_contacts(problem, ContactVector::Zero(4));
    EXPECT_EQ(all.verdict, ContactVerdict::unique) << pull;
    EXPECT_EQ(iterated.verdict, ContactVerdict::not_examined) << pull;  // it looks for no other
    for (const ContactAnswer& answer : {all, iterated}) {
      EXPECT_EQ(answer.best().regimes[0], pull < 1 ? ContactRegime::sticks : ContactRegime::slides);
      EXPECT_EQ(answer.best().regimes[1], ContactRegime::sticks);
      EXPECT_NEAR(answer.best().u(1), pull < 1 ? 0 : (pull - 1) * f * g, 1e-14);
    }
  }
}

// What is zero to rounding of a hard blow is not zero to that of a soft one.
TEST(MassesApart, LiftOffHoweverHardAnotherIsPressed) {
  for (const double hard : {0.0, 1e9}) {
    SCOPED_TRACE(hard);
    const ByHand<2, 2, 2> two{{ContactRule{.tangents = 0}, ContactRule{.tangents = 0}}, [hard](double, const auto& y, auto& r) {
                                r.M.setZero();
                                r.M.diagonal() << 1e-6, 1;
                                r.F << -1e-6 * hard, 1e-4;
                                r.J.setIdentity();
                                r.drift.setZero();
                                r.gap = {y[0], y[1]};
                                r.w << y[2], y[3];
                              }};
    std::array<double, 4> y{};
    EXPECT_EQ(integrate_contacts(two, y, 0, 1).status, ContactStatus::reached_end);
    EXPECT_EQ(y[0], 0);
    EXPECT_NEAR(y[1], 1e-4 / 2, 1e-12);
  }
}

// A plank rests on two of three supports, and the third draws away at 1e-3 m/s². To the rounding of a body that is pressed
// a million million times as hard all three hold it.
TEST(MassesApart, AreNotHeldBySupportsThatDrawAway) {
  for (const double hard : {0.0, 1e9}) {
    SCOPED_TRACE(hard);
    ContactProblem problem;
    problem.count = 4;
    problem.W.setZero(4, 4);
    Eigen::Matrix<double, 3, 2> J;
    J << 1, -1, 1, 0, 1, 1;
    problem.W.topLeftCorner(3, 3) = J * J.transpose();
    problem.W(3, 3) = 1;
    problem.q.resize(4);
    problem.q.head(3) = J * Eigen::Vector2d(-g, 1) + Eigen::Vector3d(0, 0, 1e-3);
    problem.q(3) = -hard;
    for (int i = 0; i < 4; ++i) problem.laws[static_cast<std::size_t>(i)] = coulomb(0, 0);
    const ContactAnswer answer = solve_contacts(problem);
    ASSERT_EQ(answer.verdict, ContactVerdict::unique);
    EXPECT_NEAR(answer.best().r(0), 1, 1e-14);
    EXPECT_NEAR(answer.best().r(1), g - 1, 1e-13);
    EXPECT_NEAR(answer.best().u(2), 1e-3, 1e-14);
  }
}

// The scheme by steps moves a light block beside a heavy one as it does alone.
TEST(MassesApart, MoveByStepsAsEachDoesAlone) {
  const auto moved = [](const std::array<double, 2>& masses) {
    std::array<double, 8> y{0, 0, 0, 0, 2, 0, 1, 0};
    EXPECT_EQ(step_contacts(two_blocks<2>(masses, {slides(), slides()}), y, 0, 1, {.count = 1000}),
              ContactStatus::reached_end);
    return y;
  };
  const auto alike = moved({1, 1});
  for (const auto& masses : {std::array{1e-7, 1e7}, std::array{1e7, 1e-7}}) {
    const auto apart = moved(masses);
    for (std::size_t i = 0; i < apart.size(); ++i) EXPECT_NEAR(apart[i], alike[i], 1e-12) << i;
  }
}

}  // namespace
}  // namespace masses_apart_test
