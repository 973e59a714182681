// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/unused_parameters.hpp"

#include <algorithm>
#include <set>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"

namespace torsor::printing {
namespace {

/// Symbols of what is written and of what is not; looked up only.
class Uses {
 public:
  explicit Uses(const Program& program) : program_(&program) {}

  bool of(const SymbolPointer& symbol) const { return symbols_.contains(symbol.get()); }

  void add(const Sum& sum) { add_symbols(sum, symbols_); }

  void add(const Value& value) {
    std::vector<ValueNumber> open;
    const auto take = [&](const Polynomial& polynomial) {
      for (const Term& term : polynomial.terms()) {
        for (const Factor& factor : term.monomial) open.push_back(factor.value_number);
      }
    };
    take(value.polynomial());
    while (!open.empty()) {
      const ValueNumber number = open.back();
      open.pop_back();
      if (!seen_.insert(number).second) continue;
      const Definition& definition = (*program_)[number];
      if (definition.symbol) symbols_.insert(definition.symbol.get());
      open.insert(open.end(), definition.arguments.begin(), definition.arguments.end());
      take(definition.polynomial);
    }
  }

  void add(const Quantity& quantity) {
    if (quantity.sum) add(*quantity.sum);
    else add(quantity.value);
  }

 private:
  const Program* program_;
  std::set<const Symbol*> symbols_;
  std::set<ValueNumber> seen_;
};

}  // namespace

std::vector<std::string> parameters_without_use(LagrangeEquations& equations) {
  const Equations& closed = equations.definitions();
  const SceneContent& scene = closed.scene().content();
  Uses uses(closed.program());
  for (const LagrangeEquation& equation : equations.equations()) {
    uses.add(equation.inertia);
    uses.add(equation.force);
  }
  for (const ConstraintEquation& constraint : equations.constraints()) uses.add(constraint.left);
  uses.add(equations.kinetic_energy());
  uses.add(equations.force_function());
  for (const CoordinateContent& c : scene.coordinates) {
    if (c.law) uses.add(closed.program().lower(*c.law));
  }
  for (const auto& [product, sum] : equations.named_products()) uses.add(sum);
  if (!scene.contacts.empty()) {
    const std::vector<ContactRows> contacts = contact_rows(closed.model());
    for (const ContactRows& contact : contacts) {
      if (contact.joint) return {};  // what the joint transmits has masses and lengths of its own
      uses.add(contact.gap);
      for (const ContactRow& row : contact.rows) uses.add(row.rate);
    }
    for (const ContactCoefficients& of : contact_coefficients(closed.model())) {
      for (const Value* each : {&of.friction, &of.static_friction, &of.restitution, &of.bound, &of.static_bound}) uses.add(*each);
    }
  }
  // What a parameter that is used is computed from.
  std::vector<bool> used;
  for (const ParameterContent& parameter : scene.parameters) used.push_back(uses.of(parameter.symbol));
  for (bool again = true; again;) {
    again = false;
    for (std::size_t user = 0; user < used.size(); ++user) {
      const ParameterContent& by = scene.parameters[user];
      if (!used[user] || !by.value) continue;
      for (std::size_t k = 0; k < used.size(); ++k) {
        if (used[k] || !by.value->depends_on(scene.parameters[k].symbol)) continue;
        used[k] = again = true;
      }
    }
  }
  std::vector<std::string> names;
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) names.push_back(scene.parameters[k].symbol->name);
  }
  return names;
}

}  // namespace torsor::printing
