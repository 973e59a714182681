// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "torsor/generator/base/linear_algebra/row_reduction.hpp"

namespace torsor {

/// A = L Lᵀ of a symmetric positive definite matrix of double or Real, of which the lower triangle is read (Golub & Van
/// Loan, Matrix Computations, 4.2.3).
template <class Scalar>
class Cholesky {
 public:
  /// Squares of diagonal entries of L must be above `small` times those of A.
  explicit Cholesky(Rows<Scalar> a, const Scalar& small = Scalar(0)) : factor_(std::move(a)) {
    using std::abs, std::sqrt;
    for (std::size_t k = 0; k < factor_.size(); ++k) {
      for (std::size_t j = 0; j <= k; ++j) {
        Scalar rest = factor_[k][j];
        for (std::size_t i = 0; i < j; ++i) rest -= factor_[k][i] * factor_[j][i];
        if (j == k) positive_ = positive_ && rest > abs(factor_[k][k]) * small;
        factor_[k][j] = j < k ? rest / factor_[j][j] : sqrt(rest);
      }
    }
  }

  /// Where it is false there is no factor, and no result is a number.
  bool positive() const { return positive_; }

  /// L⁻¹ b and L⁻ᵀ b.
  std::vector<Scalar> forward(std::vector<Scalar> b) const {
    for (std::size_t k = 0; k < b.size(); ++k) {
      for (std::size_t i = 0; i < k; ++i) b[k] -= factor_[k][i] * b[i];
      b[k] /= factor_[k][k];
    }
    return b;
  }
  std::vector<Scalar> backward(std::vector<Scalar> b) const {
    for (std::size_t k = b.size(); k-- > 0;) {
      for (std::size_t i = k + 1; i < b.size(); ++i) b[k] -= factor_[i][k] * b[i];
      b[k] /= factor_[k][k];
    }
    return b;
  }

  /// x with A x = b.
  std::vector<Scalar> solve(std::vector<Scalar> b) const { return backward(forward(std::move(b))); }

 private:
  Rows<Scalar> factor_;
  bool positive_ = true;
};

}  // namespace torsor
