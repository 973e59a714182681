// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/forces/selected_actions.hpp"
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/division_by_zero.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/jumps.hpp"
#include "torsor/generator/program/limits_at_roots.hpp"

namespace torsor {
namespace {

bool zero_at_rest(SymbolKind kind) { return kind == SymbolKind::velocity || kind == SymbolKind::acceleration; }

Substitution with_no_velocity(Program& program) {
  return Substitution(program, [&program](const SymbolPointer& symbol) -> std::optional<Value> {
    if (!zero_at_rest(symbol->kind)) return std::nullopt;
    return program.number(Number(), symbol->unit);
  });
}

/// Friction along a slip that vanishes at rest has no direction there: it can be anything up to its limit. A belt that runs
/// slips at rest, and a law that is smooth through rest has a value.
std::vector<const ContactFriction*> frictions_without_direction(const Model& model) {
  Program& program = model.program();
  Substitution at_rest = with_no_velocity(program);
  std::vector<const ContactFriction*> found;
  for (const ContactFriction& friction : model.scene().frictions) {
    const Vector slip = lower(program, friction.direction);
    const Value size = program.bind(friction.length.is_zero() ? dot(slip, slip) : program.lower(friction.length));
    if (identically_zero(at_rest(size))) found.push_back(&friction);
  }
  return found;
}

/// Whether an action is felt where nothing moves, as a damper is not.
bool acts_at_rest(const Model& model, const std::string& name) {
  const SelectedActions selected = selected_actions(model, {{name}, {}});
  Substitution at_rest = with_no_velocity(model.program());
  return !selected.frictions.empty() || std::any_of(selected.forces.begin(), selected.forces.end(), [&](const Value& force) {
    return !identically_zero(at_rest(force));
  });
}

/// Why the forces at rest have no force function, or what else must be known before Lejeune-Dirichlet is believed.
std::vector<std::string> remarks_on(const Equations& equations, bool from_potential, bool on_time,
                                    const std::vector<const ContactFriction*>& loose, const NaturalLanguage& say) {
  std::vector<std::string> names;
  for (const std::string& name : equations.actions().without_force_function) {
    const bool left_out = std::any_of(loose.begin(), loose.end(), [&](const auto* friction) { return friction->name == name; });
    if (from_potential || (!left_out && acts_at_rest(equations.model(), name))) names.push_back(fmt::format("'{}'", name));
  }
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const bool one = names.size() == 1;
  if (!from_potential) {
    if (names.empty() && on_time) return {say("the forces at rest do not derive from U + T0: T depends on time explicitly")};
    return {names.empty() ? say("the forces at rest do not derive from U + T0")
            : one         ? say("the forces at rest do not derive from U + T0: {} acts at rest", list)
                          : say("the forces at rest do not derive from U + T0: {} act at rest", list)};
  }
  if (names.empty()) return {};
  return {one ? say("Lejeune-Dirichlet presupposes that {} dissipates and that inputs are zero", list)
              : say("Lejeune-Dirichlet presupposes that {} dissipate and that inputs are zero", list)};
}

}  // namespace

bool depend_on_time(const Model& model, const std::vector<Value>& values) {
  const SymbolPointer& time = model.scene().time;
  Derivation by_time = partial_derivation(model.program(), time);
  return std::any_of(values.begin(), values.end(), [&](const Value& value) {
    return !value.is_zero() && (!identically_zero(by_time(value)) || jumps_along(value, time));
  });
}

EquilibriumEquations equilibrium_equations(const Equations& equations, const NaturalLanguage& say) {
  const Model& model = equations.model();
  Program& program = model.program();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  Substitution at_rest = with_no_velocity(program);
  const std::vector<const ContactFriction*> loose = frictions_without_direction(model);
  EquilibriumEquations result;
  std::vector<Value> forces;
  for (std::size_t i = 0; i < n; ++i) {
    const Value force = at_rest(equations.bias()[i]);
    forces.push_back(program.bind(force));
    result.freedoms.push_back(model.coordinates()[i].v);
  }
  result.rows = forces;
  for (const ConstraintRow& row : equations.constraints()) {
    const Value lambda = program.symbol(row.multiplier);
    const bool leaves_out = std::any_of(loose.begin(), loose.end(), [&](const ContactFriction* friction) {
      return model.scene().constraints[static_cast<std::size_t>(friction->constraint)].multiplier == row.multiplier;
    });
    for (std::size_t i = 0; i < n; ++i) {
      const Value column = at_rest(leaves_out ? row.ideal[i] : row.column[i]);
      if (!column.is_zero()) result.rows[i] -= column * lambda;
    }
    if (row.holonomic && !identically_zero(row.value)) result.conditions.push_back(row.value);
    const Value imposed = at_rest(row.rate);
    if (!identically_zero(imposed)) result.conditions.push_back(imposed);
  }
  const std::vector<SymbolPointer> motors = model.inputs();
  for (std::size_t k = 0; k < motors.size(); ++k) {
    const Value input = program.symbol(motors[k]);
    for (std::size_t i = 0; i < n; ++i) {
      const Value effect = at_rest(equations.actions().inputs[k][i]);
      if (!effect.is_zero()) result.rows[i] -= effect * input;
    }
  }

  const Value kinetic = kinetic_energy(model);
  const Value t0 = at_rest(kinetic);
  result.driven = !identically_zero(t0);
  const Value gravity = gravity_force_function(model);
  result.potential = -gravity;
  result.potential -= equations.actions().spring_force_function;
  if (result.driven) result.potential -= t0;
  std::vector<Value> all = result.rows;
  all.insert(all.end(), result.conditions.begin(), result.conditions.end());
  // T0 and U act by their slopes, which the rows hold: what depends on time alone is of no matter.
  const Value of_rates = kinetic - t0;
  all.push_back(of_rates);
  result.depends_on_time = depend_on_time(model, all);
  std::vector<Value> differences = forces;
  // Differentiated as the actions are: selections in their forces are then the same definitions and leave nothing.
  std::vector<Value> slopes(n);
  if (!result.potential.is_zero()) slopes = gradient_along(result.potential, result.freedoms);
  result.mass = equations.mass();
  result.hessian.assign(n, {});
  for (std::size_t j = 0; j < n; ++j) {
    Derivation along = model.along(static_cast<int>(j));
    if (!slopes[j].is_zero()) differences[j] -= at_rest(slopes[j]);
    for (std::size_t i = 0; i < n; ++i) {
      const Value entry = along(result.rows[i]);
      result.hessian[i].push_back(program.bind(entry));
    }
  }
  const std::vector<bool> same = identically_zero_entries(differences);
  result.from_potential = std::all_of(same.begin(), same.end(), [](bool each) { return each; });
  result.remarks = remarks_on(equations, result.from_potential, result.depends_on_time, loose, say);
  for (const ContactFriction* friction : loose) {
    result.remarks.push_back(
        say("At rest the friction '{}' can be anything up to its limit, and is left out: more states than these are rests",
            friction->name));
  }
  return result;
}

std::string print_equilibrium(const EquilibriumEquations& statics) {
  std::string text;
  if (statics.from_potential) {
    text += fmt::format("{} = {}\n", statics.driven ? "-(U + T0)" : "-U", readable(multiplied_out(statics.potential)));
  }
  for (const std::string& remark : statics.remarks) text += remark + "\n";
  for (std::size_t i = 0; i < statics.rows.size(); ++i) {
    std::string name = statics.freedoms[i]->name;
    while (!name.empty() && name.back() == '\'') name.pop_back();
    text += fmt::format("{}:  0 = {}\n", name, readable(multiplied_out(statics.rows[i])));
  }
  for (const Value& condition : statics.conditions) {
    text += fmt::format("0 = {}\n", readable(multiplied_out(condition)));
  }
  return text;
}

AtState::AtState(const Equations& equations, Named state) : program_(&equations.program()) {
  for (const auto& [what, formula] : state) {
    const SymbolPointer symbol = what.as_symbol();
    if (!symbol) {
      throw UsageError(fmt::format("'{}' is no symbol whose value a state can give: name a coordinate or a velocity",
                                   what.to_string()));
    }
    if (!formula.is_zero() && !(formula.unit() == symbol->unit)) {
      throw UnitError(fmt::format("the state {} = {} has the unit {} and must be in {}", symbol->name,
                                  formula.to_string(), formula.unit().to_string(), symbol->unit.to_string()));
    }
    const Value value = program_->lower(formula);
    state_.emplace_back(symbol, value.is_zero() ? program_->number(Number(), symbol->unit) : value);
  }
}

Value AtState::operator()(const Value& value) const { return (*this)(std::vector<Value>{value})[0]; }

std::vector<Value> AtState::operator()(const std::vector<Value>& values) const {
  Substitution substitution(*program_, [this](const SymbolPointer& symbol) -> std::optional<Value> {
    for (const auto& [known, replacement] : state_) {
      if (known == symbol) return replacement;
    }
    if (!zero_at_rest(symbol->kind)) return std::nullopt;
    return program_->number(Number(), symbol->unit);
  });
  std::vector<Value> result;
  try {
    for (const Value& value : with_limits_at_roots(*program_, values)) result.push_back(substitution(value));
  } catch (const DivisionByZero&) {
    throw UsageError(no_value_at_state);
  }
  return result;
}

ValueMatrix AtState::operator()(const ValueMatrix& matrix) const {
  ValueMatrix result;
  for (const std::vector<Value>& row : matrix) result.push_back((*this)(row));
  return result;
}

}  // namespace torsor
