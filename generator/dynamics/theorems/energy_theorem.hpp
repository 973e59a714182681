// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/theorems/newton_euler.hpp"

namespace torsor {

/// dT/dt = P_ext + P_int for a set of bodies, seen from any frame R (course, §6.3.3). Accelerations, multipliers and
/// inputs are symbols, the joints transmit what the motion requires: the theorem holds identically.
struct EnergyTheorem {
  Value kinetic_rate;    ///< dT/dt relative to R [W]
  Value external_power;  ///< weight, actions, joints and constraints across the boundary, inertia wrenches when R moves
  Value internal_power;  ///< of actions, joints (motors and springs on elongations with them) and constraints inside
};
EnergyTheorem energy_theorem(const Equations& equations, const BodyNames& bodies,
                             const FrameReference& observer = "ground");

/// The same with nothing of what the joints transmit: dT/dt, and the powers of weight, actions on bodies, inertia
/// wrenches and constraints that are no formulas.
EnergyTheorem energy_theorem_without_joints(const Equations& equations, const BodyNames& bodies,
                                            const FrameReference& observer = "ground");

/// Power of a named action relative to R [W]. The power of a mutual action (spring, damper, attraction, drag, action
/// between two bodies) counts both sides, the ground's too, and is the same in every frame. The power of a given
/// force, torque or wrench changes with the frame: by the reciprocal product with the twist of one frame relative to
/// the other, F · V(R2/R1) for a force where the frames do not turn. An action on a formula of coordinates acts
/// within the mechanism and has one power. Throws SceneError for a name that no action has.
Value action_power(const Equations& equations, const std::string& action, const FrameReference& observer = "ground");

/// Whether an action comes from outside the bodies of the scene: a given force, torque or wrench.
bool is_external(const ActionContent& action);

}  // namespace torsor
