// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/independent_freedoms.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/row_reduction.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"

namespace torsor {
namespace {

using Elimination = RowReduction<Real>;

/// Eliminates those rows one by one, best pivot first, with freedoms that are not `excluded`; false when none is left
/// that is worth it.
bool eliminate(Elimination& elimination, std::vector<std::size_t> rows, const std::vector<bool>& excluded) {
  while (!rows.empty()) {
    Real best = Real::from_double(zero_tests::freedom_part);
    std::optional<std::pair<std::size_t, std::size_t>> found;  // place in `rows`, freedom
    for (std::size_t k = 0; k < rows.size(); ++k) {
      for (std::size_t i = 0; i < excluded.size(); ++i) {
        if (elimination.has_pivot(i) || excluded[i]) continue;
        const Real size = abs(elimination(rows[k], i));
        if (!(size > best)) continue;
        best = size * Real::from_double(zero_tests::as_large);
        found.emplace(k, i);
      }
    }
    if (!found) return false;
    elimination.take({rows[found->first], found->second});
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(found->first));
  }
  return true;
}

std::vector<std::size_t> freedoms_left(const Elimination& elimination, std::size_t freedoms) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < freedoms; ++i) {
    if (!elimination.has_pivot(i)) all.push_back(i);
  }
  return all;
}

}  // namespace

IndependentFreedoms independent_freedoms(const Equations& equations) {
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const ConstraintRank& rank = equations.redundancy();
  std::vector<std::size_t> holonomic, others;
  for (const std::size_t j : rank.kept) (equations.constraints()[j].holonomic ? holonomic : others).push_back(j);

  Elimination elimination(rank.scaled_rows, n);
  const auto possible = [&](const std::vector<std::size_t>& rows, const std::vector<bool>& excluded) {
    Elimination attempt = elimination;
    return eliminate(attempt, rows, excluded);
  };
  std::vector<bool> wanted(n, false);
  std::vector<std::size_t> order;
  for (const SymbolPointer& q : model.scene().independent) {
    for (std::size_t i = 0; i < n; ++i) {
      if (model.coordinates()[i].q == q && !wanted[i]) order.push_back(i);
    }
    wanted[order.back()] = true;
    if (possible(holonomic, wanted)) continue;
    throw SceneError(
        fmt::format("coordinate '{}' cannot be independent beside those named before it: the constraints "
                    "determine it, or nearly, at the initial configuration; leave it out of independent(...)",
                    q->name));
  }
  const auto settle = [&](const std::vector<std::size_t>& rows, const std::vector<bool>& excluded) {
    if (eliminate(elimination, rows, excluded)) return;
    throw SceneError(
        fmt::format("no choice of independent coordinates of the scene '{}' determines the others at the "
                    "initial configuration: it is singular; start elsewhere",
                    equations.scene().name()));
  };
  settle(holonomic, wanted);
  IndependentFreedoms result;
  result.holonomic = holonomic.size();
  result.coordinates = freedoms_left(elimination, n);
  std::vector<bool> moving(n, false);
  for (const std::size_t i : order) {
    moving[i] = true;
    if (!possible(others, moving)) moving[i] = false;
  }
  settle(others, moving);
  result.velocities = freedoms_left(elimination, n);
  result.pivots = elimination.pivots();
  return result;
}

}  // namespace torsor
