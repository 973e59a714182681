// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/constraints/independent_constraints.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace independent_constraints_test {
namespace {

using namespace torsor::runtime;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Of three unit masses. Rows are written one after the other.
template <std::size_t m>
IndependentConstraints<double, 3, m> factor_of(const std::array<std::array<double, 3>, m>& rows) {
  const std::array<double, 9> unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 3 * m> jacobian;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < 3; ++j) jacobian[j * m + i] = rows[i][j];
  }
  IndependentConstraints<double, 3, m> factor;
  EXPECT_EQ(factor.factorise(unit, jacobian), Evaluation::ok);
  return factor;
}

// Rows that lie some 1e-4 apart: what is left of them beside the first is orthogonal to it to 1e-12 after one pass of
// Gram-Schmidt, and would move what that one asks for by 1e-12 times corrections of 1e4.
TEST(IndependentConstraints, MeetRowsThatAreNearlyParallelToRoundings) {
  const std::array<std::array<double, 3>, 3> rows{{{1, 0.7, 0.3}, {1, 0.7001, 0.3}, {1.0001, 0.7, 0.30013}}};
  auto factor = factor_of(rows);
  ASSERT_EQ(factor.rank(), 3);
  const IndependentConstraints<double, 3, 3>::Residual wanted{{1.0, -1.0, 0.5}};
  const auto x = factor.least_change(wanted);
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0.0, size = 0.0;
    for (int j = 0; j < 3; ++j) {
      const double term = rows[i][static_cast<std::size_t>(j)] * x(j);
      sum += term;
      size += std::abs(term);
    }
    EXPECT_GT(size, 1e3);
    // Entries of Q, R and x are rounded a few times each.
    EXPECT_NEAR(sum, wanted(static_cast<int>(i)), 16 * epsilon * size) << i;
  }
}

TEST(IndependentConstraints, AreContradictedOnlyByWhatRepeatsThemOtherwise) {
  // The third row is twice the first less the second.
  auto factor = factor_of<3>({{{1, 0, 2}, {0, 1, 1}, {2, -1, 3}}});
  ASSERT_EQ(factor.rank(), 2);
  using Residual = IndependentConstraints<double, 3, 3>::Residual;
  const std::array<double, 3> lengths{std::sqrt(5.0), std::sqrt(2.0), std::sqrt(14.0)};
  for (const double a : {-3.0, 0.5}) {
    for (const double b : {2.0, 7.0}) {
      EXPECT_NEAR(factor.contradiction(Residual{{a, b, 2 * a - b}}), 0.0, 32 * epsilon);
      // One row is not met by what it should be, whichever was left out: of a residual along the rows' dependence
      // (2, -1, -1), the one left out keeps its component's share.
      const int left_out = factor.constraint(2);
      const double length = lengths[static_cast<std::size_t>(left_out)];
      const double off = factor.contradiction(Residual{{a, b, 2 * a - b + 0.5}}) * length;
      EXPECT_NEAR(off, left_out == 0 ? 0.25 : 0.5, 64 * epsilon);
    }
  }
}

// Two rows of lengths 1e5 apart, and beside what they are elsewhere one that vanishes.
TEST(IndependentConstraints, CountInAllUnits) {
  const double tolerance = change_point_tolerance<double>();
  const std::array<double, 9> masses{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<double, 6> rows{1e5, 0, 0, 1, 1e5, 1}, usual{1e5, 0, 0, 1, 1e5, 1};
  IndependentConstraints<double, 3, 2> factor;
  ASSERT_EQ(factor.factorise(masses, rows, tolerance), Evaluation::ok);
  EXPECT_EQ(factor.rank(), 2);
  ASSERT_EQ(factor.factorise(masses, rows, tolerance, usual), Evaluation::ok);
  EXPECT_EQ(factor.rank(), 2);
  EXPECT_NEAR(factor.content(), std::sqrt(3.0) / 2, 8 * epsilon);  // of rows at 60°, of their usual lengths
  std::array<double, 6> vanishing = rows;
  for (const std::size_t k : {1U, 3U, 5U}) vanishing[k] *= 1e-6;
  ASSERT_EQ(factor.factorise(masses, vanishing, tolerance, usual), Evaluation::ok);
  EXPECT_EQ(factor.rank(), 1);
  ASSERT_EQ(factor.factorise(masses, vanishing, tolerance / 10, usual), Evaluation::ok);
  EXPECT_EQ(factor.rank(), 2);
  EXPECT_NEAR(factor.least_share(), std::sqrt(3.0) / 2 * 1e-6, 1e-6 * 16 * epsilon);
  // All of them together are no less noticed than one beside others.
  for (double& entry : vanishing) entry *= 1e-6;
  ASSERT_EQ(factor.factorise(masses, vanishing, tolerance, usual), Evaluation::ok);
  EXPECT_EQ(factor.rank(), 0);
}

}  // namespace
}  // namespace independent_constraints_test
