// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/motion.hpp"

namespace torsor {

/// Change of a parent's motion: δΩ, δΩ̇ − δΩ ∧ Ω, δΓ(O).
struct MotionChange {
  Vector w, alpha, beta;
};

/// What a small change of one joint's displacement or rate is to the links beyond it: as if their common parent moved
/// otherwise (inertia_derivatives.hpp has the equations). `motion` are the accelerations of all links in their own
/// axes.
class JointChanges {
 public:
  JointChanges(const BodyTree& tree, std::vector<Acceleration>& motion)
      : tree_(tree), program_(tree.program()), motion_(motion) {}

  /// In the axes of link k, which all links of one quaternion share, at its origin.
  MotionChange by_position(std::size_t k) const;
  MotionChange by_velocity(std::size_t k) const;

  /// Of the links of a unit quaternion the first; any other link is its own.
  std::size_t first_of_group(std::size_t k) const { return k - static_cast<std::size_t>(tree_.links()[k].in_group); }
  /// Twice the velocity of a link's origin relative to its parent's, in the parent's axes.
  Vector doubled_velocity(const Link& link) const;
  /// 2 Ω of a link.
  Vector doubled_omega(std::size_t k) const { return doubled(motion_[k].omega()); }

 private:
  bool in_attitude(std::size_t k) const { return first_of_group(k) != tree_.turning_link(k); }
  Vector doubled(const Vector& v) const;
  /// Ω_p ∧ s of the parent, in the axes of link k.
  Vector parent_omega_cross_axis(std::size_t k) const;

  const BodyTree& tree_;
  Program& program_;
  std::vector<Acceleration>& motion_;
};

/// What the points of a body do relative to its origin: l = 2 ∫ u dm and Q = 2 ∫ u rᵀ dm.
struct PointFlow {
  Vector l;
  Matrix q;

  /// tr(Q) 1 − Q: the moment that a change of Ω asks for.
  Matrix answer(Program& program) const;
};

/// Of a rigid body whose points move by Ω ∧ r.
PointFlow rigid_flow(Program& program, const MassProperties& body, const Vector& doubled_omega);

}  // namespace torsor
