// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/lagrange_equations.hpp"

#include <algorithm>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"

namespace torsor::printing {
namespace {

ModelOptions symbolic(bool hold_released) {
  ModelOptions options;
  options.symbolic_parameters = true;
  options.hold_released = hold_released;
  return as_given(std::move(options));
}

GiNaC::ex partial(const GiNaC::ex& expression, const GiNaC::ex& symbol) {
  return expression.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
}

}  // namespace

LagrangeEquations::LagrangeEquations(const Scene& scene, const InlineLimits& limits, bool with_steps)
    : with_steps_(with_steps),
      open_(scene, symbolic(false)),
      definitions_(scene, symbolic(true)),
      view_(open_.program(), limits, scene.content()) {
  view_.name_products(disc_products(open_.model()));
  derive();
}

bool LagrangeEquations::written_out() const {
  return std::all_of(equations_.begin(), equations_.end(), [](const auto& e) { return e.written_out(); });
}

GiNaC::ex LagrangeEquations::at_rest(const GiNaC::ex& expression) const {
  return released_.empty() ? expression : expression.subs(released_);
}

std::vector<std::pair<NamedProduct, Sum>> LagrangeEquations::named_products() {
  std::vector<std::pair<NamedProduct, Sum>> products;
  for (const NamedProduct& product : view_.products_in_use()) {
    if (const auto written = view_.expression(product.value)) {
      products.emplace_back(product, view_.sum(at_rest(*written)));
    }
  }
  return products;
}

Quantity LagrangeEquations::quantity(const Value& open, const Value& closed) {
  Quantity result;
  result.value = closed;
  result.terms = view_.term_bound(open);
  if (const auto written = view_.expression_to_read(open)) result.sum = view_.bounded_sum(at_rest(*written));
  return result;
}

GiNaC::ex LagrangeEquations::time_derivative(const GiNaC::ex& expression) {
  const Model& model = open_.model();
  GiNaC::ex result = partial(expression, view_.symbol(model.scene().time));
  for (const CoordinateContent& c : model.coordinates()) {
    if (!c.attitude) result += partial(expression, view_.symbol(c.q)) * view_.symbol(c.v);
    result += partial(expression, view_.symbol(c.v)) * view_.symbol(c.a);
  }
  for (const AttitudeContent& attitude : model.scene().attitudes) {
    for (const SymbolPointer& e : attitude.symbols->e) {
      result += partial(expression, view_.symbol(e)) * *view_.expression(rate_of(open_.program(), e));
    }
  }
  return result;
}

GiNaC::ex LagrangeEquations::along(const GiNaC::ex& expression, const CoordinateContent& c) {
  if (!c.attitude) return partial(expression, view_.symbol(c.q));
  GiNaC::ex result = 0;
  const auto& attitude = open_.scene().content().attitudes[as_index(*c.attitude)];
  for (const SymbolPointer& e : attitude.symbols->e) {
    const Value rate = rate_along(open_.program(), e, c.v);
    if (!rate.is_zero()) result += partial(expression, view_.symbol(e)) * *view_.expression(rate);
  }
  return result;
}

GiNaC::ex LagrangeEquations::turning_term(const GiNaC::ex& kinetic, const CoordinateContent& c) {
  if (!c.attitude) return 0;
  const auto& omega = open_.scene().content().attitudes[as_index(*c.attitude)].symbols->omega;
  for (std::size_t i = 0; i < 3; ++i) {
    if (omega[i] != c.v) continue;
    const GiNaC::ex second = view_.symbol(omega[(i + 1) % 3]);
    const GiNaC::ex third = view_.symbol(omega[(i + 2) % 3]);
    return second * partial(kinetic, third) - third * partial(kinetic, second);
  }
  return 0;
}

Value LagrangeEquations::other_forces(std::size_t i) const {
  Value sum = without_force_function_[i];
  const std::vector<SymbolPointer> inputs = open_.model().inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Value& arm = open_.actions().inputs[k][i];
    if (!arm.is_zero()) sum += arm * open_.program().symbol(inputs[k]);
  }
  for (const ConstraintRow& row : open_.constraints()) {
    if (!row.column[i].is_zero()) sum += row.column[i] * open_.program().symbol(row.multiplier);
  }
  return sum;
}

void LagrangeEquations::derive_equation(std::size_t i, const std::optional<GiNaC::ex>& kinetic,
                                        const std::optional<GiNaC::ex>& work) {
  const Model& model = open_.model();
  LagrangeEquation equation;
  equation.coordinate = model.coordinates()[i];
  const CoordinateContent& c = equation.coordinate;
  if (c.released) {
    const Unit unit = Unit::parse("J") / c.q->unit;
    const int index = model.scene().symbol_count + static_cast<int>(i);
    equation.reaction =
        std::make_shared<const Symbol>(Symbol{"reaction_" + c.q->name, unit, SymbolKind::multiplier, index, nullptr});
  }
  const Value rest = other_forces(i);
  equation.force.terms = view_.term_bound(rest);
  if (kinetic && work) {
    const GiNaC::ex momentum = partial(*kinetic, view_.symbol(c.v));
    const GiNaC::ex rate = time_derivative(momentum);
    const GiNaC::ex along_q = along(*kinetic, c);
    if (with_steps_) {
      equation.steps = {view_.bounded_sum(at_rest(momentum)), view_.bounded_sum(at_rest(rate)),
                        view_.bounded_sum(at_rest(along_q))};
    }
    equation.inertia.sum = view_.bounded_sum(at_rest(rate - along_q + turning_term(*kinetic, c)));
    if (const auto others = view_.expression_to_read(rest)) {
      equation.force.sum = view_.bounded_sum(at_rest(along(*work, c) + *others));
    }
  }
  if (!equation.written_out()) {
    equation.inertia.sum.reset();
    equation.inertia.value = definitions_.inverse_dynamics()[i];
    equation.inertia.terms = std::max({kinetic_energy_.terms, force_function_.terms, equation.force.terms});
  }
  equations_.push_back(std::move(equation));
}

void LagrangeEquations::find_stretches() {
  const Model& model = open_.model();
  for (const ActionContent& action : model.scene().actions) {
    const auto* spring = std::get_if<ElongationSpring>(&action);
    if (spring == nullptr) continue;
    const Value length = model.of_configuration(spring->elongation, "the elongation of spring '" + spring->name + "'") -
                         open_.program().lower(spring->rest);
    const auto stiffness = view_.expression(open_.program().lower(spring->stiffness)), written = view_.expression(length);
    const std::optional<Sum> sum = written ? view_.bounded_sum(at_rest(*written)) : std::nullopt;
    if (!stiffness || !sum) continue;
    Stretch stretch{view_.sum(*stiffness), *sum, {}};
    for (const CoordinateContent& c : model.coordinates()) stretch.along.push_back(view_.sum(at_rest(along(*written, c))));
    stretches_.push_back(std::move(stretch));
  }
}

void LagrangeEquations::derive() {
  const Model& model = open_.model();
  for (const CoordinateContent& c : model.coordinates()) {
    if (!c.released) continue;
    for (const SymbolPointer& symbol : {c.q, c.v, c.a}) released_[view_.symbol(symbol)] = 0;
  }
  const Value open_kinetic = torsor::kinetic_energy(model);
  Value open_work = gravity_force_function(model);
  open_work += open_.actions().spring_force_function;
  const Model& closed = definitions_.model();
  kinetic_energy_ = quantity(open_kinetic, torsor::kinetic_energy(closed));
  Value closed_work = gravity_force_function(closed);
  closed_work += definitions_.actions().spring_force_function;
  force_function_ = quantity(open_work, closed_work);

  // T is differentiated in its short form; released coordinates need the form in which they still move.
  std::optional<GiNaC::ex> kinetic, work;
  if (released_.empty()) {
    if (kinetic_energy_.sum) kinetic = view_.expression(*kinetic_energy_.sum);
  } else {
    if (const auto sum = view_.sum(open_kinetic)) kinetic = view_.expression(*sum);
  }
  work = view_.expression(open_work);
  if (work) find_stretches();
  without_force_function_ = applied_forces(model, applied_actions(model, ActionKind::without_force_function));
  for (std::size_t i = 0; i < model.coordinates().size(); ++i) derive_equation(i, kinetic, work);

  const std::vector<ConstraintRow>& rows = open_.constraints();
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const ConstraintRow& row = rows[j];
    const ConstraintRow& held = definitions_.constraints()[j];
    constraints_.push_back({row.name, row.holonomic, row.multiplier,
                            quantity(row.holonomic ? row.value : row.rate, held.holonomic ? held.value : held.rate)});
  }
}

}  // namespace torsor::printing
