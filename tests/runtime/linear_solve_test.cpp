// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/numerics/linear_solve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "torsor/runtime/numerics/lu.hpp"

namespace linear_solve_test {
namespace {

using namespace torsor::runtime;
using Matrix3 = std::array<double, 9>;
using Vector3 = std::array<double, 3>;
using Equations = ConstrainedDynamics<double, 3, 2>;

// Positive definite, condition below 10: solutions of small integers come back within some ten roundings.
constexpr Matrix3 mass{4, 1, 0, 1, 3, 1, 0, 1, 2};
constexpr double rounding = 1e-14;

TEST(SolveDynamics, SolvesAMassMatrix) {
  Vector3 a{};
  ASSERT_EQ(solve_dynamics(mass, Vector3{6, 10, 8}, a), Evaluation::ok);  // M (1, 2, 3)
  EXPECT_NEAR(a[0], 1, rounding);
  EXPECT_NEAR(a[1], 2, rounding);
  EXPECT_NEAR(a[2], 3, rounding);
}

TEST(SolveDynamics, SolvesWithConstraints) {
  // A, 2 x 3 by columns, of full rank; a = (1, 2, 3), λ = (1, -2): γ = -A a, r = M a - Aᵀ λ.
  const std::array<double, 6> A{1, 0, 1, 1, 0, 2};
  const std::array<double, 2> gamma{-3, -8};
  const Vector3 r{6 - 1, 10 - (1 - 2), 8 + 4};
  Vector3 a{};
  std::array<double, 2> lambda{};
  ASSERT_EQ(solve_constrained_dynamics(Equations{.mass = mass, .jacobian = A, .r = r, .gamma = gamma}, a, lambda),
            Evaluation::ok);
  EXPECT_NEAR(a[0], 1, rounding);
  EXPECT_NEAR(a[1], 2, rounding);
  EXPECT_NEAR(a[2], 3, rounding);
  EXPECT_NEAR(lambda[0], 1, 10 * rounding);  // by the complement, whose condition is that of M times that of A
  EXPECT_NEAR(lambda[1], -2, 10 * rounding);
}

TEST(SolveDynamics, SolvesWithFrictionThatWorksWithTheMultipliers) {
  // A as above, B another 3 x 2 by columns; a = (1, 2, 3), λ = (1, -2): γ = -A a, r = M a - B λ.
  const std::array<double, 6> A{1, 0, 1, 1, 0, 2};
  const std::array<double, 6> B{1, 0.5, 0.25, 0, 1, 2};
  const std::array<double, 2> gamma{-3, -8};
  const Vector3 r{6 - 1, 10 - (0.5 - 2), 8 - (0.25 - 4)};
  Vector3 a{};
  std::array<double, 2> lambda{};
  const Equations equations{.mass = mass, .jacobian = A, .r = r, .gamma = gamma};
  ASSERT_EQ(solve_constrained_dynamics(equations, B, a, lambda), Evaluation::ok);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], static_cast<double>(i + 1), rounding);
  EXPECT_NEAR(lambda[0], 1, 10 * rounding);
  EXPECT_NEAR(lambda[1], -2, 10 * rounding);
  // Forces that cannot act on the constraints: the second column is such that A M⁻¹ B loses rank.
  const std::array<double, 6> useless{1, 0.5, 0.25, 2, 1, 0.5};
  EXPECT_EQ(solve_constrained_dynamics(equations, useless, a, lambda), Evaluation::singular);
}

TEST(SolveDynamics, SolvesWithOneConstraintInFloat) {
  const std::array<float, 4> unit{1, 0, 0, 1};
  std::array<float, 2> a{};
  std::array<float, 1> lambda{};
  // x = y held on a line, gravity -10 along y: a = (-5, -5), λ = -5 with A = (1, -1): a_x = λ, a_y = -10 - λ.
  const std::array<float, 2> A{1, -1}, r{0, -10};
  const std::array<float, 1> gamma{0};
  const ConstrainedDynamics<float, 2, 1> equations{.mass = unit, .jacobian = A, .r = r, .gamma = gamma};
  ASSERT_EQ(solve_constrained_dynamics(equations, a, lambda), Evaluation::ok);
  EXPECT_FLOAT_EQ(a[0], -5);
  EXPECT_FLOAT_EQ(a[1], -5);
  EXPECT_FLOAT_EQ(lambda[0], -5);
}

TEST(SolveDynamics, CallsAMassMatrixOfLowerRankSingularAndLeavesTheResultAlone) {
  Vector3 a{7, 7, 7};
  EXPECT_EQ(solve_dynamics(Matrix3{1, 1, 0, 1, 1, 0, 0, 0, 1}, Vector3{1, 1, 1}, a), Evaluation::singular);
  EXPECT_EQ(solve_dynamics(Matrix3{1, 0, 0, 0, 0, 0, 0, 0, 1}, Vector3{1, 1, 1}, a), Evaluation::singular);
  EXPECT_EQ(solve_dynamics(Matrix3{1, 2, 0, 2, 1, 0, 0, 0, 1}, Vector3{1, 1, 1}, a), Evaluation::singular);
  EXPECT_EQ(a, (Vector3{7, 7, 7}));
}

// Scaled to a unit diagonal the second row has 2^-51 left, n roundings; of 2^-40 a solution keeps some digits.
TEST(SolveDynamics, CallsAMassMatrixSingularWhereRoundingMadeItsRank) {
  std::array<double, 2> a{};
  const auto solved = [&](double less) {
    return solve_dynamics(std::array<double, 4>{1, 1 - less, 1 - less, 1}, std::array<double, 2>{1, 1}, a);
  };
  EXPECT_EQ(solved(0x1p-53), Evaluation::singular);
  EXPECT_EQ(solved(0x1p-41), Evaluation::ok);
}

// Rows exchanged: pivots 2 and -1e-9, then as they are.
TEST(Lu, KnowsItsSmallestPivot) {
  for (const bool exchanged : {false, true}) {
    Lu<double, 2> lu;
    lu.matrix() = exchanged ? std::array<double, 4>{1, 2, 0.5 - 1e-9, 1} : std::array<double, 4>{2, 1, 1, 0.5 - 1e-9};
    ASSERT_EQ(lu.factorise(), Evaluation::ok);
    EXPECT_NEAR(lu.smallest_pivot(), 1e-9, 1e-15);
    std::array<double, 2> b = exchanged ? std::array<double, 2>{1, 2} : std::array<double, 2>{2, 1};  // A (1, 0)
    lu.solve(b);
    EXPECT_NEAR(b[0], 1, 1e-6);
    EXPECT_NEAR(b[1], 0, 1e-6);
  }
}

TEST(SolveDynamics, CallsDependentConstraintsSingular) {
  const std::array<double, 6> twice_the_same{1, 2, 1, 2, 1, 2};
  Vector3 a{};
  std::array<double, 2> lambda{};
  const Vector3 r{};
  const std::array<double, 2> gamma{};
  const Equations equations{.mass = mass, .jacobian = twice_the_same, .r = r, .gamma = gamma};
  EXPECT_EQ(solve_constrained_dynamics(equations, a, lambda), Evaluation::singular);
}

TEST(SolveDynamics, DoesNotMindUnits) {
  // The same matrix with its second coordinate in units 1e9 times smaller: regular, with the same answer rescaled.
  const double s = 1e9;
  Vector3 a{};
  ASSERT_EQ(solve_dynamics(Matrix3{4, 1 * s, 0, 1 * s, 3 * s * s, 1 * s, 0, 1 * s, 2}, Vector3{6, 10 * s, 8}, a),
            Evaluation::ok);
  EXPECT_NEAR(a[0], 1, rounding);
  EXPECT_NEAR(a[1] * s, 2, rounding);
  EXPECT_NEAR(a[2], 3, rounding);
}

TEST(SolveDynamics, ReportsNumbersThatAreNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Vector3 a{};
  Matrix3 broken = mass;
  broken[0] = nan;
  EXPECT_EQ(solve_dynamics(broken, Vector3{1, 1, 1}, a), Evaluation::not_finite);
  broken = mass;
  broken[1] = broken[3] = nan;
  EXPECT_EQ(solve_dynamics(broken, Vector3{1, 1, 1}, a), Evaluation::not_finite);
  EXPECT_EQ(solve_dynamics(mass, Vector3{1, nan, 1}, a), Evaluation::not_finite);
}

}  // namespace
}  // namespace linear_solve_test
