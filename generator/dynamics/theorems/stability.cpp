// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/stability.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/program/sized.hpp"

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

namespace {

/// What cancels is 0 and not a rounding of either sign.
RealRows numbers_of(const ValueMatrix& matrix, Evaluator<Sized>& sized) {
  RealRows rows;
  for (const std::vector<Value>& row : matrix) {
    rows.emplace_back();
    for (const Sized& entry : sized(row)) rows.back().push_back(entry.cancels() ? Real(0) : entry.value);
  }
  return rows;
}

SymmetricPivots pivots_of(const RealRows& matrix) {
  return SymmetricPivots(matrix, Real(matrix.size()) * Real(1).epsilon());
}

/// "q1, q2": the coordinates of the first motion of a singular M that has no kinetic energy.
std::string without_kinetic_energy(const SymmetricPivots& mass, const std::vector<SymbolPointer>& rates) {
  const RealRow others = mass.dependence();
  std::string names;
  for (std::size_t i = 0; i <= mass.first_small(); ++i) {
    if (i < mass.first_small() && is_negligible(others[i])) continue;
    std::string name = rates[i]->name;
    while (!name.empty() && name.back() == '\'') name.pop_back();
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

LejeuneDirichlet lejeune_dirichlet(const Equations& equations, const EquilibriumEquations& statics,
                                   const Evaluator<Real>::SymbolValue& state, const NaturalLanguage& say) {
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
    report.reason = say("cannot conclude: {}", statics.remarks.front());
    return report;
  }
  if (statics.depends_on_time) {
    report.reason = say("cannot conclude: T or U depends on time explicitly, and the energy is no integral");
    return report;
  }
  Evaluator<Sized> sized(equations.program(), [&](const SymbolPointer& symbol) { return Sized(state(symbol)); });
  const SymmetricPivots pivots = pivots_of(numbers_of(statics.hessian, sized));
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    report.pivots.push_back(pivots[k]);
    if (pivots[k] > Real(0) && !pivots.is_small(k)) continue;
    report.reason = say("cannot conclude: pivot {} of the Hessian of -(U + T0) is {}{}", k + 1, pivots[k].to_string(6),
                        pivots.is_small(k) ? say(", zero within rounding") : say(", not a minimum"));
    return report;
  }
  const SymmetricPivots mass = pivots_of(numbers_of(statics.mass, sized));
  for (std::size_t k = 0; k < mass.size(); ++k) {
    if (mass.is_small(k) || mass[k] > Real(0)) continue;
    report.reason = say("cannot conclude: pivot {} of M is {}, and T can be negative", k + 1, mass[k].to_string(6));
    return report;
  }
  if (mass.first_small() < mass.size()) {
    report.reason = say(
        "-(U + T0) has a strict minimum, and positions stay near it; cannot conclude on rates: M is singular in {}",
        without_kinetic_energy(mass, statics.freedoms));
    return report;
  }
  report.stable = true;
  report.reason = say("stable: -(U + T0) has a strict minimum");
  if (!statics.remarks.empty()) report.reason += "; " + statics.remarks.front();
  return report;
}

}  // namespace torsor
