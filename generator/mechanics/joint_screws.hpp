// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/joint.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// One freedom of a joint between frames a and b with origins A and B: a turn about a line through B, a slide, or both
/// tied by the pitch. All that an ideal joint of the table leaves free is spanned by those of its type.
struct JointFreedom {
  enum class Kind { turn, slide, screw };
  Kind kind = Kind::turn;
  int axis = 0;       ///< 0, 1, 2 for x, y, z
  bool of_b = false;  ///< of the axes of b instead of those of a
};

/// One independent part of what an ideal joint transmits: a force through B, a couple, or both tied by the pitch so
/// that (M_B + p R)·x = 0.
struct JointTransmission {
  enum class Kind { force, couple, screw };
  Kind kind = Kind::force;
  int axis = 0;
  std::optional<int> with_axis_of_b = std::nullopt;  ///< the direction is then (axis of a) ∧ (this axis of b)
};

/// The freedoms of a type, freedom_count of them, and the 6 − f parts of its ideal wrench (Pommier, Dynamique des
/// systèmes de solides, §3.5.2 and §6.2.3; the sphere in a cylinder, which is not there: M_B = 0, R·x = 0).
const std::vector<JointFreedom>& freedoms(JointType type);
const std::vector<JointTransmission>& transmissions(JointType type);

/// "turn about x", "slide along y", "turn about y of b", "screw along x".
std::string describe(const JointFreedom& freedom);

/// Where a joint is: axes of both frames, the point B and the helical joint's pitch [m/rad], as symbols or as numbers.
template <class Vector, class Scalar>
struct PlacedJoint {
  std::array<Vector, 3> a, b;
  Vector point;  ///< from the point where twists and wrenches are reduced
  Scalar pitch;
};

/// {Ω, V} of a freedom at unit rate, reduced at the point from which `joint.point` is measured: V = OB ∧ Ω for a turn.
template <class Vector, class Scalar>
std::pair<Vector, Vector> twist_of(const JointFreedom& freedom, const PlacedJoint<Vector, Scalar>& joint) {
  const Vector& axis = (freedom.of_b ? joint.b : joint.a)[static_cast<std::size_t>(freedom.axis)];
  if (freedom.kind == JointFreedom::Kind::slide) return {Vector{}, axis};
  const Vector carried = cross(joint.point, axis);
  if (freedom.kind == JointFreedom::Kind::turn) return {axis, carried};
  return {axis, carried + joint.pitch * axis};
}

/// {R, M} of a part of the ideal wrench at unit intensity, reduced at the same point: M = OB ∧ R for a force.
template <class Vector, class Scalar>
std::pair<Vector, Vector> wrench_of(const JointTransmission& part, const PlacedJoint<Vector, Scalar>& joint) {
  Vector axis = joint.a[static_cast<std::size_t>(part.axis)];
  if (part.with_axis_of_b) axis = cross(axis, joint.b[static_cast<std::size_t>(*part.with_axis_of_b)]);
  if (part.kind == JointTransmission::Kind::couple) return {Vector{}, axis};
  const Vector moment = cross(joint.point, axis);
  if (part.kind == JointTransmission::Kind::force) return {axis, moment};
  return {axis, moment - joint.pitch * axis};
}

/// A joint between a and b, in the axes of a.
struct SymbolicJoint {
  JointType type = JointType::weld;
  Vector point{};  ///< OB [m], from where bases are reduced
  Value pitch{};   ///< of a helical joint [m/rad]
  Value angle{};   ///< [rad] on which the basis depends: of b about x in a universal joint, about z in a line contact
};

/// Symbolic bases in the axes of a, reduced at O: what the joint allows (b relative to a), and the ideal wrench of a on
/// b. Each twist is per unit rate of its freedom and each wrench per unit of its intensity.
std::vector<Twist> allowed_twists(Program& program, const SymbolicJoint& joint);
std::vector<Wrench> ideal_wrenches(Program& program, const SymbolicJoint& joint);

}  // namespace torsor
