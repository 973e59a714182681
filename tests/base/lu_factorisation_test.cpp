// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/base/error_of.hpp"

namespace torsor::lu_factorisation_test {
namespace {

using testing_errors::error_of;

std::vector<Real> reals(const std::vector<int>& values) {
  std::vector<Real> result;
  for (const int value : values) result.emplace_back(value);
  return result;
}

TEST(LuFactorisation, SolvesRandomSystemsToItsPrecision) {
  std::mt19937_64 engine(11);
  std::uniform_int_distribution<long> part(-1000, 1000);
  for (int size = 0; size <= 8; ++size) {
    std::vector<Real> matrix, expected, right_side(static_cast<std::size_t>(size));
    for (int entry = 0; entry < size * size; ++entry) matrix.emplace_back(Number::rational(part(engine), 37), 50);
    for (int entry = 0; entry < size; ++entry) expected.emplace_back(Number::rational(part(engine), 41), 50);
    for (std::size_t column = 0; column < expected.size(); ++column) {
      for (std::size_t row = 0; row < expected.size(); ++row) {
        right_side[row] += matrix[row + column * expected.size()] * expected[column];
      }
    }
    const std::vector<Real> unknowns = LuFactorisation(matrix, size).solve(right_side);
    ASSERT_EQ(unknowns.size(), expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row) {
      // Precision is 57 digits; condition numbers of such matrices stay far below 1e7.
      EXPECT_LT(abs(unknowns[row] - expected[row]), Real(Number(10).pow(-47), 50));
    }
  }
}

TEST(LuFactorisation, SolvesTheHilbertMatrixExactlyAsItsInverseSays) {
  // The inverse of the 4×4 Hilbert matrix has integer entries; its first column is 16, −120, 240, −140.
  // Condition 1.6e4.
  std::vector<Real> hilbert;
  for (int column = 1; column <= 4; ++column) {
    for (int row = 1; row <= 4; ++row) hilbert.emplace_back(Number::rational(1, row + column - 1), 50);
  }
  const std::vector<Real> unknowns = solve_dense(hilbert, reals({1, 0, 0, 0}));
  const std::vector<Real> expected = reals({16, -120, 240, -140});
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_LT(abs(unknowns[row] - expected[row]), Real(Number(10).pow(-48), 50));
  }
}

TEST(LuFactorisation, PivotsWhereTheDiagonalVanishes) {
  // Columns (0, 1, 0), (0, 0, 3), (2, 0, 0): a permutation with factors.
  const std::vector<Real> unknowns = solve_dense(reals({0, 1, 0, 0, 0, 3, 2, 0, 0}), reals({4, 5, 6}));
  EXPECT_EQ(unknowns[0], Real(5));
  EXPECT_EQ(unknowns[1], Real(2));
  EXPECT_EQ(unknowns[2], Real(2));
}

TEST(LuFactorisation, IsNotFooledByRowsOfVeryDifferentUnits) {
  // Rows 10^60·(1, 1) and (1, 2): regular, though its second pivot looks like nothing beside 10^60.
  const Real big(Number(10).pow(60), 50);
  const std::vector<Real> unknowns = solve_dense({big, Real(1), big, Real(2)}, {big * Real(3), Real(5)});
  EXPECT_LT(abs(unknowns[0] - Real(1)), Real(Number(10).pow(-48), 50));
  EXPECT_LT(abs(unknowns[1] - Real(2)), Real(Number(10).pow(-48), 50));
}

TEST(LuFactorisation, NamesThePivotOfASingularMatrix) {
  const std::string message = error_of([] { LuFactorisation(reals({1, 2, 3, 2, 4, 6, 0, 1, 5}), 3); });
  EXPECT_EQ(message.substr(0, 55), "a linear system of size 3 is singular: pivot 1 is 0.00;") << message;
  EXPECT_NE(error_of([] { LuFactorisation(reals({0}), 1); }).find("pivot 0 is"), std::string::npos);
  // Singular up to rounding: thirds make the last pivot a rounding error instead of zero.
  const Real third(Number::rational(1, 3), 50), seventh(Number::rational(1, 7), 50);
  EXPECT_NE(error_of([&] {
              LuFactorisation({third, seventh, third * third, seventh * third}, 2);
            }).find("pivot 1 is"),
            std::string::npos);
}

TEST(LuFactorisation, RefusesShapesThatDoNotMatch) {
  EXPECT_EQ(error_of([] {
              LuFactorisation(reals({1, 2, 3}), 2);
            }),
            "a linear system of size 2 needs the square of that many entries, not 3");
  EXPECT_EQ(error_of([] {
              LuFactorisation(reals({1}), 1).solve(reals({1, 2}));
            }),
            "a linear system of size 1 was given a right-hand side of length 2");
  EXPECT_NE(error_of([] { LuFactorisation({Real::not_a_number()}, 1); }).find("entry (0, 0)"), std::string::npos);
}

}  // namespace
}  // namespace torsor::lu_factorisation_test
