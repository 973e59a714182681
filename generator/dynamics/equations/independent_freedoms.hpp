// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/base/linear_algebra/row_reduction.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// A choice of independent freedoms where constraints tie them, and the order in which the dependent ones are
/// eliminated: pivot k solves constraint `pivots[k].row` for freedom `pivots[k].column`.
struct IndependentFreedoms {
  using Pivot = RowReduction<Real>::Pivot;
  std::vector<Pivot> pivots;             ///< holonomic constraints first
  std::size_t holonomic = 0;             ///< how many of the pivots are of holonomic constraints
  std::vector<std::size_t> coordinates;  ///< independent ones: n less the holonomic constraints
  std::vector<std::size_t> velocities;   ///< independent ones, among those coordinates: n less all constraints
};

/// Gaussian elimination with complete pivoting of the constraints kept, at the initial configuration, in the metric of
/// the diagonal of M: the dependent freedoms are those that the constraints determine best. What the scene wants
/// independent (Scene::independent) is kept out as long as no pivot falls below 1e-4 of its row.
/// Throws SceneError naming a coordinate that is wanted but depends on those named before it.
IndependentFreedoms independent_freedoms(const Equations& equations);

}  // namespace torsor
