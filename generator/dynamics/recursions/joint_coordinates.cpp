// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/joint_coordinates.hpp"

#include <utility>

#include "torsor/generator/base/linear_algebra/row_reduction.hpp"

namespace torsor {
namespace {

using NumberMatrix = Rows<Number>;

/// Nothing where the matrix is singular.
std::optional<NumberMatrix> inverted(const NumberMatrix& matrix) {
  const std::size_t n = matrix.size();
  RowReduction<Number> reduction(beside_identity(matrix, n), 2 * n);
  reduction.take_in_order(in_order(n));
  if (reduction.rank() < n) return std::nullopt;
  NumberMatrix inverse;
  for (const std::vector<Number>& row : reduction.reduced()) {  // the pivots' columns are in order
    inverse.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(n), row.end());
  }
  return inverse;
}

}  // namespace

std::optional<JointCoordinates> joint_coordinates(const BodyTree& tree) {
  const auto n = static_cast<std::size_t>(tree.unknown_count());
  JointCoordinates result;
  NumberMatrix partials;
  for (std::size_t k = 1; k < tree.links().size(); ++k) {
    const Link& link = tree.links()[k];
    if (link.partials.empty()) continue;
    if (partials.size() == n) return std::nullopt;
    Value rest = link.acceleration;
    std::vector<Number> row(n);
    for (const auto& [i, partial] : link.partials) {
      if (i >= tree.unknown_count() || !partial.is_constant() || !partial.unit().is_dimensionless()) return std::nullopt;
      row[static_cast<std::size_t>(i)] = partial.polynomial().constant();
      rest -= partial * tree.a(i);
    }
    // A displacement q + f(t) has another second derivative than q.
    if (!rest.is_zero()) return std::nullopt;
    result.joints.push_back(k);
    partials.push_back(std::move(row));
  }
  if (partials.size() != n) return std::nullopt;
  std::optional<NumberMatrix> inverse = inverted(partials);
  if (!inverse) return std::nullopt;
  result.inverse = std::move(*inverse);
  return result;
}

}  // namespace torsor
