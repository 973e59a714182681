// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// The equations of statics of a scene (Pommier, §7.4): equations of motion at q̇ = q̈ = 0, in the equations' program.
struct EquilibriumEquations {
  /// h_i − Σ λ_j column_j − Σ E_ik u_k = 0 at rest, one for each unknown coordinate. Friction along a slip that
  /// vanishes there has no direction: its row is left without friction, with a remark.
  std::vector<Value> rows;
  std::vector<Value>
      conditions;  ///< f_j(q, t) = 0 of holonomic constraints that some place breaks, and −b_j where one imposes a rate
  std::vector<SymbolPointer> freedoms;  ///< the rate of each unknown coordinate
  bool driven = false;                  ///< T0 does not vanish: the roots are relative equilibria
  /// −(U + T0), and whether the rows (without multipliers and inputs) are its derivatives: then rests of a scene
  /// without constraints are its stationary points and Lejeune-Dirichlet applies. T0 is there only when driven.
  Value potential;
  bool from_potential = false;
  /// A row, a condition or T − T0 depends on time explicitly: a balance of one instant is none of the next, the energy is no
  /// integral, and roots of det(M s² + C s + K) say nothing (Mathieu's equation).
  bool depends_on_time = false;
  std::vector<std::string> remarks;  ///< why they are not, or what Lejeune-Dirichlet presupposes
  ValueMatrix hessian;               ///< ∂row_i/∂q_j at fixed multipliers and inputs
  ValueMatrix mass;                  ///< M, which Lejeune-Dirichlet supposes positive definite
};

/// Whether one of the values depends on time explicitly: it is t itself that stands in it, or a law of time.
bool depend_on_time(const Model& model, const std::vector<Value>& values);

/// Throws what the derivation of the equations throws.
EquilibriumEquations equilibrium_equations(const Equations& equations, const NaturalLanguage& say = {});

/// The equations as a person reads them, multiplied out, one "0 = ..." a line with the coordinate's name before it;
/// first −(U + T0) where it exists. Make the equations with ModelOptions::symbolic_parameters.
std::string print_equilibrium(const EquilibriumEquations& statics);

/// A copy of values at a state: symbols of coordinates, velocities, accelerations replaced by formulas of parameters.
/// Those that are not named stay, but for velocities and accelerations, which become zero.
class AtState {
 public:
  using Named = std::vector<std::pair<Expression, Expression>>;  ///< coordinate (or rate of one) and what it becomes
  /// Throws UsageError when something other than a symbol is to be replaced, UnitError for units.
  AtState(const Equations& equations, Named state);
  Value operator()(const Value& value) const;
  std::vector<Value> operator()(const std::vector<Value>& values) const;
  ValueMatrix operator()(const ValueMatrix& matrix) const;

 private:
  Program* program_;
  std::vector<std::pair<SymbolPointer, Value>> state_;
};

}  // namespace torsor
