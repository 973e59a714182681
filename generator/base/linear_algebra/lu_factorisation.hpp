// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// P S A = L U of a dense square matrix: Gaussian elimination with partial pivoting after scaling each row by a power
/// of two, so that rows of different units compete fairly (Golub & Van Loan, Matrix Computations, 3.4 and 3.5.2).
class LuFactorisation {
 public:
  /// `column_major` holds size×size entries, entry (i, j) at i + j·size. Throws Error naming the pivot when the matrix
  /// is singular: a pivot not above size·epsilon relative to its column of the scaled matrix; and for a wrong length
  /// or a NaN.
  LuFactorisation(std::vector<Real> column_major, int size);

  /// x with A x = right_side. Throws Error when the lengths differ.
  std::vector<Real> solve(const std::vector<Real>& right_side) const;
  /// Column by column.
  std::vector<Real> inverse() const;

 private:
  int size_;
  std::vector<Real> factors_;       // L below the diagonal (ones left out), U on and above it
  std::vector<int> row_exponents_;  // row i of A was multiplied by 2^row_exponents_[i]
  std::vector<int> permutation_;    // row k of the factors is row permutation_[k] of A
};

/// Its condition number in the 1-norm.
double condition_number(const std::vector<Real>& column_major, int size);

/// x with A x = b for one right-hand side; errors as above.
std::vector<Real> solve_dense(std::vector<Real> column_major, const std::vector<Real>& right_side);

/// Largest of the sums of absolute values of a matrix' columns, `rows` entries each.
double norm_of_columns(const std::vector<Real>& column_major, std::size_t rows, std::size_t first = 0);

}  // namespace torsor
