// SPDX-License-Identifier: GPL-3.0-or-later
#include "runtime/constraints/independent_constraints.hpp"

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
  const IndependentConstraints<double, 3, 3>::Residual wanted(1.0, -1.0, 0.5);
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
  const double longest = std::sqrt(14.0);
  for (const double a : {-3.0, 0.5}) {
    for (const double b : {2.0, 7.0}) {
      EXPECT_NEAR(factor.contradiction(Residual(a, b, 2 * a - b)), 0.0, 32 * epsilon);
      // One row is not met by what it should be, whichever was left out: of a residual along the rows' dependence
      // (2, -1, -1), the one left out keeps its component's share.
      const double off = factor.contradiction(Residual(a, b, 2 * a - b + 0.5)) * longest;
      const int left_out = factor.constraint(2);
      EXPECT_NEAR(off, left_out == 0 ? 0.25 : 0.5, 64 * epsilon);
    }
  }
}

}  // namespace
}  // namespace independent_constraints_test
