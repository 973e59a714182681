// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/base/real_elimination.hpp"

#include <gtest/gtest.h>

namespace torsor::real_elimination_test {
namespace {

class RealElimination : public ::testing::Test {
 protected:
  static RealRows rows(const std::vector<std::vector<int>>& whole) {
    RealRows result;
    for (const auto& row : whole) {
      result.emplace_back();
      for (const int entry : row) result.back().push_back(Real(entry));
    }
    return result;
  }
  static Real size(const RealRow& v) {
    Real largest;
    for (const Real& entry : v) largest = std::max(largest, abs(entry));
    return largest;
  }
  static RealRow times(const RealRows& a, const RealRow& x) {
    RealRow y;
    for (const RealRow& row : a) {
      Real sum;
      for (std::size_t j = 0; j < x.size(); ++j) sum += row[j] * x[j];
      y.push_back(sum);
    }
    return y;
  }

  WorkingDigits precision{50};
  Real tolerance{Number(10).pow(-40), 50};
  // Some ten operations on entries below 10.
  Real rounding{Number(10).pow(-47), 50};
};

TEST_F(RealElimination, CountsIndependentRows) {
  EXPECT_EQ(rank(rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}), 3, tolerance), 2);
  EXPECT_EQ(rank(rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}), 3, tolerance), 3);
  EXPECT_EQ(rank(rows({{0, 0}, {0, 0}}), 2, tolerance), 0);
  EXPECT_EQ(rank({}, 4, tolerance), 0);
}

TEST_F(RealElimination, NamesIndependentRowsOfTheArrayGiven) {
  const RowReduction found = eliminate(rows({{0, 0, 0}, {1, 1, 0}, {5, 5, 0}, {0, 0, 1}}), 3, tolerance);
  ASSERT_EQ(found.rank, 2);
  EXPECT_EQ(found.pivot_rows, (std::vector<int>{2, 3}));
}

TEST_F(RealElimination, FindsWhatTheRowsSendToZero) {
  const RealRows a = rows({{1, 2, 3, 4}, {2, 4, 6, 8}, {0, 1, 7, -1}});
  const RealRows basis = kernel(a, 4, tolerance);
  ASSERT_EQ(basis.size(), 2U);
  for (const RealRow& x : basis) EXPECT_LE(size(times(a, x)), rounding);
  EXPECT_EQ(rank(basis, 4, tolerance), 2);
  EXPECT_EQ(kernel({}, 3, tolerance).size(), 3U);
}

TEST_F(RealElimination, SolvesWithTheLeastNorm) {
  const RealRows a = rows({{1, 1, 0}, {0, 0, 2}, {1, 1, 2}});
  const auto x = solution(a, {Real(2), Real(6), Real(8)}, 3, tolerance);
  ASSERT_TRUE(x);
  EXPECT_LE(abs((*x)[0] - Real(1)), rounding);
  EXPECT_LE(abs((*x)[1] - Real(1)), rounding);
  EXPECT_LE(abs((*x)[2] - Real(3)), rounding);
  EXPECT_FALSE(solution(a, {Real(2), Real(6), Real(9)}, 3, tolerance));
}

}  // namespace
}  // namespace torsor::real_elimination_test
