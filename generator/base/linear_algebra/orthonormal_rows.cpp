// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/linear_algebra/orthonormal_rows.hpp"

namespace torsor {

bool OrthonormalRows::add(std::size_t index, const RealRow& row) {
  const Real whole = length(row);
  RealRow rest = row;
  RealRow along(directions_.size(), Real(0));
  for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Golub & Van Loan, 5.2.8)
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      const Real part = product(rest, directions_[k]);
      along[k] += part;
      for (std::size_t i = 0; i < size_; ++i) rest[i] -= part * directions_[k][i];
    }
  }
  const Real left = length(rest);
  if (!(whole > null_length_) || !(left > whole * tolerance_)) {
    dependent_.push_back({index, whole > null_length_ ? along : RealRow(along.size(), Real(0))});
    return false;
  }
  for (Real& r : rest) r /= left;
  directions_.push_back(rest);
  along.push_back(left);
  independent_.push_back({index, along});
  return true;
}

std::vector<std::pair<std::size_t, RealRow>> OrthonormalRows::combinations() const {
  std::vector<std::pair<std::size_t, RealRow>> all;
  for (const auto& [index, along] : dependent_) {
    RealRow rest = along;
    rest.resize(independent_.size(), Real(0));
    RealRow c(independent_.size(), Real(0));
    for (std::size_t k = independent_.size(); k-- > 0;) {  // rows are lower triangular in the directions
      c[k] = rest[k] / independent_[k].second[k];
      for (std::size_t i = 0; i <= k; ++i) rest[i] -= c[k] * independent_[k].second[i];
    }
    all.emplace_back(index, std::move(c));
  }
  return all;
}

RealRow OrthonormalRows::least(const RealRow& wanted) const {
  RealRow delta(size_, Real(0));
  RealRow y;
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    Real rest = wanted[k];
    for (std::size_t i = 0; i < k; ++i) rest -= independent_[k].second[i] * y[i];
    y.push_back(rest / independent_[k].second[k]);
    for (std::size_t i = 0; i < size_; ++i) delta[i] += y[k] * directions_[k][i];
  }
  return delta;
}

}  // namespace torsor
