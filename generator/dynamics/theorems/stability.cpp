// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/theorems/stability.hpp"

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/dynamics/theorems/flat_polynomials.hpp"

namespace torsor {

std::vector<Value> sylvester_conditions(Program& program, const ValueMatrix& matrix) {
  std::vector<Value> conditions;
  for (std::size_t size = 1; size <= matrix.size(); ++size) {
    ValueMatrix leading;
    for (std::size_t i = 0; i < size; ++i) {
      leading.emplace_back(matrix[i].begin(), matrix[i].begin() + static_cast<std::ptrdiff_t>(size));
    }
    conditions.push_back(determinant(program, leading));
  }
  return conditions;
}

LejeuneDirichlet lejeune_dirichlet(const Equations& equations, const EquilibriumEquations& statics,
                                   const Evaluator<Real>::SymbolValue& state) {
  if (!equations.constraints().empty()) {
    throw UsageError(
        fmt::format("Lejeune-Dirichlet is asked of '{}', which has constraints: describe it with independent "
                    "coordinates, or let the runtime project the Hessian on its tangent space",
                    equations.scene().name()));
  }
  Evaluator<Real> evaluate(equations.program(), state);
  LejeuneDirichlet report;
  report.residual = evaluate(statics.rows);
  if (!statics.from_potential) {
    report.reason = "cannot conclude: " + statics.remarks.front();
    return report;
  }
  const std::size_t n = statics.hessian.size();
  std::vector<std::vector<Real>> h;
  for (const std::vector<Value>& row : statics.hessian) h.push_back(evaluate(row));
  const std::vector<std::vector<Real>> given = h;
  for (std::size_t k = 0; k < n; ++k) {
    const Real pivot = h[k][k];
    report.pivots.push_back(pivot);
    const Real least = Real(static_cast<int>(n)) * abs(given[k][k]) * pivot.epsilon();
    if (!(pivot > least)) {
      const bool zero = abs(pivot) <= least;
      report.reason = fmt::format("cannot conclude: pivot {} of the Hessian of -(U + T0) is {}{}", k + 1,
                                  pivot.to_string(6), zero ? ", zero within rounding" : ", not a minimum");
      return report;
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = h[i][k] / pivot;
      for (std::size_t j = k + 1; j < n; ++j) h[i][j] -= factor * h[k][j];
    }
  }
  report.stable = true;
  report.reason = "stable: -(U + T0) has a strict minimum";
  if (!statics.remarks.empty()) report.reason += "; " + statics.remarks.front();
  return report;
}

}  // namespace torsor
