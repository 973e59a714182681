// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/linearisation.hpp"

#include "generator/dynamics/articulated_body.hpp"
#include "generator/dynamics/inertia_derivatives.hpp"
#include "generator/expression/derivative.hpp"

namespace torsor {
namespace {

/// (E u)_i.
Value of_inputs(const Equations& equations, std::size_t i) {
  const std::vector<SymbolPointer> motors = equations.model().inputs();
  Value sum;
  for (std::size_t k = 0; k < motors.size(); ++k) {
    const Value& partial = equations.actions().inputs[k][i];
    if (!partial.is_zero()) sum += partial * equations.program().symbol(motors[k]);
  }
  return sum;
}

/// −Q: what the residual has besides inertia, gravity and applied wrenches.
std::vector<Value> opposite_efforts(const Equations& equations, Inputs inputs) {
  Program& program = equations.program();
  const AppliedActions& actions = equations.actions();
  std::vector<Value> all(static_cast<std::size_t>(equations.model().unknown_count()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] -= actions.passive[i];
    for (const ConstraintRow& row : equations.constraints()) {
      if (!row.column[i].is_zero()) all[i] -= row.column[i] * program.symbol(row.multiplier);
    }
    if (inputs == Inputs::act) all[i] -= of_inputs(equations, i);
    all[i] = program.bind(all[i]);
  }
  return all;
}

}  // namespace

ForceDerivatives residual_derivatives(const Equations& equations, Inputs inputs) {
  Program& program = equations.program();
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  ForceDerivatives result;
  std::vector<Value> rest;  // what is left to differentiate definition by definition
  if (equations.actions().wrenches.empty() && has_simple_joints(model)) {
    result = inertia_derivatives(model);
    rest = opposite_efforts(equations, inputs);
  } else {
    result.by_position.assign(n, std::vector<Value>(n));
    result.by_velocity = result.by_position;
    rest = equations.inverse_dynamics();
    for (std::size_t i = 0; i < n && inputs == Inputs::act; ++i) rest[i] -= of_inputs(equations, i);
  }
  for (std::size_t j = 0; j < n; ++j) {
    Derivation by_velocity = partial_derivation(program, model.coordinates()[j].v);
    Derivation by_position = model.along(static_cast<int>(j));
    for (std::size_t i = 0; i < n; ++i) {
      if (rest[i].is_zero()) continue;
      const Value damping = by_velocity(rest[i]);
      result.by_velocity[i][j] = program.bind(result.by_velocity[i][j] + damping);
      const Value stiffness = by_position(rest[i]);
      result.by_position[i][j] = program.bind(result.by_position[i][j] + stiffness);
    }
  }
  return result;
}

Linearisation linearisation(const Equations& equations) {
  const auto n = static_cast<std::size_t>(equations.model().unknown_count());
  const auto& inputs = equations.actions().inputs;
  Linearisation result;
  ForceDerivatives residual = residual_derivatives(equations, Inputs::act);
  result.C = std::move(residual.by_velocity);
  result.K = std::move(residual.by_position);
  result.M = equations.mass();
  result.E.assign(n, std::vector<Value>(inputs.size()));
  for (std::size_t i = 0; i < n; ++i) {
    result.F.push_back(of_inputs(equations, i) - equations.inverse_dynamics()[i]);
    for (std::size_t k = 0; k < inputs.size(); ++k) result.E[i][k] = inputs[k][i];
  }
  return result;
}

}  // namespace torsor
