// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "torsor/generator/base/linear_algebra/real_rows.hpp"

namespace torsor {

/// Rows met in turn: each either extends an orthonormal basis or depends on those before it, when it is no longer than
/// `null_length` or no more than `tolerance` of it stands out.
class OrthonormalRows {
 public:
  OrthonormalRows(std::size_t size, Real null_length, Real tolerance)
      : size_(size), null_length_(std::move(null_length)), tolerance_(std::move(tolerance)) {}

  /// Whether the row is independent of the ones accepted before; if so it is accepted under that index.
  bool add(std::size_t index, const RealRow& row);

  /// Coefficients c with row = Σ_k c_k row of the k-th accepted one, for every dependent row: (index, c).
  std::vector<std::pair<std::size_t, RealRow>> combinations() const;

  std::vector<std::size_t> independent() const {
    std::vector<std::size_t> indices;
    for (const auto& [index, along] : independent_) indices.push_back(index);
    return indices;
  }
  std::size_t rank() const { return directions_.size(); }
  const RealRows& directions() const { return directions_; }

  /// δ of least length with row_k · δ = wanted_k for the accepted rows.
  RealRow least(const RealRow& wanted) const;

 private:
  std::size_t size_;
  Real null_length_, tolerance_;
  RealRows directions_;
  std::vector<std::pair<std::size_t, RealRow>> independent_, dependent_;
};

}  // namespace torsor
