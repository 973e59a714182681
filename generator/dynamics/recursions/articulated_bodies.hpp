// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// Changes of the accelerations of a link: of the angular one and of that of its origin, in the link's axes.
struct AccelerationIncrement {
  Vector angular, linear;
};

/// {N, F} = [J H; Hᵀ M] {Ω̇, Γ(O)}: how a link and all that it carries answer when joints are free.
struct ArticulatedInertia {
  Matrix angular;   ///< J, symmetric
  Matrix coupling;  ///< H
  Matrix linear;    ///< M, symmetric

  Wrench operator*(const AccelerationIncrement& change) const;
};

/// What the elimination of a joint leaves: q̈ = u/d − g · A with A of the link before its joint moves, d = s · I s.
struct ArticulatedJoint {
  Wrench gain;    ///< g = I s/d; along an aligned axis the component that is exactly 1 is the number
  Value pivot;    ///< d
  Value inverse;  ///< 1/d
};

/// Articulated bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, §7.2), by link, in its axes about its
/// origin. Each unknown is the displacement of one joint (has_simple_joints).
struct ArticulatedBodies {
  std::vector<ArticulatedJoint> joints;  ///< of links whose joint has an unknown
  std::vector<ArticulatedInertia>
      seen_by_parent;  ///< I − I s sᵀ I/d, what the parent meets; of links that the ground carries: none
};

ArticulatedBodies articulated_bodies(const BodyTree& tree);

/// Whether the joint of a link has an unknown: it is driven or held otherwise.
inline bool is_free(const Link& link) { return !link.partials.empty(); }

/// Whether component i of moments (`turning`) or resultants is that along the aligned axis of a link's joint.
inline bool is_along_joint(const Link& link, int i, bool turning) {
  return i == link.aligned && turning == (link.joint == JointKind::revolute);
}

/// [v] of v ∧.
Matrix cross_matrix(const Vector& v);

}  // namespace torsor
