// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/independent_freedoms.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/base/error.hpp"

namespace torsor {
namespace {

class FreedomElimination {
 public:
  FreedomElimination(std::vector<std::vector<Real>> rows, std::size_t freedoms)
      : rows_(std::move(rows)), dependent_(freedoms, false) {}

  /// Eliminates the rows one by one, best pivot first, with freedoms that are not `excluded`; false when none is left
  /// that is worth it.
  bool run(std::vector<std::size_t> rows, const std::vector<bool>& excluded) {
    while (!rows.empty()) {
      Real best = Real::from_double(1e-4);
      std::size_t place = rows.size();
      std::size_t freedom = 0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t i = 0; i < dependent_.size(); ++i) {
          if (dependent_[i] || excluded[i]) continue;
          const Real size = abs(rows_[rows[k]][i]);
          if (!(size > best)) continue;
          best = size * Real::from_double(1.000001);  // the first of equals, whatever the rounding
          place = k;
          freedom = i;
        }
      }
      if (place == rows.size()) return false;
      const std::size_t row = rows[place];
      for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (r == row || used(r) || rows_[r][freedom].is_zero()) continue;
        const Real factor = rows_[r][freedom] / rows_[row][freedom];
        for (std::size_t i = 0; i < dependent_.size(); ++i) rows_[r][i] -= factor * rows_[row][i];
      }
      pivots.push_back({row, freedom});
      dependent_[freedom] = true;
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(place));
    }
    return true;
  }

  std::vector<std::size_t> independent() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < dependent_.size(); ++i) {
      if (!dependent_[i]) all.push_back(i);
    }
    return all;
  }

  std::vector<IndependentFreedoms::Pivot> pivots;

 private:
  bool used(std::size_t row) const {
    return std::any_of(pivots.begin(), pivots.end(), [row](const auto& pivot) { return pivot.row == row; });
  }

  std::vector<std::vector<Real>> rows_;
  std::vector<bool> dependent_;
};

}  // namespace

IndependentFreedoms independent_freedoms(const Equations& equations) {
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const ConstraintRank& rank = equations.redundancy();
  std::vector<std::size_t> holonomic, others;
  for (const std::size_t j : rank.kept) (equations.constraints()[j].holonomic ? holonomic : others).push_back(j);

  FreedomElimination elimination(rank.scaled_rows, n);
  const auto eliminate = [&](const std::vector<std::size_t>& rows, const std::vector<bool>& excluded) {
    FreedomElimination attempt = elimination;
    const bool possible = attempt.run(rows, excluded);
    return possible ? std::optional<FreedomElimination>(attempt) : std::nullopt;
  };
  std::vector<bool> wanted(n, false);
  std::vector<std::size_t> order;
  for (const SymbolPointer& q : model.scene().independent) {
    for (std::size_t i = 0; i < n; ++i) {
      if (model.coordinates()[i].q == q && !wanted[i]) order.push_back(i);
    }
    wanted[order.back()] = true;
    if (eliminate(holonomic, wanted)) continue;
    throw SceneError(
        fmt::format("coordinate '{}' cannot be independent beside those named before it: the constraints "
                    "determine it, or nearly, at the initial configuration; leave it out of independent(...)",
                    q->name));
  }
  const auto settle = [&](const std::vector<std::size_t>& rows, const std::vector<bool>& excluded) {
    const auto chosen = eliminate(rows, excluded);
    if (!chosen) {
      throw SceneError(
          fmt::format("no choice of independent coordinates of the scene '{}' determines the others at the "
                      "initial configuration: it is singular; start elsewhere",
                      equations.scene().name()));
    }
    elimination = *chosen;
  };
  settle(holonomic, wanted);
  IndependentFreedoms result;
  result.holonomic = holonomic.size();
  result.coordinates = elimination.independent();
  std::vector<bool> moving(n, false);
  for (const std::size_t i : order) {
    moving[i] = true;
    if (!eliminate(others, moving)) moving[i] = false;
  }
  settle(others, moving);
  result.velocities = elimination.independent();
  result.pivots = elimination.pivots;
  return result;
}

}  // namespace torsor
