// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/painleve.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/theorems/force_function.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/jumps.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

/// Σ Q_i q̇_i of generalised forces over the unknowns.
Value power_along(const Model& model, const std::vector<Value>& forces) {
  Value sum;
  for (int i = 0; i < model.unknown_count(); ++i) {
    const Value& force = forces[static_cast<std::size_t>(i)];
    if (!force.is_zero()) sum += force * model.v(i);
  }
  return sum;
}

/// A force by formula: it may have a force function that nobody wrote down.
bool is_given_force(const ActionContent& action) {
  return std::holds_alternative<GivenForce>(action) || std::holds_alternative<GivenTorque>(action) ||
         std::holds_alternative<GivenWrench>(action) || std::holds_alternative<GeneralisedForce>(action) ||
         std::holds_alternative<MutualAction>(action);
}

struct Power {
  std::string name;
  Value power;
  bool by_formula = false;
};

struct WorkingActions {
  std::vector<std::string> without;   ///< those that have no force function
  std::vector<std::string> unstated;  ///< those that have one, which the scene does not state
};

/// The actions given without a force function whose power Σ Q_i q̇_i does not vanish identically, friction included;
/// none where that of all together vanishes: a force across the velocity, or two opposite ones. In a program of its own:
/// kernels want none of these definitions.
WorkingActions working_actions(const Equations& asked) {
  if (asked.actions().without_force_function.empty()) return {};
  const Equations equations(asked.scene(), asked.model().options());
  const Model& model = equations.model();
  std::vector<Power> powers;
  std::size_t motor = 0;
  for (const ActionContent& action : model.scene().actions) {
    if (has_force_function(action)) continue;
    if (const Motor* driving = std::get_if<Motor>(&action)) {
      const Value arm = power_along(model, equations.actions().inputs[motor++]);
      powers.push_back({driving->name, arm.is_zero() ? arm : model.program().symbol(driving->input) * arm});
      continue;
    }
    const AppliedActions one = applied_actions(model, [&](const ActionContent& other) { return &other == &action; });
    powers.push_back({name_of(action), power_along(model, applied_forces(model, one)), is_given_force(action)});
  }
  for (const ConstraintRow& row : equations.constraints()) {
    if (!row.friction) continue;
    std::vector<Value> forces = row.column;
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] -= row.ideal[i];
    const Value power = model.program().symbol(row.multiplier) * power_along(model, forces);
    for (const ContactFriction& friction : model.scene().frictions) {
      const auto& normal = model.scene().constraints[static_cast<std::size_t>(friction.constraint)];
      if (normal.multiplier == row.multiplier) powers.push_back({friction.name, power});
    }
  }
  Value sum;
  std::vector<Value> each;
  for (const Power& of : powers) {
    sum += of.power;
    each.push_back(of.power);
  }
  each.push_back(sum);
  const std::vector<bool> silent = identically_zero_entries(each);
  WorkingActions working;
  std::vector<std::string> given;  // that have none of their own
  for (std::size_t k = 0; k < powers.size() && !silent.back(); ++k) {
    if (silent[k]) continue;
    const auto& [name, power, by_formula] = powers[k];
    const bool has_one = by_formula && force_function_case(equations, {{name}, {}}) != ForceFunctionCase::none;
    if (by_formula && !has_one) given.push_back(name);
    (has_one ? working.unstated : working.without).push_back(name);
  }
  // Two forces may have one function together.
  if (given.size() > 1 && force_function_case(equations, {given, {}}) != ForceFunctionCase::none) {
    std::erase_if(working.without, [&](const std::string& name) { return std::find(given.begin(), given.end(), name) != given.end(); });
    working.unstated.insert(working.unstated.end(), given.begin(), given.end());
  }
  return working;
}

/// Momenta of cyclic coordinates, as rows of M v: there what a body's own axes mix has fallen out already, so that
/// rounding is that of the terms which matter. `at_rest` are the momenta where every v is zero (driven mechanisms).
struct KineticGradients {
  std::vector<Value> momenta;  ///< ∂T/∂v
  std::vector<Value> along_q;  ///< ∂T/∂q, along the moving axes of an attitude
};

std::vector<FirstIntegral> conserved_momenta(const Equations& equations, const KineticGradients& of_t,
                                             Substitution& at_rest, const NaturalLanguage& say) {
  const auto& [momenta, along_q] = of_t;
  std::vector<FirstIntegral> conserved;
  const Model& model = equations.model();
  const std::vector<Value> applied = applied_forces(model, equations.actions());
  const Value gravity = gravity_force_function(model);
  const std::vector<Value> turning = turning_terms(model, momenta);
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i) {
    const SymbolPointer& q = model.coordinates()[i].q;
    const auto& inputs = equations.actions().inputs;
    const auto& rows = equations.constraints();
    const bool worked_on =
        std::any_of(inputs.begin(), inputs.end(), [i](const auto& input) { return !input[i].is_zero(); }) ||
        std::any_of(rows.begin(), rows.end(),
                    [i](const ConstraintRow& row) { return !identically_zero(row.column[i]); });
    if (worked_on || !identically_zero(along_q[i]) || momenta[i].is_zero()) continue;
    Value force = applied[i];
    if (!gravity.is_zero()) force += model.along(static_cast<int>(i))(gravity);
    force -= turning[i];
    if (!identically_zero(force)) continue;
    const Unit unit = units::joule / model.coordinates()[i].v->unit;
    const std::string meaning = !model.coordinates()[i].attitude
                                    ? say("dT/d{}' of the cyclic coordinate '{}'", q->name, q->name)
                                    : say("dT/d{}, constant in the moving axes", q->name);
    Value momentum = at_rest(momenta[i]);
    for (int j = 0; j < model.unknown_count(); ++j) {
      momentum += equations.mass()[i][static_cast<std::size_t>(j)] * model.v(j);
    }
    conserved.push_back({"momentum_" + q->name, meaning, written_unit(unit), momentum});
  }
  return conserved;
}

}  // namespace

PainleveReport painleve(const Equations& equations, const NaturalLanguage& say) {
  const Model& model = equations.model();
  Program& program = model.program();
  const Value t = kinetic_energy(model);
  std::vector<SymbolPointer> velocities;
  for (int i = 0; i < model.unknown_count(); ++i) {
    velocities.push_back(model.coordinates()[static_cast<std::size_t>(i)].v);
  }
  PainleveReport report;
  if (t.is_zero()) {
    report.failing_conditions.push_back(say("nothing has mass"));
    return report;
  }
  const KineticGradients of_t{gradient(t, velocities), gradient_along(t, velocities)};
  bool driven = false;
  for (const CoordinateContent& c : equations.scene().content().coordinates) driven = driven || c.law.has_value();
  const SymbolPointer& time = equations.scene().content().time;
  Derivation by_time = partial_derivation(program, time);
  report.explicit_rate = by_time(t);
  Substitution at_rest(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    if (symbol->kind != SymbolKind::velocity) return std::nullopt;
    return program.number(Number(), symbol->unit);
  });
  // A joint may follow a law of time without a driven coordinate; T0 shows it even where T does not depend on time.
  driven = driven || !report.explicit_rate.is_zero() || !identically_zero(at_rest(t));

  Value doubled;
  for (int i = 0; i < model.unknown_count(); ++i) doubled += of_t.momenta[static_cast<std::size_t>(i)] * model.v(i);
  report.t2_minus_t0 = driven ? doubled - t : t;

  Value u = gravity_force_function(model);
  u += equations.actions().spring_force_function;
  const auto [without, unstated] = working_actions(equations);
  if (!without.empty()) {
    report.failing_conditions.push_back(without.size() == 1 ? say("{} has no force function", joined(without))
                                                            : say("{} have no force function", joined(without)));
  }
  if (!unstated.empty()) {
    report.failing_conditions.push_back(unstated.size() == 1
                                            ? say("{} has a force function that is not stated", joined(unstated))
                                            : say("{} have force functions that are not stated", joined(unstated)));
  }
  if (!identically_zero(report.explicit_rate)) report.failing_conditions.push_back(say("T depends on time explicitly"));
  if (!u.is_zero() && !identically_zero(by_time(u))) {
    report.failing_conditions.push_back(say("the force function U depends on time explicitly"));
  }
  if (jumps(u)) {
    report.failing_conditions.push_back(say("the force function U jumps"));
  }
  for (const ConstraintRow& row : equations.constraints()) {
    if (identically_zero(at_rest(row.rate))) continue;
    report.failing_conditions.push_back(say("constraint '{}' imposes a velocity (b is not zero)", row.name));
  }
  if (report.failing_conditions.empty()) {
    Value integral = report.t2_minus_t0;
    integral -= u;
    report.first_integrals.push_back(driven ? FirstIntegral{"painleve", "T2 - T0 - U", "J", integral}
                                            : FirstIntegral{"energy", "T - U", "J", integral});
  }
  for (FirstIntegral& momentum : conserved_momenta(equations, of_t, at_rest, say))
    report.first_integrals.push_back(std::move(momentum));
  return report;
}

std::vector<MissingMomentum> missing_momenta(const Equations& equations, const PainleveReport& report,
                                             const NaturalLanguage& say) {
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  std::vector<SymbolPointer> velocities;
  for (std::size_t i = 0; i < n; ++i) velocities.push_back(model.coordinates()[i].v);
  const Value t = kinetic_energy(model);
  if (t.is_zero()) return {};
  const std::vector<Value> momenta = gradient(t, velocities);
  const std::vector<Value> along_q = gradient_along(t, velocities);
  const std::vector<Value> turning = turning_terms(model, momenta);
  Value u = gravity_force_function(model);
  u += equations.actions().spring_force_function;
  std::vector<std::pair<std::string, std::vector<Value>>> forces;  // of the actions that have no force function
  for (const ActionContent& action : model.scene().actions) {
    if (has_force_function(action) || std::holds_alternative<Motor>(action)) continue;
    const AppliedActions one = applied_actions(model, [&](const ActionContent& other) { return &other == &action; });
    forces.emplace_back(name_of(action), applied_forces(model, one));
  }
  const std::vector<SymbolPointer> inputs = model.inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) forces.emplace_back(inputs[k]->name, equations.actions().inputs[k]);
  // One state would miss a wall or a stop that acts elsewhere.
  const auto is_there = [](const Value& value) { return !identically_zero(value); };
  std::vector<MissingMomentum> missing;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string& name = model.coordinates()[i].q->name;
    const auto& found = report.first_integrals;
    if (std::any_of(found.begin(), found.end(), [&](const auto& each) { return each.name == "momentum_" + name; }))
      continue;
    MissingMomentum each{name, {}};
    if (momenta[i].is_zero()) each.reasons.push_back(say("T has no momentum along it"));
    if (is_there(along_q[i])) each.reasons.push_back(say("T depends on it"));
    if (is_there(turning[i])) each.reasons.push_back(say("its axes turn with the body"));
    if (!u.is_zero() && is_there(model.along(static_cast<int>(i))(u))) each.reasons.push_back(say("U depends on it"));
    std::vector<std::string> working;
    for (const auto& [action, force] : forces) {
      if (is_there(force[i])) working.push_back(action);
    }
    for (const ConstraintRow& row : equations.constraints()) {
      if (is_there(row.column[i])) working.push_back(row.name);
    }
    if (!working.empty()) {
      each.reasons.push_back(working.size() == 1 ? say("{} acts along it", joined(working)) : say("{} act along it", joined(working)));
    }
    missing.push_back(std::move(each));
  }
  return missing;
}

}  // namespace torsor
