// SPDX-License-Identifier: GPL-3.0-or-later
// A box on a box on the floor: eight corners touch, more than those of which all regimes are tried.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/contact_solver.hpp"

namespace stacked_boxes_test {
namespace {

using namespace torsor::runtime;
using Eigen::RowVector3d;
using Eigen::Vector3d;

constexpr double g = 9.81, m = 1, M = 3, a = 0.1, b = 0.08, c = 0.05;
constexpr int corners = 4;

// Rows of the velocity of a point at r from a body's centre: normal, then x and y.
Eigen::Matrix<double, 3, 6> rows_at(const Vector3d& r) {
  Eigen::Matrix<double, 3, 6> rows;
  rows << 0, 0, 1, r.y(), -r.x(), 0,  //
      1, 0, 0, 0, r.z(), -r.y(),      //
      0, 1, 0, -r.z(), 0, r.x();
  return rows;
}

/// Corners 0 to 3 are those of the upper box on the lower one, 4 to 7 those of the lower one on the floor. The lower box is at
/// rest. The upper one moves by (vx, vy) and spins, its edges along those of the lower one.
struct Stack {
  double f, F, vx, vy, spin;
  ContactProblem problem{};

  Stack(double upper, double lower, double x, double y, double turns) : f(upper), F(lower), vx(x), vy(y), spin(turns) {
    Eigen::Matrix<double, 24, 12> J = Eigen::Matrix<double, 24, 12>::Zero();
    Eigen::Matrix<double, 12, 1> masses, forces = Eigen::Matrix<double, 12, 1>::Zero();
    const Vector3d inertia((b * b + c * c) / 3, (a * a + c * c) / 3, (a * a + b * b) / 3);
    masses << Vector3d::Constant(m), m * inertia, Vector3d::Constant(M), M * inertia;
    forces(2) = -m * g;
    forces(8) = -M * g;
    problem.count = 2 * corners;
    ContactVector drift = ContactVector::Zero(24);
    for (int i = 0; i < corners; ++i) {
      const Vector3d r(i / 2 == 0 ? -a : a, i % 2 == 0 ? -b : b, -c);
      J.block<3, 6>(3 * i, 0) = rows_at(r);
      J.block<3, 6>(3 * i, 6) = -rows_at({r.x(), r.y(), c});
      J.block<3, 6>(3 * (corners + i), 6) = rows_at(r);
      drift.segment<3>(3 * i) << 0, -spin * spin * r.x(), -spin * spin * r.y();
      const auto at = static_cast<std::size_t>(i);
      problem.laws[at] = coulomb(2, f);
      problem.laws[at + corners] = coulomb(2, F);
      const double wx = vx - spin * r.y(), wy = vy + spin * r.x(), speed = std::hypot(wx, wy);
      if (speed == 0) continue;
      problem.laws[at].slips = true;
      problem.laws[at].slip = {wx / speed, wy / speed};
    }
    const Eigen::Matrix<double, 12, 24> KJ = masses.cwiseInverse().asDiagonal() * J.transpose();
    problem.W = J * KJ;
    problem.q = J * forces.cwiseQuotient(masses) + drift;
  }
};

// Sums of forces follow from Newton's theorem, whichever way corners share them.
void expect_weights(const Stack& stack, const ContactSolution& found) {
  double upper = 0, lower = 0;
  for (int i = 0; i < corners; ++i) {
    EXPECT_GE(found.r(3 * i), 0);
    EXPECT_GE(found.r(3 * (corners + i)), 0);
    upper += found.r(3 * i);
    lower += found.r(3 * (corners + i));
  }
  EXPECT_NEAR(upper, m * g, 1e-12 * m * g);
  EXPECT_NEAR(lower, (m + M) * g, 1e-12 * (m + M) * g);
  EXPECT_LE(natural_map_residual(stack.problem, found), 1e-12);
}

// Sweeps may leave forces at their bounds, where none is needed there: a corner that slides at no speed was the beginning of
// a slip without a direction.
TEST(StackedBoxes, RestOnAllCorners) {
  for (const double pull : {0.0, 0.3, 1.5}) {
    Stack stack(0.2, 0.5, 0, 0, 0);
    for (int i = 0; i < corners; ++i) stack.problem.q(3 * i + 1) += pull;  // below f g = 1.962
    const ContactAnswer answer = solve_contacts(stack.problem);
    ASSERT_TRUE(answer) << pull;
    expect_weights(stack, answer.best());
    EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
    for (std::size_t i = 0; i < 2 * corners; ++i) EXPECT_EQ(answer.best().regimes[i], ContactRegime::sticks) << pull << ' ' << i;
    EXPECT_EQ(answer.best().u.norm(), 0);
  }
}

// The upper box is pulled away, and the lower one rests: all of its corners stick, in steps as well.
TEST(StackedBoxes, LeaveTheLowerOneAtRest) {
  for (const double pull : {2.0, 2.5, 5.0, 20.0}) {
    Stack stack(0.2, 0.5, 0, 0, 0);
    for (int i = 0; i < corners; ++i) stack.problem.q(3 * i + 1) += pull;  // above f g = 1.962
    for (const ContactAnswer& answer :
         {solve_contacts(stack.problem), iterate_contacts(stack.problem, ContactVector::Zero(stack.problem.rows()))}) {
      ASSERT_TRUE(answer) << pull;
      expect_weights(stack, answer.best());
      EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
      for (int i = 0; i < corners; ++i) {
        EXPECT_NEAR(answer.best().u(3 * i + 1), pull - 0.2 * g, 1e-12);
        EXPECT_EQ(answer.best().regimes[static_cast<std::size_t>(corners + i)], ContactRegime::sticks) << pull << ' ' << i;
      }
    }
  }
}

// The upper box drags the lower one along and turns it: the directions of four slips depend on how corners share the weight.
TEST(StackedBoxes, BeginToSlideUnderABoxThatSpins) {
  for (const double spin : {0.5, 3.0, -8.0}) {
    const Stack stack(0.3, 0.05, 0.5, 0.4, spin);
    const ContactAnswer answer = solve_contacts(stack.problem);
    ASSERT_TRUE(answer) << spin;
    const ContactSolution& found = answer.best();
    expect_weights(stack, found);
    for (int i = corners; i < 2 * corners; ++i) {
      EXPECT_EQ(found.regimes[static_cast<std::size_t>(i)], ContactRegime::slides);
      // T = -F N u_T/|u_T|.
      const Eigen::Vector2d T = found.r.segment<2>(3 * i + 1), u = found.u.segment<2>(3 * i + 1);
      EXPECT_NEAR((T + stack.F * found.r(3 * i) * u.normalized()).norm(), 0, 1e-10 * (m + M) * g);
    }
  }
}

}  // namespace
}  // namespace stacked_boxes_test
