// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"

#include <algorithm>

namespace torsor {

SymmetricPivots::SymmetricPivots(RealRows a, const Real& small) : rest_(std::move(a)) {
  RealRow least;
  for (std::size_t k = 0; k < rest_.size(); ++k) least.push_back(small * abs(rest_[k][k]));
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const Real pivot = rest_[k][k];
    pivots_.push_back(pivot);
    small_.push_back(!(abs(pivot) > least[k]));
    if (small_.back()) continue;
    for (std::size_t i = k + 1; i < rest_.size(); ++i) {
      if (rest_[i][k].is_zero()) continue;
      const Real factor = rest_[i][k] / pivot;
      for (std::size_t j = k; j < rest_.size(); ++j) rest_[i][j] -= factor * rest_[k][j];
    }
  }
}

std::size_t SymmetricPivots::first_small() const {
  return static_cast<std::size_t>(std::find(small_.begin(), small_.end(), true) - small_.begin());
}

bool SymmetricPivots::all_positive() const {
  return std::all_of(pivots_.begin(), pivots_.end(), [](const Real& pivot) { return pivot > Real(0); });
}

RealRow SymmetricPivots::dependence() const {
  const std::size_t n = first_small();
  RealRow x(n, Real(0));
  for (std::size_t i = n; i-- > 0;) {
    Real right = -rest_[i][n];
    for (std::size_t j = i + 1; j < n; ++j) right -= rest_[i][j] * x[j];
    x[i] = right / rest_[i][i];
  }
  return x;
}

}  // namespace torsor
