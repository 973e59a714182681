// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations.hpp"

namespace torsor {

Equations::Equations(const Scene& scene, const ModelOptions& options)
    : scene_(scene),
      program_(std::make_unique<Program>(Model::resolver(scene_, options))),
      model_(scene_, *program_, options) {}

const AppliedActions& Equations::actions() const {
  if (!actions_) actions_ = applied_actions(model_);
  return *actions_;
}

const std::vector<ConstraintRow>& Equations::constraints() const {
  if (!constraints_) constraints_ = constraint_rows(model_);
  return *constraints_;
}

const ValueMatrix& Equations::mass() const {
  if (!mass_) mass_ = mass_matrix(model_);
  return *mass_;
}

std::vector<Value> Equations::inertia_and_passive(AccelerationInput input) const {
  std::vector<Value> forces = inertia_forces(model_, input, actions().wrenches);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] -= actions().passive[i];
    forces[i] = program_->bind(forces[i]);
  }
  return forces;
}

const std::vector<Value>& Equations::bias() const {
  if (!bias_) bias_ = inertia_and_passive(AccelerationInput::zero);
  return *bias_;
}

const std::vector<Value>& Equations::inverse_dynamics() const {
  if (!inverse_) {
    std::vector<Value> forces = inertia_and_passive(AccelerationInput::symbols);
    for (const ConstraintRow& row : constraints()) {
      const Value lambda = program_->symbol(row.multiplier);
      for (std::size_t i = 0; i < forces.size(); ++i) {
        if (!row.column[i].is_zero()) forces[i] -= row.column[i] * lambda;
      }
    }
    inverse_ = std::move(forces);
  }
  return *inverse_;
}

const ForwardSolution& Equations::forward() const {
  if (!forward_) {
    const auto n = static_cast<std::size_t>(model_.unknown_count());
    const auto unknowns = [n](const std::vector<Value>& all) {
      return std::vector<Value>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
    };
    std::vector<Value> force = unknowns(bias());
    const std::vector<SymbolPointer> inputs = model_.inputs();
    for (std::size_t i = 0; i < n; ++i) {
      force[i] = -force[i];
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        const Value& partial = actions().inputs[k][i];
        if (!partial.is_zero()) force[i] += partial * program_->symbol(inputs[k]);
      }
      force[i] = program_->bind(force[i]);
    }
    ValueMatrix jacobian, columns;
    std::vector<Value> gamma;
    for (const ConstraintRow& row : constraints()) {
      jacobian.push_back(unknowns(row.jacobian));
      columns.push_back(unknowns(row.column));
      gamma.push_back(row.gamma);
    }
    forward_ = solve_forward(*program_, mass(), force, jacobian, columns, gamma);
  }
  return *forward_;
}

}  // namespace torsor
