// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/massless.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

constexpr int massless_trials = 3;

}  // namespace

std::vector<int> massless_coordinates(const Equations& equations) {
  const WorkingDigits precision(zero_tests::masses.digits);
  const ValueMatrix& mass = equations.mass();
  std::vector<bool> regular(mass.size(), false);
  for (int trial = 0; trial < massless_trials; ++trial) {
    Evaluator<Real> evaluate(equations.program(), [trial](const SymbolPointer& symbol) {
      return at_unit_quaternions(symbol, [trial](const SymbolPointer& each) { return generic_value(each, trial); });
    });
    RealRows m;
    for (const std::vector<Value>& row : mass) m.push_back(evaluate(row));
    const SymmetricPivots pivots(std::move(m), zero_tests::masses.bound());
    for (std::size_t k = 0; k < regular.size(); ++k) regular[k] = regular[k] || !pivots.is_small(k);
    if (std::find(regular.begin(), regular.end(), false) == regular.end()) break;
  }
  std::vector<int> massless;
  for (std::size_t k = 0; k < regular.size(); ++k) {
    if (!regular[k]) massless.push_back(static_cast<int>(k));
  }
  return massless;
}

std::string lack_of_mass(const Equations& equations, const NaturalLanguage& say) {
  const std::vector<int>& massless = equations.massless();
  if (massless.empty()) return "";
  std::vector<std::string> names;
  for (const int k : massless) names.push_back(equations.model().coordinates()[static_cast<std::size_t>(k)].q->name);
  const std::string quoted = fmt::format("{}", fmt::join(names, "', '")), fixed = fmt::format("{}", fmt::join(names, ","));
  const std::string what =
      names.size() == 1 ? say("the mass matrix is singular at every state, because the coordinate '{}' moves no mass", quoted)
                        : say("the mass matrix is singular at every state, because the coordinates '{}' move no mass", quoted);
  if (equations.scene().content().origin.file.empty()) {
    return say("{}; give what they move a mass, drive them by a law, or release them", what);
  }
  return say("{}; give the links mass, or fix the joints: --fix {}, or --fix massless", what, fixed);
}

void require_mass(const Equations& equations) {
  const std::string reason = lack_of_mass(equations);
  if (!reason.empty()) throw SceneError(fmt::format("'{}' cannot be solved: {}", equations.scene().name(), reason));
}

}  // namespace torsor
