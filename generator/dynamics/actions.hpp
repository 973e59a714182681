// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/dynamics/motion.hpp"

namespace torsor {

/// What the actions of a scene do, gravity apart (the recursions carry it).
struct AppliedActions {
  /// Generalised forces Q_i of springs and dampers, for every coordinate of the model (released ones last).
  std::vector<Value> passive;
  /// ∂(displacement of motor k)/∂q_i: Q_i = Σ_k inputs[k][i] u_k. One list per input.
  std::vector<std::vector<Value>> inputs;
  /// Given wrenches by link, in the link's axes at its origin.
  std::map<int, Wrench> given;
  /// Force function of the springs, U_s (potential energy −U_s).
  Value spring_force_function;
  /// Power of what has no force function: dampers, given forces and torques, motors.
  Value power;
  /// Names of the actions that have no force function, for reports.
  std::vector<std::string> without_force_function;
};

AppliedActions applied_actions(const Model& model);

/// |AB| with A and B points of the scene, and the vector AB in ground axes.
Vector separation(const Model& model, const PointReference& a, const PointReference& b, const std::string& user);

}  // namespace torsor
