// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"

namespace torsor {

/// What the actions of a scene do, gravity apart (the recursions carry it).
struct AppliedActions {
  /// Generalised forces Q_i of what works on a formula (springs, dampers and efforts on an elongation, given force
  /// functions; with the motion of an end in its frame, and with a coefficient that depends on coordinates), for every
  /// coordinate of the model (released ones last). All else is in `wrenches`.
  std::vector<Value> passive;
  /// ∂(displacement of motor k)/∂q_i: Q_i = Σ_k inputs[k][i] u_k. One list per input.
  std::vector<std::vector<Value>> inputs;
  /// Wrenches on links, in the link's axes at its origin: springs, dampers and attractions between points, given forces,
  /// torques and wrenches, drag, mutual actions (one on each of the two links).
  std::map<int, Wrench> wrenches;
  /// Force function of springs, mutual gravitation and given force functions (potential energy −U).
  Value spring_force_function;
  /// Σ ∂U/∂c ∂c/∂t of the stiffnesses, natural lengths and strengths c that depend on time or on driven coordinates: the
  /// part of dU/dt that is no work of the actions.
  Value rate_without_work;
  /// Power of what has no force function, both sides of a mutual action: dampers, efforts, drag, given forces, torques
  /// and wrenches, motors. Friction of contacts works with a multiplier and is in Equations::power.
  Value power;
  /// Names of the actions that have no force function, friction of contacts included, for reports.
  std::vector<std::string> without_force_function;
};

/// Which actions are looked at.
enum class ActionKind { all, without_force_function };

/// Springs, mutual gravitation and given force functions.
bool has_force_function(const ActionContent& action);

/// Whether an action between points works on formulas too, which `passive` holds.
/// * An end moves in its frame: a massless slider, a point of contact. With F the force on the point, Q_i = F · ∂P/∂q_i:
///   that of F on the frame's body where the point is, which `wrenches` holds, and F · ∂p/∂q_i of its components p in the
///   frame.
/// * A stiffness k, a natural length or a strength depends on coordinates: Q_i = ∂U/∂k ∂k/∂q_i.
bool works_on_formula(const Model& model, const ActionContent& action);

/// Throws SceneError when an action cannot act: on the ground, within one rigid body, by a formula of accelerations.
AppliedActions applied_actions(const Model& model, ActionKind kind = ActionKind::all);
/// Those actions only for which `wanted` is true; friction is none of them.
AppliedActions applied_actions(const Model& model, const std::function<bool(const ActionContent&)>& wanted);

/// Q_i of everything but gravity, motors and multipliers: `passive` + Σ wrench · partial twist. For readers and checks;
/// the kernels' recursions take the wrenches directly.
std::vector<Value> applied_forces(const Model& model, const AppliedActions& actions);

}  // namespace torsor
