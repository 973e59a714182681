// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/point_motion.hpp"

namespace torsor {

/// One constraint Σ_i a_i q̇_i − b = 0.
struct ConstraintRow {
  std::string name;
  bool holonomic = false;
  Value value;                  ///< f(q, t) when holonomic, else zero
  Value rate;                   ///< Σ a_i q̇_i − b
  std::vector<Value> jacobian;  ///< a_i, for every coordinate of the model
  Value gamma;                  ///< d(rate)/dt at q̈ = 0: the acceleration equation is Σ a_i q̈_i + γ = 0
  std::vector<Value> ideal;     ///< generalised forces of a unit multiplier without friction: equal to a_i
  std::vector<Value> column;    ///< with friction, which works with the multiplier too; `ideal` without any
  bool friction = false;        ///< whether there is any
  Value friction_power;         ///< of the friction, for a unit multiplier
  SymbolPointer multiplier;
};

/// Rows for all constraints of the scene. With multipliers λ: P_i = Q_i + Σ_j λ_j column_j,i.
/// Throws SceneError when a constraint involves no coordinate or is not linear in the velocities.
std::vector<ConstraintRow> constraint_rows(const Model& model);

/// ∂V(P ∈ link)/∂q̇_i · direction for every coordinate, V relative to the ground; the direction in the axes in which P
/// is given. Each joint above the link contributes its own twist, reduced at P (partial twists; Kane's partial
/// velocities).
std::vector<Value> partial_velocities(const Model& model, int link, const SeenPoint& point,
                                      const Vector& direction);

/// ∂Ω(link)/∂q̇_i · moment for every coordinate, the same for turns: generalised forces of a unit couple.
std::vector<Value> partial_turns(const Model& model, int link, const Vector& moment, int axes);

}  // namespace torsor
