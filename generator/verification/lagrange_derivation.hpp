// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"

namespace torsor {

/// The equations of a scene by the derivation that kernels do not take: T from positions differentiated with respect to
/// time, Lagrange's operator by reverse and forward differentiation, gravity and springs from the gradient of the force
/// function. Shares with the kernels the scene, the constraints and the dampers only.
class LagrangeDerivation {
 public:
  /// Released coordinates are true coordinates here: their equations give the reactions.
  explicit LagrangeDerivation(const Scene& scene, ModelOptions options = {});

  const Equations& equations() const { return equations_; }
  const Value& kinetic_energy() const { return kinetic_energy_; }
  /// P_i, every coordinate (released ones last).
  const std::vector<Value>& operators() const { return operators_; }
  /// Q_i of gravity, springs, dampers and given wrenches.
  const std::vector<Value>& forces() const { return forces_; }
  /// ∂P_i/∂q̈_j of the unknowns.
  const ValueMatrix& mass() const { return mass_; }
  /// P_i at q̈ = 0, the unknowns.
  const std::vector<Value>& operators_at_rest() const { return operators_at_rest_; }

 private:
  static ModelOptions adapted(ModelOptions options);

  Equations equations_;
  Value kinetic_energy_;
  std::vector<Value> operators_, forces_, operators_at_rest_;
  ValueMatrix mass_;
};

}  // namespace torsor
