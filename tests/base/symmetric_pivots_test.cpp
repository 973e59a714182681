// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/linear_algebra/cholesky.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::symmetric_pivots_test {
namespace {

using namespace testing_symbols;

// A = 1/(i + j + 1), Hilbert's, is positive definite; b = A x for an x that is known.
TEST(Cholesky, FindsWhatTheMatrixWasMultipliedBy) {
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
  const RealRow found = Cholesky<Real>(a).solve(b);
  // The condition of Hilbert's matrix of five rows is 5e5: fifty digits less six, and one for the operations.
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(relative_difference(found[i], x[i]), 1e-43) << i;
}

TEST(Cholesky, TellsWhereThereIsNoFactor) {
  EXPECT_TRUE(Cholesky<double>({{4, 0}, {2, 2}}).positive());
  EXPECT_FALSE(Cholesky<double>({{4, 0}, {2, 1}}).positive());
  EXPECT_FALSE(Cholesky<double>({{4, 0}, {2, 1.0 + 1e-15}}, 1e-14).positive());
}

// (1, 2, 0), (2, 3, 1), (0, 1, a): pivots 1, -1 and a + 1.
RealRows indefinite(int a) {
  return {{Real(1), Real(2), Real(0)}, {Real(2), Real(3), Real(1)}, {Real(0), Real(1), Real(a)}};
}

TEST(SymmetricPivots, AreWhatIsLeftOfTheDiagonal) {
  const WorkingDigits precision(50);
  const SymmetricPivots pivots(indefinite(4), power_of_ten(-30));
  EXPECT_EQ(pivots[0], Real(1));
  EXPECT_EQ(pivots[1], Real(-1));
  EXPECT_EQ(pivots[2], Real(5));
  EXPECT_EQ(pivots.first_small(), 3U);
  EXPECT_FALSE(pivots.all_positive());
  EXPECT_TRUE(SymmetricPivots({{Real(2), Real(1)}, {Real(1), Real(1)}}, Real(0)).all_positive());
}

TEST(SymmetricPivots, TellWhatADependentUnknownDependsOn) {
  const WorkingDigits precision(50);
  const SymmetricPivots pivots(indefinite(-1), power_of_ten(-30));
  ASSERT_EQ(pivots.first_small(), 2U);
  EXPECT_EQ(pivots.dependence(), (RealRow{Real(-2), Real(1)}));  // (1, 2, 0) and (2, 3, 1) send (-2, 1, 1) to zero
}

// An unknown that depends on those before it does not disturb those behind it.
TEST(SymmetricPivots, LeaveADependentUnknownOut) {
  const WorkingDigits precision(50);
  const SymmetricPivots pivots({{Real(1), Real(1), Real(1)}, {Real(1), Real(1), Real(1)}, {Real(1), Real(1), Real(3)}},
                               power_of_ten(-30));
  EXPECT_TRUE(pivots.is_small(1));
  EXPECT_EQ(pivots[2], Real(2));
}

}  // namespace
}  // namespace torsor::symmetric_pivots_test
