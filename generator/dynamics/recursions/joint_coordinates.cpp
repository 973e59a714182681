// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/recursions/joint_coordinates.hpp"

#include <utility>

namespace torsor {
namespace {

using NumberMatrix = std::vector<std::vector<Number>>;

/// Gauss and Jordan, exact. Nothing where the matrix is singular.
std::optional<NumberMatrix> inverted(NumberMatrix matrix) {
  const std::size_t n = matrix.size();
  NumberMatrix inverse(n, std::vector<Number>(n));
  for (std::size_t i = 0; i < n; ++i) inverse[i][i] = Number(1);
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && matrix[pivot][column].is_zero()) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(matrix[pivot], matrix[column]);
    std::swap(inverse[pivot], inverse[column]);
    const Number scale = matrix[column][column].pow(-1);
    for (std::size_t j = 0; j < n; ++j) {
      matrix[column][j] *= scale;
      inverse[column][j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Number factor = matrix[i][column];
      if (i == column || factor.is_zero()) continue;
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i][j] -= factor * matrix[column][j];
        inverse[i][j] -= factor * inverse[column][j];
      }
    }
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
  std::optional<NumberMatrix> inverse = inverted(std::move(partials));
  if (!inverse) return std::nullopt;
  result.inverse = std::move(*inverse);
  return result;
}

}  // namespace torsor
