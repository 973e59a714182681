// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/lagrange_derivation.hpp"

#include "torsor/generator/program/derivative.hpp"

namespace torsor {

ModelOptions LagrangeDerivation::adapted(ModelOptions options) {
  options.hold_released = false;
  return as_given(std::move(options));
}

LagrangeDerivation::LagrangeDerivation(const Scene& scene, ModelOptions options)
    : equations_(scene, adapted(std::move(options))),
      kinetic_energy_(kinetic_energy_from_positions(equations_.model())),
      operators_(lagrange_operator(equations_.model(), kinetic_energy_)) {
  const Model& model = equations_.model();
  Program& program = model.program();
  const AppliedActions& actions = equations_.actions();

  // Springs and gravity by the gradient of U, the rest by virtual power.
  std::vector<SymbolPointer> velocities;
  for (const CoordinateContent& c : model.coordinates()) velocities.push_back(c.v);
  Value u = gravity_force_function(model);
  u += actions.spring_force_function;
  forces_ = u.is_zero() ? std::vector<Value>(velocities.size()) : gradient_along(u, velocities);
  const std::vector<Value> rest = applied_forces(model, applied_actions(model, ActionKind::without_force_function));
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i] += rest[i];

  const auto n = static_cast<std::size_t>(model.unknown_count());
  Substitution at_rest(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol->kind != SymbolKind::acceleration) return std::nullopt;
    return program.number(Number(), symbol->unit);
  });
  mass_.assign(n, std::vector<Value>(n));
  for (std::size_t j = 0; j < n; ++j) {
    Derivation by_acceleration = partial_derivation(program, model.coordinates()[j].a);
    for (std::size_t i = 0; i < n; ++i) mass_[i][j] = by_acceleration(operators_[i]);
  }
  for (std::size_t i = 0; i < n; ++i) operators_at_rest_.push_back(at_rest(operators_[i]));
}

}  // namespace torsor
