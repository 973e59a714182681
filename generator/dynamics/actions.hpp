// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/dynamics/motion.hpp"

namespace torsor {

/// What the actions of a scene do, gravity apart (the recursions carry it).
struct AppliedActions {
  /// Generalised forces Q_i of springs and dampers that work on a formula (an elongation), for every coordinate of the
  /// model (released ones last). Springs and dampers between two points are in `wrenches`.
  std::vector<Value> passive;
  /// ∂(displacement of motor k)/∂q_i: Q_i = Σ_k inputs[k][i] u_k. One list per input.
  std::vector<std::vector<Value>> inputs;
  /// Wrenches on links, in the link's axes at its origin: point springs and dampers, given forces and torques.
  std::map<int, Wrench> wrenches;
  /// Force function of all springs, U_s (potential energy −U_s).
  Value spring_force_function;
  /// Power of what has no force function: dampers, given forces and torques, motors.
  Value power;
  /// Names of the actions that have no force function, for reports.
  std::vector<std::string> without_force_function;
};

/// Which actions are looked at.
enum class ActionKind { all, without_force_function };

AppliedActions applied_actions(const Model& model, ActionKind kind = ActionKind::all);

/// Q_i of everything but gravity, motors and multipliers: `passive` + Σ wrench · partial twist. For readers and checks;
/// the kernels' recursions take the wrenches directly.
std::vector<Value> applied_forces(const Model& model, const AppliedActions& actions);

}  // namespace torsor
