// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/dynamics/recursions/articulated_bodies.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

/// Whether each unknown is the displacement of exactly one joint and each joint has one unknown or none (driven): what
/// the recursion below needs.
bool has_simple_joints(const BodyTree& tree);

/// What the recursion finds, by link, in its axes.
struct ArticulatedMotion {
  ReferenceMotion reference;  ///< gravity included
  ArticulatedBodies bodies;
  std::vector<Wrench> bias_forces;         ///< pᴬ: what a link needs of its parent if that keeps to the reference
  std::vector<AccelerationIncrement> before;  ///< what the joints before add to the reference
  std::vector<AccelerationIncrement> added;   ///< the same with the link's own joint
  ForwardSolution solution;
};

/// Accelerations by the articulated-body recursion (Featherstone, Rigid Body Dynamics Algorithms, 2008, §7.3), linear
/// in the number of joints, written with the classical acceleration of each link's origin. A reference motion is taken
/// out first: each link by itself asks for its wrench there, which costs less than what its articulated body would.
/// `efforts`: for every unknown the generalised force of everything but inertia, gravity and the wrenches. No
/// constraints. `tree` is what asks: its links stand where those of the articulated bodies do, its inertia may be regrouped
/// otherwise.
ArticulatedMotion articulated_motion(const BodyTree& tree, const std::vector<Value>& efforts,
                                     const std::map<int, Wrench>& wrenches, ArticulatedBodies bodies);

/// The accelerations alone, with the inertias that cost least.
ForwardSolution articulated_forward(const Model& model, const std::vector<Value>& efforts,
                                    const std::map<int, Wrench>& wrenches);

/// Of a link before its own joint moves, when its parent's accelerations change.
AccelerationIncrement from_parent(const BodyTree& tree, const Link& link, const AccelerationIncrement& parent);

/// A joint with its effort.
struct JointThatMoves {
  const Link& link;
  const ArticulatedJoint& inertia;
  const Value& effort_by_pivot;  ///< u/d
};
struct JointResponse {
  Value acceleration;           ///< q̈
  AccelerationIncrement after;  ///< of its link
};
/// q̈ = u/d − g · A with A = `before`; the link then has A + q̈ s. An aligned component of the sum is what the link's
/// matter does, u/d − Σ of the others, and q̈ its difference from before: a product less.
JointResponse joint_response(const BodyTree& tree, const JointThatMoves& joint, const AccelerationIncrement& before);

}  // namespace torsor
