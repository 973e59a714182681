// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_contact_derivatives.hpp"

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

using Values = std::vector<Value>;

/// Columns by sweeps forwards: each remembers the definitions that it has met in the values before.
ValueMatrix columns(Program& program, const Values& values, std::vector<Derivation> derivations) {
  ValueMatrix rows(values.size());
  for (Derivation& derivation : derivations) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Value slope = derivation(values[i]);
      rows[i].push_back(program.bind(slope));
    }
  }
  return rows;
}

ValueMatrix by_position(const Equations& equations, const Values& values) {
  std::vector<Derivation> all;
  for (std::size_t j = 0; j < unknowns(equations); ++j) all.push_back(equations.model().along(static_cast<int>(j)));
  return columns(equations.program(), values, std::move(all));
}

ValueMatrix by_symbols(const Equations& equations, const Values& values, const std::vector<SymbolPointer>& symbols) {
  std::vector<Derivation> all;
  for (const SymbolPointer& symbol : symbols) all.push_back(partial_derivation(equations.program(), symbol));
  return columns(equations.program(), values, std::move(all));
}

std::vector<SymbolPointer> velocities(const Equations& equations) {
  std::vector<SymbolPointer> symbols;
  for (std::size_t i = 0; i < unknowns(equations); ++i) symbols.push_back(equations.model().coordinates()[i].v);
  return symbols;
}

/// Of all rows of contacts Σ J_i a_i, with the drift or without.
Values row_accelerations(const Equations& equations, const std::vector<ContactRows>& contacts, bool drifts) {
  const Model& model = equations.model();
  Values all;
  for (const ContactRows& contact : contacts) {
    for (const ContactRow& row : contact.rows) {
      Value sum = drifts ? row.drift : Value();
      for (int i = 0; i < model.unknown_count(); ++i) {
        const Value& entry = row.jacobian[static_cast<std::size_t>(i)];
        if (!entry.is_zero()) sum += entry * model.a(i);
      }
      all.push_back(equations.program().bind(sum));
    }
  }
  return all;
}

void add_residual(const Equations& equations, SlopesBuilder& slopes) {
  Program& program = equations.program();
  const ForceDerivatives of_motion = residual_derivatives(equations, Inputs::act);
  slopes.add("residual_by_position", of_motion.by_position, "d_i/dq_j of M a + h - A' lambda - E u");
  slopes.add("residual_by_velocity", of_motion.by_velocity, "d_i/dv_j");
  const Values of_motors = equations.of_inputs();
  Values residual(equations.inverse_dynamics().begin(),
                  equations.inverse_dynamics().begin() + equations.model().unknown_count());
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = program.bind(residual[i] - of_motors[i]);
  slopes.add("residual_by_input", by_symbols(equations, residual, equations.model().inputs()), "d_i/du_j");
  slopes.add("residual_by_parameter", derivatives_by_parameters(equations, residual, sensitivity_parameters(equations)),
             "d_i/dp_k");
}

}  // namespace

Kernel make_contact_motion_derivatives(const Equations& equations) {
  SlopesBuilder slopes("ContactMotionDerivatives",
                       "Partial derivatives while regimes of contacts last, stored column by column; accelerations, "
                       "multipliers,\nreactions and inputs count as independent.");
  const std::vector<SymbolPointer> v = velocities(equations), parameters = sensitivity_parameters(equations);
  add_residual(equations, slopes);
  const auto add_all = [&](const std::string& name, const Values& values, const std::string& text) {
    slopes.add(name + "_by_position", by_position(equations, values), "d_i/dq_j of " + text);
    slopes.add(name + "_by_velocity", by_symbols(equations, values, v), "d_i/dv_j");
    slopes.add(name + "_by_parameter", derivatives_by_parameters(equations, values, parameters), "d_i/dp_k");
  };
  add_all("constraint", constraint_accelerations(equations), "A a + gamma");
  const std::vector<ContactRows> contacts = contact_rows(equations.model());
  add_all("row", row_accelerations(equations, contacts, true), "J a + drift");
  Values rates, frictions, bounds;
  for (const ContactRows& contact : contacts) {
    for (const ContactRow& row : contact.rows) rates.push_back(row.rate);
  }
  add_all("rate", rates, "w");
  for (const ContactCoefficients& of : contact_coefficients(equations.model())) {
    frictions.push_back(of.friction);
    bounds.push_back(of.bound);
  }
  Values bearings, bearing_rows;
  for (const std::vector<BearingReaction>& components : bearing_reactions(equations)) {
    for (const BearingReaction& component : components) {
      bearings.push_back(component.without_contacts);
      bearing_rows.insert(bearing_rows.end(), component.by_reactions.begin(), component.by_reactions.end());
    }
  }
  add_all("bearing", bearings, "R = B a + D lambda + R0 of joints");
  slopes.add("bearing_rows_by_position", by_position(equations, bearing_rows), "d_i/dq_j of C, row by row");
  slopes.add("bearing_rows_by_parameter", derivatives_by_parameters(equations, bearing_rows, parameters), "d_i/dp_k");
  slopes.add("friction_by_parameter", derivatives_by_parameters(equations, frictions, parameters), "df_i/dp_k");
  slopes.add("bound_by_parameter", derivatives_by_parameters(equations, bounds, parameters), "db_i/dp_k");
  return slopes.take("Of what the motion fulfils while the regimes of its contacts last, but for J' r. Along an attitude q_j is\n"
                     "a turn about its moving axis j.",
                     {Argument::accelerations, Argument::multipliers, Argument::inputs});
}

Kernel make_contact_row_derivatives(const Equations& equations) {
  SlopesBuilder slopes("ContactRowDerivatives", "Partial derivatives of J a, stored column by column.");
  const Values rows = row_accelerations(equations, contact_rows(equations.model()), false);
  slopes.add("by_position", by_position(equations, rows), "d_i/dq_j");
  slopes.add("by_parameter", derivatives_by_parameters(equations, rows, sensitivity_parameters(equations)), "d_i/dp_k");
  return slopes.take("Of the rows of contacts at accelerations that count as independent. Along an attitude q_j is a turn about\n"
                     "its moving axis j.",
                     {Argument::accelerations});
}

}  // namespace torsor
