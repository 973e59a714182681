// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/real_rows.hpp"

#include <gtest/gtest.h>

namespace torsor::row_reduction_test {
namespace {

class RowReductionOfReals : public ::testing::Test {
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

TEST_F(RowReductionOfReals, CountsIndependentRows) {
  EXPECT_EQ(rank(rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}), 3, tolerance), 2U);
  EXPECT_EQ(rank(rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}), 3, tolerance), 3U);
  EXPECT_EQ(rank(rows({{0, 0}, {0, 0}}), 2, tolerance), 0U);
  EXPECT_EQ(rank({}, 4, tolerance), 0U);
}

TEST_F(RowReductionOfReals, NamesIndependentRowsOfTheArrayGiven) {
  const RowReduction<Real> found = reduced_by_size(rows({{0, 0, 0}, {1, 1, 0}, {5, 5, 0}, {0, 0, 1}}), 3, tolerance);
  ASSERT_EQ(found.rank(), 2U);
  EXPECT_EQ(found.pivots()[0].row, 2U);
  EXPECT_EQ(found.pivots()[1].row, 3U);
  EXPECT_EQ(found.rows_left(), (std::vector<std::size_t>{0, 1}));
}

TEST_F(RowReductionOfReals, FindsWhatTheRowsSendToZero) {
  const RealRows a = rows({{1, 2, 3, 4}, {2, 4, 6, 8}, {0, 1, 7, -1}});
  const RealRows basis = null_space(a, 4, tolerance);
  ASSERT_EQ(basis.size(), 2U);
  for (const RealRow& x : basis) EXPECT_LE(size(times(a, x)), rounding);
  EXPECT_EQ(rank(basis, 4, tolerance), 2U);
  EXPECT_EQ(null_space({}, 3, tolerance).size(), 3U);
}

TEST_F(RowReductionOfReals, SolvesWithTheLeastNorm) {
  const RealRows a = rows({{1, 1, 0}, {0, 0, 2}, {1, 1, 2}});
  const auto x = solution({.rows = a, .right_side = {Real(2), Real(6), Real(8)}, .columns = 3}, tolerance);
  ASSERT_TRUE(x);
  EXPECT_LE(abs((*x)[0] - Real(1)), rounding);
  EXPECT_LE(abs((*x)[1] - Real(1)), rounding);
  EXPECT_LE(abs((*x)[2] - Real(3)), rounding);
  EXPECT_FALSE(solution({.rows = a, .right_side = {Real(2), Real(6), Real(9)}, .columns = 3}, tolerance));
}

TEST_F(RowReductionOfReals, TakesColumnsInTheirOrderWhateverTheirSize) {
  RowReduction<Real> reduction(rows({{1, 900, 2}, {2, 1800, 5}}), 3);
  reduction.take_in_order({0, 1, 2}, tolerance);
  ASSERT_EQ(reduction.rank(), 2U);
  EXPECT_EQ(reduction.pivots()[0].row, 1U);  // the larger entry of the first column
  EXPECT_FALSE(reduction.has_pivot(1));      // nothing is left of the second one
  const RealRows reduced = reduction.reduced();
  EXPECT_LE(abs(reduced[0][1] - Real(900)), rounding * Real(100));
  EXPECT_LE(abs(reduced[1][1]), rounding * Real(1000));
  EXPECT_EQ(reduced[0][2], Real(0));
}

// The same in exact numbers, √2 among them: what the identity becomes beside a matrix is its inverse.
TEST(RowReductionOfNumbers, InvertsExactly) {
  const Rows<Number> a{{0, 2, 1}, {Number::sqrt2(), 1, 0}, {1, 0, Number::rational(1, 3)}};
  RowReduction<Number> reduction(beside_identity(a, 3), 6);
  reduction.take_in_order(in_order(3));
  ASSERT_EQ(reduction.rank(), 3U);
  const Rows<Number> reduced = reduction.reduced();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(reduction.pivots()[i].column, i);
    for (std::size_t j = 0; j < 3; ++j) {
      Number sum;
      for (std::size_t k = 0; k < 3; ++k) sum += a[i][k] * reduced[k][3 + j];
      EXPECT_EQ(sum, Number(i == j ? 1 : 0)) << i << " " << j;
    }
  }
}

TEST(RowReductionOfNumbers, LeavesRowsThatSayNothingNew) {
  RowReduction<Number> reduction({{1, 1, 2}, {Number::sqrt2(), Number::sqrt2(), 2 * Number::sqrt2()}, {0, 1, 1}}, 3);
  reduction.take_in_order(in_order(3));
  EXPECT_EQ(reduction.rank(), 2U);
  ASSERT_EQ(reduction.rows_left().size(), 1U);
  for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(reduction(reduction.rows_left()[0], j).is_zero());
  EXPECT_EQ(reduction.null_space(), (Rows<Number>{{-1, -1, 1}}));
}

}  // namespace
}  // namespace torsor::row_reduction_test
