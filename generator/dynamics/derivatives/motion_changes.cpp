// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"

#include <optional>

namespace torsor {

Substitution at_motion(const Equations& equations, const ForwardSolution& motion) {
  return {equations.program(), [&equations, motion](const SymbolPointer& symbol) -> std::optional<Value> {
            const auto n = static_cast<std::size_t>(equations.model().unknown_count());
            for (std::size_t i = 0; i < n; ++i) {
              if (symbol == equations.model().coordinates()[i].a) return motion.accelerations[i];
            }
            for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
              if (symbol == equations.constraints()[j].multiplier) return motion.multipliers[j];
            }
            return std::nullopt;
          }};
}

std::vector<Value> constraint_accelerations(const Equations& equations) {
  const Model& model = equations.model();
  std::vector<Value> all;
  for (const ConstraintRow& row : equations.constraints()) {
    Value sum = row.gamma;
    for (int i = 0; i < model.unknown_count(); ++i) {
      const Value& entry = row.jacobian[static_cast<std::size_t>(i)];
      if (!entry.is_zero()) sum += entry * model.a(i);
    }
    all.push_back(equations.program().bind(sum));
  }
  return all;
}

std::vector<Value> slopes_at_motion(const std::vector<Value>& values, Derivation& by, Substitution& motion) {
  std::vector<Value> all;
  for (const Value& value : values) {
    const Value slope = by(value);
    const Value there = motion(slope);
    all.push_back(there.is_zero() ? there : there.program()->bind(there));
  }
  return all;
}

ForwardSolution answer_of_motion(const Equations& equations, const std::vector<Value>& residual_change,
                                 const std::vector<Value>& constraint_change) {
  Program& program = equations.program();
  std::vector<Value> force;
  for (const Value& change : residual_change) force.push_back(program.bind(-change));
  return equations.solve(force, constraint_change);
}

}  // namespace torsor
