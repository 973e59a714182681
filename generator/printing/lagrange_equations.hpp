// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/stretches.hpp"

namespace torsor::printing {

/// A quantity written out, or, when that is too long to read, its value in the program of `definitions()`.
struct Quantity {
  std::optional<Sum> sum;
  Value value;
  double terms = 0;  ///< upper bound of the terms before anything cancels
};

/// The terms of P_i = d/dt ∂T/∂q̇_i − ∂T/∂q_i, each apart.
struct LagrangeSteps {
  std::optional<Sum> momentum, rate, along;  ///< ∂T/∂q̇_i, its time derivative, ∂T/∂q_i; none where it is too long
};

/// P_i = Q_i + Σ_k ∂e_k/∂q_i u_k + Σ_j λ_j column_j,i of one coordinate.
struct LagrangeEquation {
  CoordinateContent coordinate;
  SymbolPointer reaction;  ///< of a released coordinate: stands on the right with a factor 1
  Quantity inertia;        ///< P_i; when too long, P_i minus everything of the right but the inputs
  Quantity force;          ///< the right-hand side without the reaction; zero when P_i is too long
  LagrangeSteps steps{};   ///< only where they are asked for
  bool written_out() const { return inertia.sum.has_value() && force.sum.has_value(); }
};

struct ConstraintEquation {
  std::string name;
  bool holonomic = false;
  SymbolPointer multiplier;
  Quantity left;  ///< f(q, t), or Σ a_i q̇_i − b
};

/// Lagrange's equations of a scene by GiNaC: T is written out as one expression and differentiated by GiNaC's own
/// `diff`, P_i = d/dt ∂T/∂q̇_i − ∂T/∂q_i. Gravity and springs are Q_i = ∂U/∂q_i by the same `diff`. Released coordinates
/// are set to zero after the differentiation.
class LagrangeEquations {
 public:
  explicit LagrangeEquations(const Scene& scene, const InlineLimits& limits, bool with_steps = false);

  const Quantity& kinetic_energy() const { return kinetic_energy_; }
  const Quantity& force_function() const { return force_function_; }
  const std::vector<LagrangeEquation>& equations() const { return equations_; }
  const std::vector<ConstraintEquation>& constraints() const { return constraints_; }
  bool written_out() const;
  /// Springs whose elongation is written out.
  const std::vector<Stretch>& stretches() const { return stretches_; }

  /// Where the values of quantities that are too long live, parameters as symbols.
  const Equations& definitions() const { return definitions_; }
  InlineView& view() { return view_; }
  /// The products that are named in what is written out, with what they are.
  std::vector<std::pair<NamedProduct, Sum>> named_products();
  /// The program of the view, for formulas that are to be written out with it.
  Program& program() const { return open_.program(); }

  /// Derivative with respect to the configuration along a freedom.
  GiNaC::ex along(const GiNaC::ex& expression, const CoordinateContent& c);

 private:
  void derive();
  Quantity quantity(const Value& open, const Value& closed);
  GiNaC::ex at_rest(const GiNaC::ex& expression) const;
  GiNaC::ex time_derivative(const GiNaC::ex& expression);
  /// (ω ∧ ∂T/∂ω)_i of a quasi-velocity, zero of any other.
  GiNaC::ex turning_term(const GiNaC::ex& kinetic, const CoordinateContent& c);
  void derive_equation(std::size_t i, const std::optional<GiNaC::ex>& kinetic, const std::optional<GiNaC::ex>& work);
  Value other_forces(std::size_t i) const;
  void find_stretches();

  bool with_steps_;
  Equations open_;         ///< released coordinates are coordinates
  Equations definitions_;  ///< released coordinates are held at zero
  InlineView view_;
  GiNaC::exmap released_;                      ///< applied, never iterated
  std::vector<Value> without_force_function_;  ///< Q_i of dampers, given forces and torques
  Quantity kinetic_energy_, force_function_;
  std::vector<Stretch> stretches_;
  std::vector<LagrangeEquation> equations_;
  std::vector<ConstraintEquation> constraints_;
};

}  // namespace torsor::printing
