// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/row_basis.hpp"

#include <gtest/gtest.h>

#include "tests/program/test_symbols.hpp"

namespace torsor::row_basis_test {
namespace {

using namespace testing_symbols;

// A = 1/(i + j + 1), Hilbert's, is positive definite; b = A x for an x that is known.
TEST(SolvePositive, FindsWhatTheMatrixWasMultipliedBy) {
  const WorkingDigits precision(50);
  constexpr long n = 5;
  const RealRow x{Real(2), Real(-3), rational(1, 7), Real(11), rational(-5, 3)};
  RealRows a(n, RealRow(n));
  RealRow b(n, Real(0));
  for (long i = 0; i < n; ++i) {
    for (long j = 0; j < n; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      const Real entry = rational(1, i + j + 1);
      b[row] += entry * x[column];
      a[row][column] = j <= i ? entry : Real(0);  // the lower triangle is read
    }
  }
  const RealRow found = solve_positive(a, b);
  // The condition of Hilbert's matrix of five rows is 5e5: fifty digits less six, and one for the operations.
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(relative_difference(found[i], x[i]), 1e-43) << i;
}

// Rows that depend on those before come with the combination that they are.
TEST(RowBasis, NamesTheCombinationOfADependentRow) {
  const WorkingDigits precision(50);
  RowBasis basis(3, power_of_ten(-30), power_of_ten(-20));
  EXPECT_TRUE(basis.add(0, {Real(1), Real(2), Real(0)}));
  EXPECT_TRUE(basis.add(1, {Real(0), Real(1), Real(-1)}));
  EXPECT_FALSE(basis.add(2, {Real(3), Real(4), Real(2)}));  // three times the first less twice the second
  EXPECT_FALSE(basis.add(3, {Real(0), Real(0), Real(0)}));
  EXPECT_EQ(basis.independent(), (std::vector<std::size_t>{0, 1}));
  const auto combinations = basis.combinations();
  ASSERT_EQ(combinations.size(), 2U);
  EXPECT_EQ(combinations[0].first, 2U);
  EXPECT_LT(relative_difference(combinations[0].second[0], Real(3)), 1e-45);
  EXPECT_LT(relative_difference(combinations[0].second[1], Real(-2)), 1e-45);
  for (const Real& part : combinations[1].second) EXPECT_TRUE(part.is_zero());
}

}  // namespace
}  // namespace torsor::row_basis_test
