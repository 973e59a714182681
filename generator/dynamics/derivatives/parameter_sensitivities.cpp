// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor {
namespace {

ValueMatrix by_forward_sweeps(Program& program, const std::vector<Value>& values,
                              const std::vector<SymbolPointer>& parameters) {
  ValueMatrix result(values.size());
  for (const SymbolPointer& parameter : parameters) {
    Derivation derivation = partial_derivation(program, parameter);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Value slope = derivation(values[i]);
      result[i].push_back(program.bind(slope));
    }
  }
  return result;
}

ValueMatrix by_reverse_sweeps(Program& program, const std::vector<Value>& values,
                              const std::vector<SymbolPointer>& parameters) {
  ValueMatrix result;
  for (const Value& value : values) {
    result.emplace_back(parameters.size());
    if (value.is_zero()) continue;
    const std::vector<Value> slopes = gradient(value, parameters);
    for (std::size_t k = 0; k < slopes.size(); ++k) result.back()[k] = program.bind(slopes[k]);
  }
  return result;
}

int cost(const Program& program, const std::vector<Value>& values, const ValueMatrix& derivatives) {
  std::vector<Value> all = values;
  for (const auto& row : derivatives) all.insert(all.end(), row.begin(), row.end());
  return count(program, all).total();
}

std::vector<Value> of_unknowns(const Equations& equations) {
  const std::vector<Value>& all = equations.inverse_dynamics();
  return {all.begin(), all.begin() + equations.model().unknown_count()};
}

}  // namespace

ValueMatrix derivatives_by_parameters(const Equations& equations, const std::vector<Value>& values,
                                      const std::vector<SymbolPointer>& parameters) {
  Program& program = equations.program();
  ValueMatrix forward = by_forward_sweeps(program, values, parameters);
  if (parameters.size() <= values.size()) return forward;
  ValueMatrix reverse = by_reverse_sweeps(program, values, parameters);
  return cost(program, values, reverse) < cost(program, values, forward) ? reverse : forward;
}

std::vector<SymbolPointer> sensitivity_parameters(const Equations& equations) {
  const auto& chosen = equations.model().options().sensitive_to;
  if (!chosen) return run_time_parameters(equations.scene(), equations.model().options());
  std::vector<SymbolPointer> parameters;
  for (const ParameterContent& parameter : equations.scene().content().parameters) {
    if (chosen->contains(parameter.symbol->name)) parameters.push_back(parameter.symbol);
  }
  return parameters;
}

ValueMatrix inverse_sensitivities(const Equations& equations) {
  const std::vector<Value> forces = of_unknowns(equations);
  return derivatives_by_parameters(equations, forces, sensitivity_parameters(equations));
}

ForwardSensitivities forward_sensitivities(const Equations& equations) {
  Program& program = equations.program();
  const std::vector<SymbolPointer> parameters = sensitivity_parameters(equations);
  Substitution motion = at_motion(equations, equations.forward_by_factorisation());
  std::vector<Value> residual = of_unknowns(equations);
  const std::vector<Value> of_motors = equations.of_inputs();
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = program.bind(residual[i] - of_motors[i]);
  const ValueMatrix of_residual = derivatives_by_parameters(equations, residual, parameters);
  const std::vector<Value> rates = constraint_accelerations(equations);
  ForwardSensitivities result;
  result.accelerations.assign(residual.size(), std::vector<Value>(parameters.size()));
  result.multipliers.assign(rates.size(), std::vector<Value>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::vector<Value> residual_change;
    for (const auto& row : of_residual) {
      const Value change = motion(row[k]);
      residual_change.push_back(program.bind(change));
    }
    Derivation by_parameter = partial_derivation(program, parameters[k]);
    const std::vector<Value> constraint_change = slopes_at_motion(rates, by_parameter, motion);
    const ForwardSolution answer = answer_of_motion(equations, residual_change, constraint_change);
    result.pivots = answer.pivots;
    for (std::size_t i = 0; i < residual.size(); ++i) result.accelerations[i][k] = answer.accelerations[i];
    for (std::size_t j = 0; j < rates.size(); ++j) result.multipliers[j][k] = answer.multipliers[j];
  }
  return result;
}

}  // namespace torsor
