// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/linearisation.hpp"

#include "generator/expression/derivative.hpp"

namespace torsor {

Linearisation linearisation(const Equations& equations) {
  Program& program = equations.program();
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const auto& inputs = equations.actions().inputs;
  const std::vector<SymbolPointer> motors = model.inputs();
  std::vector<Value> residual = equations.inverse_dynamics();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (!inputs[k][i].is_zero()) residual[i] -= inputs[k][i] * program.symbol(motors[k]);
    }
  }
  const std::vector<Value>& bias = equations.bias();
  Linearisation result;
  result.M = equations.mass();
  result.C.assign(n, std::vector<Value>(n));
  result.K = result.C;
  for (std::size_t j = 0; j < n; ++j) {
    Derivation by_velocity = partial_derivation(program, model.coordinates()[j].v);
    Derivation by_position = model.along(static_cast<int>(j));
    for (std::size_t i = 0; i < n; ++i) {
      result.C[i][j] = program.bind(by_velocity(bias[i]));
      // Friction may follow the direction of the slip.
      for (const ConstraintRow& row : equations.constraints()) {
        if (!row.friction) continue;
        const Value along_velocity = by_velocity(row.column[i]);
        result.C[i][j] = program.bind(result.C[i][j] - along_velocity * program.symbol(row.multiplier));
      }
      result.K[i][j] = program.bind(by_position(residual[i]));
    }
  }
  result.E.assign(n, std::vector<Value>(inputs.size()));
  for (std::size_t i = 0; i < n; ++i) {
    result.F.push_back(-residual[i]);
    for (std::size_t k = 0; k < inputs.size(); ++k) result.E[i][k] = inputs[k][i];
  }
  return result;
}

}  // namespace torsor
