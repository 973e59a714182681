// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"

namespace torsor {

/// {α, β} = [A D; Dᵀ L] {N, F}: what a wrench on a link, at its origin, in its axes, does to its accelerations when all
/// joints are free. Null for the ground.
struct InverseOperationalInertia {
  Matrix angular;  ///< A, symmetric
  Matrix mixed;    ///< D
  Matrix linear;   ///< L, symmetric

  AccelerationIncrement operator*(const Wrench& wrench) const;
};

/// Of matter of a parent, seen from the origin of a link that it carries, in that one's axes.
InverseOperationalInertia from_parent(const BodyTree& tree, const Link& link, const InverseOperationalInertia& parent);

/// A link's, from that `before` its joint moves: (1 − s gᵀ) C (1 − g sᵀ) + s sᵀ/d.
InverseOperationalInertia with_joint(Program& program, const Link& link, const ArticulatedJoint& joint,
                                     const InverseOperationalInertia& before);

/// The inverse inertia of a link before its joint moves, and after, as `with_joint` gives it.
struct InertiaAcrossJoint {
  const InverseOperationalInertia &before, &after;
};

/// What a unit force of the joint does to the link before its joint moves, by reaction on the parent: −C g.
AccelerationIncrement reaction(Program& program, const Link& link, const ArticulatedJoint& joint,
                               const InertiaAcrossJoint& inertia);

}  // namespace torsor
