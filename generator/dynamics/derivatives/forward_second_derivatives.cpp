// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/forward_second_derivatives.hpp"

#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/motion_changes.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

enum class Kind { position, velocity, input };

/// One variable x of the motion: how it changes the motion and what multiplies accelerations, multipliers and inputs.
struct Variable {
  Kind kind;
  std::size_t index;
  std::vector<Value> acceleration, multiplier;  ///< a_x, λ_x
  ValueMatrix mass, columns, jacobian, inputs;  ///< M_x, B_x, A_x, E_x; empty where they vanish
};

/// sum + matrix · x, where the matrix is not empty.
void add_product(std::vector<Value>& sum, const ValueMatrix& matrix, const std::vector<Value>& x) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t l = 0; l < x.size(); ++l) {
      if (!matrix[i][l].is_zero() && !x[l].is_zero()) sum[i] += matrix[i][l] * x[l];
    }
  }
}

void subtract_product(std::vector<Value>& sum, const ValueMatrix& matrix, const std::vector<Value>& x) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t l = 0; l < x.size(); ++l) {
      if (!matrix[i][l].is_zero() && !x[l].is_zero()) sum[i] -= matrix[i][l] * x[l];
    }
  }
}

class TwiceDifferentiatedMotion {
 public:
  explicit TwiceDifferentiatedMotion(const Equations& equations)
      : equations_(equations),
        program_(equations.program()),
        model_(equations.model()),
        n_(static_cast<std::size_t>(model_.unknown_count())),
        m_(equations.constraints().size()),
        motion_(at_motion(equations, equations.forward_by_factorisation())),
        first_(forward_derivatives_by_factorisation(equations)),
        residual_(second_residual_derivatives(equations, Inputs::act)) {
    for (std::size_t k = 0; k < n_; ++k) {
      by_position_.push_back(model_.along(static_cast<int>(k)));
      by_velocity_.push_back(partial_derivation(program_, model_.coordinates()[k].v));
    }
    for (std::size_t k = 0; k < n_; ++k) positions_.push_back(variable(Kind::position, k));
    for (std::size_t k = 0; k < n_; ++k) velocities_.push_back(variable(Kind::velocity, k));
    for (std::size_t k = 0; k < model_.inputs().size(); ++k) inputs_.push_back(variable(Kind::input, k));
    const std::vector<Value> rates = constraint_accelerations(equations_);
    for (std::size_t k = 0; k < n_; ++k) rates_by_position_.push_back(slopes(rates, by_position_[k]));
    for (std::size_t k = 0; k < n_; ++k) rates_by_velocity_.push_back(slopes(rates, by_velocity_[k]));
  }

  ForwardSecondDerivatives run() {
    using Of = ForwardSecondDerivatives::Of;
    pair_up(&Of::position_position, positions_, positions_);
    pair_up(&Of::position_velocity, positions_, velocities_);
    pair_up(&Of::velocity_velocity, velocities_, velocities_);
    pair_up(&Of::position_input, positions_, inputs_);
    pair_up(&Of::velocity_input, velocities_, inputs_);
    return std::move(result_);
  }

 private:
  std::vector<Value> slopes(const std::vector<Value>& values, Derivation& by) {
    std::vector<Value> all;
    for (const Value& value : values) {
      const Value slope = by(value);
      all.push_back(program_.bind(slope));
    }
    return all;
  }

  static std::vector<Value> column(const ValueMatrix& matrix, std::size_t k) {
    std::vector<Value> all;
    for (const auto& row : matrix) all.push_back(row[k]);
    return all;
  }

  Variable variable(Kind kind, std::size_t k) {
    using Of = ForwardDerivatives::Of;
    const auto matrix = kind == Kind::position   ? &Of::by_position
                        : kind == Kind::velocity ? &Of::by_velocity
                                                 : &Of::by_input;
    Variable x{kind, k, column(first_.accelerations.*matrix, k), column(first_.multipliers.*matrix, k), {}, {}, {}, {}};
    if (kind == Kind::input) return x;
    Derivation& by = kind == Kind::position ? by_position_[k] : by_velocity_[k];
    if (kind == Kind::position) x.mass = residual_.acceleration_position[k];
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<Value> column_entries, effects;
      for (const ConstraintRow& row : equations_.constraints()) column_entries.push_back(row.column[i]);
      for (const auto& input : equations_.actions().inputs) effects.push_back(input[i]);
      x.columns.push_back(slopes(column_entries, by));
      x.inputs.push_back(slopes(effects, by));
    }
    for (const ConstraintRow& row : equations_.constraints()) {
      const std::vector<Value> entries(row.jacobian.begin(), row.jacobian.begin() + model_.unknown_count());
      x.jacobian.push_back(slopes(entries, by));
    }
    return x;
  }

  /// r_xy at fixed accelerations and multipliers, as they stand in the motion.
  std::vector<Value> residual(const Variable& x, const Variable& y) {
    std::vector<Value> all;
    for (std::size_t i = 0; i < n_; ++i) {
      if (y.kind == Kind::input) {
        all.push_back(-x.inputs[i][y.index]);
        continue;
      }
      const ValuePages& pages = x.kind == Kind::velocity   ? residual_.velocity_velocity
                                : y.kind == Kind::velocity ? residual_.position_velocity
                                                           : residual_.position_position;
      const Value there = motion_(pages[y.index][i][x.index]);
      all.push_back(program_.bind(there));
    }
    return all;
  }

  /// g_xy likewise.
  std::vector<Value> constraint(const Variable& x, const Variable& y) {
    if (y.kind == Kind::input) return std::vector<Value>(m_);
    const std::vector<Value>& by_x = (x.kind == Kind::position ? rates_by_position_ : rates_by_velocity_)[x.index];
    return slopes_at_motion(by_x, (y.kind == Kind::position ? by_position_ : by_velocity_)[y.index], motion_);
  }

  ForwardSolution answer(const Variable& x, const Variable& y) {
    std::vector<Value> of_residual = residual(x, y);
    std::vector<Value> of_constraint = constraint(x, y);
    for (const auto& [from, to] : {std::pair{&x, &y}, std::pair{&y, &x}}) {
      add_product(of_residual, from->mass, to->acceleration);
      subtract_product(of_residual, from->columns, to->multiplier);
      add_product(of_constraint, from->jacobian, to->acceleration);
    }
    for (Value& change : of_constraint) change = program_.bind(change);
    return answer_of_motion(equations_, of_residual, of_constraint);
  }

  /// Whether ∂²/∂x∂y is found as ∂²/∂y∂x.
  bool repeats(const Variable& x, const Variable& y) const {
    if (x.kind != y.kind || x.index >= y.index) return false;
    const auto attitude = [this](const Variable& each) { return model_.coordinates()[each.index].attitude; };
    return x.kind != Kind::position || !attitude(x) || attitude(x) != attitude(y);
  }

  void pair_up(ValuePages ForwardSecondDerivatives::Of::*member, const std::vector<Variable>& xs,
               const std::vector<Variable>& ys) {
    ValuePages& accelerations = result_.accelerations.*member = zero_pages(ys.size(), n_, xs.size());
    ValuePages& multipliers = result_.multipliers.*member = zero_pages(ys.size(), m_, xs.size());
    for (std::size_t j = xs.size(); j-- > 0;) {
      for (std::size_t k = 0; k < ys.size(); ++k) {
        if (repeats(xs[j], ys[k])) {
          for (std::size_t i = 0; i < n_; ++i) accelerations[k][i][j] = accelerations[j][i][k];
          for (std::size_t i = 0; i < m_; ++i) multipliers[k][i][j] = multipliers[j][i][k];
          continue;
        }
        const ForwardSolution change = answer(xs[j], ys[k]);
        result_.pivots = change.pivots;
        for (std::size_t i = 0; i < n_; ++i) accelerations[k][i][j] = change.accelerations[i];
        for (std::size_t i = 0; i < m_; ++i) multipliers[k][i][j] = change.multipliers[i];
      }
    }
  }

  const Equations& equations_;
  Program& program_;
  const Model& model_;
  std::size_t n_, m_;
  Substitution motion_;
  ForwardDerivatives first_;
  SecondForceDerivatives residual_;
  std::vector<Derivation> by_position_, by_velocity_;
  std::vector<Variable> positions_, velocities_, inputs_;
  ValueMatrix rates_by_position_, rates_by_velocity_;  ///< [k]: of all constraints by variable k
  ForwardSecondDerivatives result_;
};

}  // namespace

ForwardSecondDerivatives forward_second_derivatives(const Equations& equations) {
  return TwiceDifferentiatedMotion(equations).run();
}

}  // namespace torsor
