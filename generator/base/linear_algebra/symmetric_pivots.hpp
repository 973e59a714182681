// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/linear_algebra/real_rows.hpp"

namespace torsor {

/// Pivots of A = L D Lᵀ for a symmetric A, unknown after unknown without exchanges (Golub & Van Loan, Matrix
/// Computations, 4.1.2): d_k is what is left of the diagonal entry k where the unknowns before it give way. An unknown
/// whose |d_k| is not above `small` |a_kk| depends on those before it, and is left out of what follows.
class SymmetricPivots {
 public:
  SymmetricPivots(RealRows a, const Real& small);

  std::size_t size() const { return pivots_.size(); }
  const Real& operator[](std::size_t k) const { return pivots_[k]; }
  bool is_small(std::size_t k) const { return small_[k]; }
  /// The first that is small, size() where none is.
  std::size_t first_small() const;
  bool all_positive() const;

  /// Of the unknowns before the first whose pivot is small: x with A (x, 1, 0 …) = 0 in their rows.
  RealRow dependence() const;

 private:
  RealRows rest_;  // the upper triangle holds D Lᵀ
  RealRow pivots_;
  std::vector<bool> small_;
};

}  // namespace torsor
