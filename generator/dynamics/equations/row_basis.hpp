// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "generator/base/real_elimination.hpp"

namespace torsor {

/// Σ a_i b_i, and the root of Σ a_i².
Real product(const RealRow& a, const RealRow& b);
Real length(const RealRow& a);

/// x with A x = b for a symmetric positive definite A, of which the lower triangle is read (Cholesky; Golub & Van Loan,
/// 4.2.3). Not numbers where A is not positive definite.
RealRow solve_positive(RealRows a, RealRow b);

/// Rows met in turn: each either extends an orthonormal basis or depends on those before it, when it is no longer than
/// `null_length` or no more than `tolerance` of it stands out.
class RowBasis {
 public:
  RowBasis(std::size_t size, Real null_length, Real tolerance)
      : size_(size), null_length_(std::move(null_length)), tolerance_(std::move(tolerance)) {}

  /// Whether the row is independent of the ones accepted before; if so it is accepted under that index.
  bool add(std::size_t index, const RealRow& row) {
    const Real whole = length(row);
    RealRow rest = row;
    std::vector<Real> along(directions_.size(), Real(0));
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Golub & Van Loan, 5.2.8)
      for (std::size_t k = 0; k < directions_.size(); ++k) {
        const Real part = product(rest, directions_[k]);
        along[k] += part;
        for (std::size_t i = 0; i < size_; ++i) rest[i] -= part * directions_[k][i];
      }
    }
    const Real left = length(rest);
    if (!(whole > null_length_) || !(left > whole * tolerance_)) {
      dependent_.push_back({index, whole > null_length_ ? along : std::vector<Real>(along.size(), Real(0))});
      return false;
    }
    for (Real& r : rest) r /= left;
    directions_.push_back(rest);
    along.push_back(left);
    independent_.push_back({index, along});
    return true;
  }

  /// Coefficients c with row = Σ_k c_k row of the k-th accepted one, for every dependent row: (index, c).
  std::vector<std::pair<std::size_t, std::vector<Real>>> combinations() const {
    std::vector<std::pair<std::size_t, std::vector<Real>>> all;
    for (const auto& [index, along] : dependent_) {
      std::vector<Real> rest = along;
      rest.resize(independent_.size(), Real(0));
      std::vector<Real> c(independent_.size(), Real(0));
      for (std::size_t k = independent_.size(); k-- > 0;) {  // rows are lower triangular in the directions
        c[k] = rest[k] / independent_[k].second[k];
        for (std::size_t i = 0; i <= k; ++i) rest[i] -= c[k] * independent_[k].second[i];
      }
      all.emplace_back(index, std::move(c));
    }
    return all;
  }

  std::vector<std::size_t> independent() const {
    std::vector<std::size_t> indices;
    for (const auto& [index, along] : independent_) indices.push_back(index);
    return indices;
  }
  std::size_t rank() const { return directions_.size(); }
  const RealRows& directions() const { return directions_; }

  /// δ of least length with row_k · δ = wanted_k for the accepted rows.
  RealRow least(const std::vector<Real>& wanted) const {
    RealRow delta(size_, Real(0));
    std::vector<Real> y;
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      Real rest = wanted[k];
      for (std::size_t i = 0; i < k; ++i) rest -= independent_[k].second[i] * y[i];
      y.push_back(rest / independent_[k].second[k]);
      for (std::size_t i = 0; i < size_; ++i) delta[i] += y[k] * directions_[k][i];
    }
    return delta;
  }

 private:
  std::size_t size_;
  Real null_length_, tolerance_;
  RealRows directions_;
  std::vector<std::pair<std::size_t, std::vector<Real>>> independent_, dependent_;
};

}  // namespace torsor
