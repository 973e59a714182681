// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/dynamics/derivatives/articulated_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "torsor/generator/dynamics/recursions/articulated_bodies.hpp"
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor {
namespace {

class DifferentiatedMotion {
 public:
  explicit DifferentiatedMotion(const Equations& equations)
      : equations_(equations),
        program_(equations.program()),
        model_(equations.model()),
        n_(static_cast<std::size_t>(model_.unknown_count())),
        m_(equations.constraints().size()) {}

  /// With the bias and the derivatives of the residual as they are found for themselves.
  ForwardDerivatives run() {
    residual_ = residual_derivatives(equations_, Inputs::act);
    own_.resize(n_);
    solve_columns(equations_.forward_by_factorisation());
    return std::move(result_);
  }

  /// With the bias of ∂h/∂v, which has to be found anyway.
  ForwardDerivatives run_by_slopes() {
    InertiaSlopes slopes = inertia_slopes(model_.regrouped());
    residual_ = effort_derivatives(equations_, Inputs::act);
    own_ = slopes.own;
    std::vector<Value> force = equations_.of_inputs(), gamma;
    for (std::size_t i = 0; i < n_; ++i) {
      force[i] += equations_.actions().passive[i];
      force[i] = program_.bind(force[i] - slopes.bias[i]);
      for (std::size_t j = 0; j < n_; ++j) {
        residual_.by_position[i][j] = program_.bind(residual_.by_position[i][j] + slopes.forces.by_position[i][j]);
        residual_.by_velocity[i][j] = program_.bind(residual_.by_velocity[i][j] + slopes.forces.by_velocity[i][j]);
      }
    }
    solve_columns(equations_.solve(force, {}));
    return std::move(result_);
  }

 private:
  void solve_columns(const ForwardSolution& motion) {
    result_.method = "solving with the factorisation of the motion";
    Substitution there = at_motion(equations_, motion);
    const std::vector<Value> rates = constraint_accelerations(equations_);
    const std::size_t inputs = model_.inputs().size();
    for (ForwardDerivatives::Of* of : {&result_.accelerations, &result_.multipliers}) {
      const std::size_t rows = of == &result_.accelerations ? n_ : m_;
      of->by_position.assign(rows, std::vector<Value>(n_));
      of->by_velocity = of->by_force = of->by_position;
      of->by_input.assign(rows, std::vector<Value>(inputs));
    }
    for (std::size_t j = 0; j < n_; ++j) {
      Derivation by_velocity = partial_derivation(program_, model_.coordinates()[j].v);
      Derivation by_position = model_.along(static_cast<int>(j));
      const std::vector<Value> position_gamma = slopes_at_motion(rates, by_position, there);
      const std::vector<Value> position_force = opposite_column(residual_.by_position, j, there);
      solve(position_force, position_gamma, &ForwardDerivatives::Of::by_position, j);
      Value& own = result_.accelerations.by_position[j][j];
      const Value left_out = there(own_[j]);
      own = program_.bind(own - left_out);
      const std::vector<Value> velocity_gamma = slopes_at_motion(rates, by_velocity, there);
      const std::vector<Value> velocity_force = opposite_column(residual_.by_velocity, j, there);
      solve(velocity_force, velocity_gamma, &ForwardDerivatives::Of::by_velocity, j);
      std::vector<Value> unit(n_);
      unit[j] = program_.number(Number(1));
      solve(unit, std::vector<Value>(m_), &ForwardDerivatives::Of::by_force, j);
    }
    // Without friction M⁻¹ and its like with constraints are symmetric: one half is computed.
    const auto& rows = equations_.constraints();
    if (std::none_of(rows.begin(), rows.end(), [](const ConstraintRow& row) { return row.friction; })) {
      ValueMatrix& by_force = result_.accelerations.by_force;
      for (std::size_t i = 0; i < n_; ++i) {
        for (std::size_t j = 0; j < i; ++j) by_force[i][j] = by_force[j][i];
      }
    }
    for (ForwardDerivatives::Of* of : {&result_.accelerations, &result_.multipliers}) multiply_by_inputs(*of);
  }

  /// by_force · E: motors mostly act on one joint each.
  void multiply_by_inputs(ForwardDerivatives::Of& of) const {
    const auto& inputs = equations_.actions().inputs;
    for (std::size_t r = 0; r < of.by_input.size(); ++r) {
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        Value sum;
        for (std::size_t i = 0; i < n_; ++i) {
          if (!inputs[k][i].is_zero()) sum += of.by_force[r][i] * inputs[k][i];
        }
        of.by_input[r][k] = program_.bind(sum);
      }
    }
  }

  std::vector<Value> opposite_column(const ValueMatrix& matrix, std::size_t j, Substitution& there) const {
    std::vector<Value> column;
    for (const auto& row : matrix) column.push_back(program_.bind(-there(row[j])));
    return column;
  }

  void solve(const std::vector<Value>& force, const std::vector<Value>& gamma,
             ValueMatrix ForwardDerivatives::Of::*matrix, std::size_t column) {
    const ForwardSolution change = equations_.solve(force, gamma);
    result_.pivots = change.pivots;
    for (std::size_t i = 0; i < n_; ++i) (result_.accelerations.*matrix)[i][column] = change.accelerations[i];
    for (std::size_t j = 0; j < m_; ++j) (result_.multipliers.*matrix)[j][column] = change.multipliers[j];
  }

  const Equations& equations_;
  Program& program_;
  const Model& model_;
  std::size_t n_, m_;
  ForceDerivatives residual_;  ///< ∂(M a + h − B λ − E u)/∂x, by_position less own_[j] times column j of M
  std::vector<Value> own_;
  ForwardDerivatives result_;
};

/// Operations of all that is given, the motion's own among them.
int cost(const Equations& equations, const ForwardDerivatives& derivatives) {
  std::vector<Value> all;
  const ForwardDerivatives::Of& of = derivatives.accelerations;
  for (const ValueMatrix* matrix : {&of.by_position, &of.by_velocity, &of.by_force, &of.by_input}) {
    for (const auto& row : *matrix) all.insert(all.end(), row.begin(), row.end());
  }
  return count(equations.program(), all).total();
}

/// At least what solving 2 n columns takes: each joint meets every joint that carries it, twice.
int least_cost_of_solving(const Model& model) {
  int pairs = 0;
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    if (!is_free(model.links()[k])) continue;
    for (const int above : model.chain(model.links()[k].parent)) {
      if (is_free(model.links()[static_cast<std::size_t>(above)])) ++pairs;
    }
  }
  return 2 * model.unknown_count() * 4 * pairs;
}

ForwardDerivatives solved_derivatives(const Equations& equations) {
  const Model& model = equations.model();
  const bool slopes_fit = equations.constraints().empty() && equations.actions().wrenches.empty() &&
                          has_simple_joints(model) && all_joints_are_free(model);
  constexpr int few = 4;  // as few joints as residual_derivatives may take definition by definition
  std::optional<ForwardDerivatives> by_slopes;
  if (slopes_fit) by_slopes = DifferentiatedMotion(equations).run_by_slopes();
  if (by_slopes && model.unknown_count() > few) return *by_slopes;
  ForwardDerivatives by_residual = DifferentiatedMotion(equations).run();
  if (by_slopes && cost(equations, *by_slopes) < cost(equations, by_residual)) return *by_slopes;
  return by_residual;
}

/// Of the motion by sums of squares, definition by definition: nothing of it is a difference of large inertias, and so no
/// derivative of it divides by one. By an added force, the accelerations are linear in it.
ForwardDerivatives differentiated_squares(const Equations& equations) {
  Program& program = equations.program();
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const ForwardSolution motion = equations.forward();
  ForwardDerivatives result;
  result.method = "differentiating articulated bodies as sums of squares";
  result.pivots = motion.pivots;
  ForwardDerivatives::Of& of = result.accelerations;
  of.by_position.assign(n, std::vector<Value>(n));
  of.by_velocity = of.by_force = of.by_position;
  const std::vector<SymbolPointer> inputs = model.inputs();
  of.by_input.assign(n, std::vector<Value>(inputs.size()));
  const auto fill = [](ValueMatrix& matrix, std::size_t column, const std::vector<Value>& values, Derivation by) {
    for (std::size_t i = 0; i < values.size(); ++i) matrix[i][column] = by(values[i]);
  };
  std::vector<SymbolPointer> added;
  std::vector<Value> forces;
  for (std::size_t j = 0; j < n; ++j) {
    const CoordinateContent& coordinate = model.coordinates()[j];
    fill(of.by_position, j, motion.accelerations, model.along(static_cast<int>(j)));
    fill(of.by_velocity, j, motion.accelerations, partial_derivation(program, coordinate.v));
    Symbol force;
    force.name = fmt::format("force {}", j);
    force.unit = units::watt / coordinate.v->unit;
    force.index = model.scene().symbol_count + static_cast<int>(j);
    added.push_back(std::make_shared<const Symbol>(force));
    forces.push_back(program.symbol(added.back()));
  }
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    fill(of.by_input, k, motion.accelerations, partial_derivation(program, inputs[k]));
  }
  const std::vector<Value> pushed = equations.accelerations_by_squares(forces);
  for (std::size_t j = 0; j < n; ++j) fill(of.by_force, j, pushed, partial_derivation(program, added[j]));
  return result;
}

}  // namespace

ForwardDerivatives forward_derivatives_by_factorisation(const Equations& equations) {
  return DifferentiatedMotion(equations).run();
}

ForwardDerivatives forward_derivatives(const Equations& equations) {
  const ForwardMethod method = equations.model().options().forward;
  if (equations.differentiates_squares()) return differentiated_squares(equations);
  std::optional<ForwardDerivatives> articulated;
  if (method != ForwardMethod::factorisation && fits_articulated_derivatives(equations)) {
    articulated = articulated_derivatives(equations);
    if (method == ForwardMethod::articulated_body) return *articulated;
    if (cost(equations, *articulated) < least_cost_of_solving(equations.model())) return *articulated;
  }
  ForwardDerivatives solved = solved_derivatives(equations);
  if (articulated && cost(equations, *articulated) < cost(equations, solved)) return *articulated;
  return solved;
}

}  // namespace torsor
