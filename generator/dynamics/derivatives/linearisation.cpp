// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"

#include <optional>

#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/dynamics/recursions/inertia_derivatives.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor {
namespace {

/// Definition by definition costs more and more with the number of joints, to run and to generate; a few joints leave
/// so little that it may win.
constexpr int few = 4;

bool recursion_fits(const Equations& equations) {
  return equations.actions().wrenches.empty() && has_simple_joints(equations.model());
}

/// −Q: what the residual has besides inertia, gravity and applied wrenches.
std::vector<Value> opposite_efforts(const Equations& equations, Inputs inputs) {
  Program& program = equations.program();
  const AppliedActions& actions = equations.actions();
  const std::vector<Value> of_motors = equations.of_inputs();
  std::vector<Value> all(of_motors.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] -= actions.passive[i];
    for (const ConstraintRow& row : equations.constraints()) {
      if (!row.column[i].is_zero()) all[i] -= row.column[i] * program.symbol(row.multiplier);
    }
    if (inputs == Inputs::act) all[i] -= of_motors[i];
    all[i] = program.bind(all[i]);
  }
  return all;
}

void add_derivatives(const Equations& equations, const std::vector<Value>& forces, ForceDerivatives& sum) {
  Program& program = equations.program();
  for (std::size_t j = 0; j < forces.size(); ++j) {
    Derivation by_velocity = partial_derivation(program, equations.model().coordinates()[j].v);
    Derivation by_position = equations.model().along(static_cast<int>(j));
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (forces[i].is_zero()) continue;
      const Value damping = by_velocity(forces[i]);
      sum.by_velocity[i][j] = program.bind(sum.by_velocity[i][j] + damping);
      const Value stiffness = by_position(forces[i]);
      sum.by_position[i][j] = program.bind(sum.by_position[i][j] + stiffness);
    }
  }
}

ForceDerivatives no_derivatives(const Equations& equations) {
  const auto n = static_cast<std::size_t>(equations.model().unknown_count());
  ForceDerivatives none;
  none.by_position.assign(n, std::vector<Value>(n));
  none.by_velocity = none.by_position;
  return none;
}

/// The whole residual, definition by definition.
ForceDerivatives differentiated(const Equations& equations, Inputs inputs) {
  const auto n = static_cast<std::size_t>(equations.model().unknown_count());
  std::vector<Value> residual(equations.inverse_dynamics().begin(),
                              equations.inverse_dynamics().begin() + equations.model().unknown_count());
  const std::vector<Value> of_motors = equations.of_inputs();
  for (std::size_t i = 0; i < n && inputs == Inputs::act; ++i) residual[i] -= of_motors[i];
  ForceDerivatives result = no_derivatives(equations);
  add_derivatives(equations, residual, result);
  return result;
}

/// Operations beside those of the residual itself.
int cost(const Equations& equations, const ForceDerivatives& derivatives) {
  std::vector<Value> all = equations.inverse_dynamics();
  for (const ValueMatrix* matrix : {&derivatives.by_position, &derivatives.by_velocity}) {
    for (const auto& row : *matrix) all.insert(all.end(), row.begin(), row.end());
  }
  return count(equations.program(), all).total();
}

/// −r by inverse dynamics, which costs least alone, or of the wrenches that the recursion of the derivatives needs too:
/// whichever takes fewer operations beside them.
std::vector<Value> cheapest_rest(const Equations& equations, const Linearisation& beside) {
  Program& program = equations.program();
  const Model& model = equations.model();
  const std::vector<Value> of_motors = equations.of_inputs();
  std::vector<Value> alone, shared;
  for (std::size_t i = 0; i < of_motors.size(); ++i) alone.push_back(of_motors[i] - equations.inverse_dynamics()[i]);
  if (!recursion_fits(equations) || model.unknown_count() <= few) return alone;
  const std::vector<Value> inertia = inertia_forces(model.regrouped(), AccelerationInput::symbols, {});
  const std::vector<Value> opposite = opposite_efforts(equations, Inputs::act);
  for (std::size_t i = 0; i < alone.size(); ++i) shared.push_back(program.bind(-(inertia[i] + opposite[i])));
  const auto total = [&](const std::vector<Value>& rest) {
    std::vector<Value> all = rest;
    for (const ValueMatrix* matrix : {&beside.M, &beside.C, &beside.K}) {
      for (const auto& row : *matrix) all.insert(all.end(), row.begin(), row.end());
    }
    return count(program, all).total();
  };
  return total(shared) < total(alone) ? shared : alone;
}

}  // namespace

ForceDerivatives effort_derivatives(const Equations& equations, Inputs inputs) {
  ForceDerivatives result = no_derivatives(equations);
  add_derivatives(equations, opposite_efforts(equations, inputs), result);
  return result;
}

ForceDerivatives residual_derivatives(const Equations& equations, Inputs inputs) {
  const Model& model = equations.model();
  const bool fits = recursion_fits(equations);
  std::optional<ForceDerivatives> by_definition;
  if (!fits || model.unknown_count() <= few) by_definition = differentiated(equations, inputs);
  if (!fits) return *by_definition;
  ForceDerivatives by_recursion = inertia_derivatives(model.regrouped());
  add_derivatives(equations, opposite_efforts(equations, inputs), by_recursion);
  if (!by_definition || cost(equations, by_recursion) < cost(equations, *by_definition)) return by_recursion;
  return *by_definition;
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
  result.F = cheapest_rest(equations, result);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < inputs.size(); ++k) result.E[i][k] = inputs[k][i];
  }
  return result;
}

}  // namespace torsor
