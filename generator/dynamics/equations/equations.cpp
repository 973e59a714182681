// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/equations.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/forward_choice.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/dynamics/recursions/factored_bodies.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// Of longer chains the mass matrix alone costs more than a recursion (panda's, of seven, more than half of one), and
/// asking all of its entries whether they vanish takes longer than deriving them.
constexpr int most_for_parts = 12;

/// The recursion subtracts from the inertia of one articulated body after the other, L D Lᵀ from entries of M, which hold
/// the whole arm's: of Panda's accelerations the recursion keeps four bits more. On long chains that is worth some
/// operations. Of shorter ones L D Lᵀ is the quicker by far where both have as many: its pivots wait for each other, but
/// not for the motion.
constexpr double worth_accuracy = 1.05;
constexpr int long_chain = 8;

/// Unknowns up to which sums of squares are differentiated unasked: of 2, 3, 4 and 6 links in space that takes 2, 4, 8 and
/// 10 times the operations of solving with M.
constexpr int most_differentiated = 4;

}  // namespace

int cost_of(const Program& program, const ForwardSolution& solution) {
  std::vector<Value> values = solution.accelerations;
  for (const PivotTest& test : solution.pivots) {
    values.push_back(test.pivot);
    values.push_back(test.measure);
  }
  return count(program, values).total();
}

Equations::Equations(const Scene& scene, const ModelOptions& options)
    : scene_(scene),
      program_(std::make_unique<Program>(Model::resolver(scene_, options), options.passes)),
      model_(scene_, *program_, options),
      size_of_model_(program_->size()) {}

void Equations::start_over() const {
  derived_ = Derived();
  program_->truncate(size_of_model_);
}

const AppliedActions& Equations::actions() const {
  if (!derived_.actions) derived_.actions = applied_actions(model_);
  return *derived_.actions;
}

const std::vector<ConstraintRow>& Equations::constraints() const {
  if (!derived_.constraints) derived_.constraints = constraint_rows(model_);
  return *derived_.constraints;
}

const ConstraintRank& Equations::redundancy() const {
  if (!redundancy_) {
    const bool free = scene_.content().constraints.empty();
    redundancy_ = free ? ConstraintRank{} : constraint_rank(scene_, model_.options());
  }
  return *redundancy_;
}

const ValueMatrix& Equations::mass() const {
  if (!derived_.mass) {
    derived_.mass = mass_matrix(model_.regrouped());
    // Coordinates may uncouple (a centre of mass and what moves about it) where joint by joint nothing says so.
    if (few_unknowns()) clear_identically_zero(*derived_.mass);
  }
  return *derived_.mass;
}

const std::vector<int>& Equations::massless() const {
  if (!derived_.massless) derived_.massless = scene_.content().keeps_massless ? massless_coordinates(*this) : std::vector<int>();
  return *derived_.massless;
}

bool Equations::few_unknowns() const { return model_.unknown_count() <= most_for_parts; }

std::vector<Value> Equations::inertia_and_passive(AccelerationInput input) const {
  std::vector<Value> forces = inertia_forces(model_.without_lines(), input, actions().wrenches);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] -= actions().passive[i];
    forces[i] = program_->bind(forces[i]);
  }
  return forces;
}

const std::vector<Value>& Equations::bias() const {
  if (!derived_.bias) {
    derived_.bias = inertia_and_passive(AccelerationInput::zero);
    if (few_unknowns()) clear_identically_zero(*derived_.bias);
  }
  return *derived_.bias;
}

const std::vector<Value>& Equations::inverse_dynamics() const {
  if (!derived_.inverse) {
    std::vector<Value> forces = inertia_and_passive(AccelerationInput::symbols);
    const auto of_unknowns = [this](const std::vector<Value>& all) {
      return count(*program_, {all.begin(), all.begin() + model_.unknown_count()}).total();
    };
    if (few_unknowns()) {
      std::vector<Value> expanded = expanded_inverse_dynamics(forces);
      if (of_unknowns(expanded) < of_unknowns(forces)) forces = std::move(expanded);
    }
    for (const ConstraintRow& row : constraints()) {
      const Value lambda = program_->symbol(row.multiplier);
      for (std::size_t i = 0; i < forces.size(); ++i) {
        if (!row.column[i].is_zero()) forces[i] -= row.column[i] * lambda;
      }
    }
    derived_.inverse = std::move(forces);
  }
  return *derived_.inverse;
}

std::vector<Value> Equations::expanded_inverse_dynamics(const std::vector<Value>& recursive) const {
  std::vector<Value> forces = recursive;
  for (std::size_t i = 0; i < mass().size(); ++i) {
    forces[i] = bias()[i];
    for (std::size_t j = 0; j < mass().size(); ++j) {
      if (mass()[i][j].is_zero()) continue;
      const Value acceleration = program_->symbol(model_.coordinates()[j].a);
      forces[i] += mass()[i][j] * acceleration;
    }
    forces[i] = program_->bind(forces[i]);
  }
  return forces;
}

std::vector<Value> Equations::of_inputs() const {
  std::vector<Value> forces(static_cast<std::size_t>(model_.unknown_count()));
  const std::vector<SymbolPointer> inputs = model_.inputs();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const Value& partial = actions().inputs[k][i];
      if (!partial.is_zero()) forces[i] += partial * program_->symbol(inputs[k]);
    }
  }
  return forces;
}

std::vector<Value> Equations::efforts() const {
  std::vector<Value> all = of_inputs();
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = program_->bind(all[i] + actions().passive[i]);
  return all;
}

bool Equations::recursion_possible() const { return constraints().empty() && has_simple_joints(model_); }

ForwardSolution Equations::forward_by_recursion() const {
  return articulated_forward(model_, efforts(), actions().wrenches);
}

ForwardSolution Equations::cheapest_forward() const {
  if (!recursion_possible()) return forward_by_factorisation();
  ForwardSolution recursive = forward_by_recursion();
  const ForwardSolution& factored = forward_by_factorisation();
  const int cost = cost_of(*program_, recursive), other = cost_of(*program_, factored);
  const bool accurate = model_.unknown_count() >= long_chain && cost <= worth_accuracy * other;
  return cost < other || accurate ? recursive : factored;
}

const ForwardSolution& Equations::forward() const {
  if (derived_.forward) return *derived_.forward;
  require_mass(*this);
  ForwardMethod method = model_.options().forward;
  const auto joints = constraints().empty() ? joint_coordinates(model_) : std::nullopt;
  if (method == ForwardMethod::cheapest && joints && light_may_carry_heavy(model_)) {
    method = forward_method_that_keeps_digits(scene_, model_.options());
  }
  switch (method) {
    case ForwardMethod::cheapest: derived_.forward = cheapest_forward(); break;
    case ForwardMethod::factorisation: derived_.forward = forward_by_factorisation(); break;
    case ForwardMethod::articulated_body:
      if (!recursion_possible()) {
        throw UsageError(
            fmt::format("the articulated-body recursion does not fit the scene '{}': it needs a tree without "
                        "constraints in which each coordinate is the displacement of one joint",
                        scene_.name()));
      }
      derived_.forward = forward_by_recursion();
      break;
    case ForwardMethod::sums_of_squares:
      if (!joints) {
        throw UsageError(
            fmt::format("articulated bodies as sums of squares do not fit the scene '{}': they need a tree without "
                        "constraints, with as many joints as coordinates, their displacements linear in these",
                        scene_.name()));
      }
      derived_.forward = factored_forward(model_.with_bodies(), *joints, efforts(), actions().wrenches);
      break;
  }
  return *derived_.forward;
}

bool Equations::differentiates_squares() const {
  const bool asked = model_.options().forward == ForwardMethod::sums_of_squares;
  const bool may = model_.unknown_count() <= most_differentiated && light_may_carry_heavy(model_);
  return (asked || may) && forward().method == name_of_squares;
}

std::vector<Value> Equations::accelerations_by_squares(const std::vector<Value>& added) const {
  std::vector<Value> all = efforts();
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = program_->bind(all[i] + added[i]);
  return factored_forward(model_.with_bodies(), *joint_coordinates(model_), all, actions().wrenches).accelerations;
}

Value Equations::power() const {
  Value sum = actions().power;
  for (std::size_t j = 0; j < constraints().size(); ++j) {
    const ConstraintRow& row = constraints()[j];
    if (row.friction) sum += forward().multipliers[j] * row.friction_power;
  }
  return sum;
}

const MotionSolver& Equations::solver() const {
  if (!derived_.solver) {
    require_mass(*this);
    const auto unknowns = [this](const std::vector<Value>& all) {
      return std::vector<Value>(all.begin(), all.begin() + model_.unknown_count());
    };
    MotionSolver::Constraints kept;
    for (const std::size_t j : redundancy().kept) {
      const ConstraintRow& row = constraints()[j];
      kept.friction = kept.friction || row.friction;
      kept.jacobian.push_back(unknowns(row.jacobian));
      kept.columns.push_back(unknowns(row.column));
    }
    const ValueMatrix& matrix = mass();
    derived_.solver.emplace(*program_, matrix, std::move(kept));
  }
  return *derived_.solver;
}

ForwardSolution Equations::solve(const std::vector<Value>& force, const std::vector<Value>& gamma) const {
  const std::vector<std::size_t>& kept = redundancy().kept;
  std::vector<Value> kept_gamma;
  for (const std::size_t j : kept) kept_gamma.push_back(gamma[j]);
  ForwardSolution solution = solver().solve(force, kept_gamma);
  std::vector<Value> multipliers(constraints().size());
  for (std::size_t k = 0; k < kept.size(); ++k) multipliers[kept[k]] = solution.multipliers[k];
  solution.multipliers = std::move(multipliers);
  return solution;
}

const ForwardSolution& Equations::forward_by_factorisation() const {
  if (derived_.factored) return *derived_.factored;
  std::vector<Value> force = of_inputs();
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = program_->bind(force[i] - bias()[i]);
  std::vector<Value> gamma;
  for (const ConstraintRow& row : constraints()) gamma.push_back(row.gamma);
  derived_.factored = solve(force, gamma);
  if (constraints().empty() && has_simple_joints(model_)) {
    ForwardSolution other = forward_about_reference();
    if (cost_of(*program_, other) < cost_of(*program_, *derived_.factored)) derived_.factored = std::move(other);
  }
  return *derived_.factored;
}

ForwardSolution Equations::forward_about_reference() const {
  const ReferenceForces reference = reference_forces(model_.without_lines(), actions().wrenches);
  std::vector<Value> force = of_inputs();
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Value effort = program_->bind(force[i] + actions().passive[i]);
    force[i] = program_->bind(effort - reference.forces[i]);
  }
  ForwardSolution solution = solve(force, {});
  for (std::size_t i = 0; i < force.size(); ++i) {
    solution.accelerations[i] = program_->bind(solution.accelerations[i] + reference.accelerations[i]);
  }
  return solution;
}

}  // namespace torsor
