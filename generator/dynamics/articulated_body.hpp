// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "generator/dynamics/forward_dynamics.hpp"
#include "generator/dynamics/motion.hpp"

namespace torsor {

/// Whether each unknown is the displacement of exactly one joint and each joint has one unknown or none (driven): what
/// the recursion below needs.
bool has_simple_joints(const Model& model);

/// Accelerations by the articulated-body recursion (Featherstone, Rigid Body Dynamics Algorithms, 2008, §7.3), linear in
/// the number of joints, written with the classical acceleration of each link's origin. `efforts`: for every unknown the
/// generalised force of everything but inertia, gravity and the wrenches. No constraints.
ForwardSolution articulated_forward(const Model& model, const std::vector<Value>& efforts,
                                    const std::map<int, Wrench>& wrenches);

}  // namespace torsor
