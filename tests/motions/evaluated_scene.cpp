// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/motions/evaluated_scene.hpp"

#include <cmath>
#include <stdexcept>

#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/kernels/kernel_jets.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/series_evaluation.hpp"

namespace torsor::testing_motions {

EvaluatedScene::EvaluatedScene(const Scene& scene) : equations_(scene), here_(equations_.program(), {}) {
  const Model& model = equations_.model();
  const SceneContent& content = equations_.scene().content();
  Program& program = equations_.program();
  std::vector<SymbolPointer> others;
  for (const SymbolPointer& position : model.positions()) {
    (position->attitude.expired() ? others : positions_).push_back(position);
  }
  sizes_.quaternions = static_cast<int>(positions_.size() / 4);
  sizes_.others = static_cast<int>(others.size());
  positions_.insert(positions_.end(), others.begin(), others.end());
  for (int i = 0; i < model.unknown_count(); ++i) velocities_.push_back(model.coordinates()[index(i)].v);
  sizes_.velocities = model.unknown_count();

  rows_ = equations_.constraints();
  sizes_.constraints = static_cast<int>(rows_.size());
  sizes_.independent_constraints = rows_.empty() ? 0 : static_cast<int>(equations_.redundancy().kept.size());
  friction_ = !content.frictions.empty();
  const ForwardSolution& forward = equations_.forward();
  accelerations_ = forward.accelerations;
  multipliers_ = forward.multipliers;
  pivots_ = forward.pivots;
  for (const SymbolPointer& position : positions_) rates_.push_back(rate_of(program, position));
  mass_ = equations_.mass();
  bias_ = equations_.bias();
  jets_ = make_jets(equations_);

  const PainleveReport report = painleve(equations_);
  force_function_ = gravity_force_function(model);
  force_function_ += equations_.actions().spring_force_function;
  force_function_ = program.bind(force_function_);
  energy_ = report.t2_minus_t0 - force_function_;
  explicit_rate_ = report.explicit_rate + partial_derivation(program, content.time)(force_function_);
  const AppliedActions working = applied_actions(model, ActionKind::without_force_function);
  const std::vector<Value> forces = applied_forces(model, working);
  for (int i = 0; i < model.unknown_count(); ++i) power_ += forces[index(i)] * model.v(i);
  for (const FirstIntegral& integral : report.first_integrals) integrals_.push_back(integral.value);

  // Values that hold at every state, then the start.
  for (const ParameterContent& parameter : content.parameters) {
    if (parameter.value) values_[parameter.symbol.get()] = here_(program.lower(*parameter.value));
  }
  for (const ActionContent& action : content.actions) {
    if (const auto* motor = std::get_if<torsor::Motor>(&action)) values_[motor->input.get()] = 0.0;
  }
  here_.move_to([this](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return 3.14159265358979323846;
    const auto place = values_.find(symbol.get());
    if (place == values_.end()) throw std::logic_error("no value of " + symbol->name);
    return place->second;
  });
  for (const SymbolPointer& position : positions_) {
    double value = 0.0;
    if (const auto component = content.quaternion_component(position)) {
      value = here_(program.lower(initial_component(content.attitudes[component->first], component->second)));
    }
    for (const CoordinateContent& c : model.coordinates()) {
      if (c.q == position && c.initial_value) value = here_(program.lower(*c.initial_value));
    }
    initial_.push_back(value);
  }
}

void EvaluatedScene::move_to(double time, std::span<const double> positions, std::span<const double> velocities) {
  values_[equations_.scene().content().time.get()] = time;
  for (std::size_t i = 0; i < positions_.size(); ++i) values_[positions_[i].get()] = positions[i];
  for (std::size_t i = 0; i < velocities_.size(); ++i) values_[velocities_[i].get()] = velocities[i];
  here_.move_to([this](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return 3.14159265358979323846;
    return values_.at(symbol.get());
  });
}

bool EvaluatedScene::forward_dynamics(std::span<double> accelerations, std::span<double> multipliers) {
  bool regular = true;
  for (const PivotTest& test : pivots_) {
    const double bound = test.of_several_rows ? 0x1p-40 : 0x1p-52;
    regular = regular && here_(test.pivot) > bound * std::abs(here_(test.measure));
  }
  for (std::size_t i = 0; i < accelerations_.size(); ++i) accelerations[i] = here_(accelerations_[i]);
  for (std::size_t i = 0; i < multipliers_.size(); ++i) multipliers[i] = here_(multipliers_[i]);
  return regular;
}

void EvaluatedScene::rates(std::span<double> positions) {
  for (std::size_t i = 0; i < rates_.size(); ++i) positions[i] = here_(rates_[i]);
}

std::vector<std::vector<double>> EvaluatedScene::jets(int order) {
  SeriesEvaluation<double> evaluation(jets_.series->program, jets_.series->state, here_);
  if (const auto& solve = jets_.series->solve) {
    evaluation.solve_for(solve->unknowns, solve->start, solve->lower, solve->inverse_pivots);
  }
  std::vector<std::vector<double>> coefficients = evaluation(order);
  // Quaternions first here, as declared there.
  std::vector<std::size_t> places;
  for (const SymbolPointer& position : positions_) {
    for (std::size_t k = 0; k < positions_.size(); ++k) {
      if (jets_.series->state[k] == position) places.push_back(k);
    }
  }
  for (std::vector<double>& of_order : coefficients) {
    std::vector<double> sorted;
    for (const std::size_t place : places) sorted.push_back(of_order[place]);
    sorted.insert(sorted.end(), of_order.begin() + static_cast<std::ptrdiff_t>(places.size()), of_order.end());
    of_order = std::move(sorted);
  }
  return coefficients;
}

double EvaluatedScene::energy_rate() {
  double rate = here_(power_) - here_(explicit_rate_);
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    double along = 0.0;
    for (std::size_t i = 0; i < velocities_.size(); ++i) along += here_(rows_[j].column[i]) * values_.at(velocities_[i].get());
    rate += here_(multipliers_[j]) * along;
  }
  return rate;
}

}  // namespace torsor::testing_motions
