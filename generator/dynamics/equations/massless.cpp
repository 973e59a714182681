// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/massless.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/base/high_precision.hpp"
#include "generator/program/evaluation.hpp"
#include "generator/program/generic_state.hpp"

namespace torsor {
namespace {

constexpr int massless_digits = 80;
constexpr int massless_trials = 3;

/// Marks the unknowns whose pivot is not small at this state; one that is small is left out of what follows.
void mark_regular(std::vector<std::vector<Real>> m, std::vector<bool>& regular) {
  const Real least(Number(10).pow(-50), massless_digits);
  std::vector<Real> diagonal;
  for (std::size_t k = 0; k < m.size(); ++k) diagonal.push_back(abs(m[k][k]));
  for (std::size_t k = 0; k < m.size(); ++k) {
    if (!(abs(m[k][k]) > diagonal[k] * least)) continue;
    regular[k] = true;
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      if (m[i][k] == Real(0)) continue;
      const Real factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
}

}  // namespace

std::vector<int> massless_coordinates(const Equations& equations) {
  const WorkingDigits precision(massless_digits);
  const ValueMatrix& mass = equations.mass();
  std::vector<bool> regular(mass.size(), false);
  for (int trial = 0; trial < massless_trials; ++trial) {
    Evaluator<Real> evaluate(equations.program(), [trial](const SymbolPointer& symbol) {
      return at_unit_quaternions(symbol, [trial](const SymbolPointer& each) { return generic_value(each, trial); });
    });
    std::vector<std::vector<Real>> m;
    for (const std::vector<Value>& row : mass) m.push_back(evaluate(row));
    mark_regular(std::move(m), regular);
    if (std::find(regular.begin(), regular.end(), false) == regular.end()) break;
  }
  std::vector<int> massless;
  for (std::size_t k = 0; k < regular.size(); ++k) {
    if (!regular[k]) massless.push_back(static_cast<int>(k));
  }
  return massless;
}

std::string lack_of_mass(const Equations& equations) {
  const std::vector<int>& massless = equations.massless();
  if (massless.empty()) return "";
  std::vector<std::string> names;
  for (const int k : massless) names.push_back(equations.model().coordinates()[static_cast<std::size_t>(k)].q->name);
  return fmt::format("the mass matrix is singular at every state, because {} '{}' {} no mass; give the links mass, or fix "
                     "the joints: --fix {}, or --fix massless",
                     names.size() == 1 ? "the coordinate" : "the coordinates", fmt::join(names, "', '"),
                     names.size() == 1 ? "moves" : "move", fmt::join(names, ","));
}

void require_mass(const Equations& equations) {
  const std::string reason = lack_of_mass(equations);
  if (!reason.empty()) throw SceneError(fmt::format("'{}' cannot be solved: {}", equations.scene().name(), reason));
}

}  // namespace torsor
