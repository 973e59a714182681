// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

#include "torsor/generator/geometry/vector.hpp"

namespace torsor {

/// What a screw stands for. Each kind is a type of its own: adding a twist to a wrench does not compile.
namespace screw_kind {
struct Twist {};
struct Wrench {};
struct Momentum {};
struct Dynamic {};
}  // namespace screw_kind

/// A screw: a resultant R and the field of moments M_B = M_A + R ∧ AB, reduced at one point A that its user states.
/// All its components are along the axes of one frame; only screws reduced at one point along the same axes are added.
template <class Kind>
struct Screw {
  Vector resultant;
  Vector moment;
};

/// Field of velocities of a body: its resultant is the angular velocity, its moment at A the velocity of the body's
/// point A. In the dynamics: of a link relative to the ground, at the link's origin, in the link's axes.
template <>
struct Screw<screw_kind::Twist> {
  Vector angular;  ///< Ω [rad/s]
  Vector linear;   ///< V(A) [m/s]
};

using Twist = Screw<screw_kind::Twist>;
/// Actions on a body: {R [N], M_A [N m]}. In the dynamics: on a link, at the link's origin, in the link's axes.
using Wrench = Screw<screw_kind::Wrench>;
/// {m V_G [kg m/s], σ_A [kg m²/s]} of what is attached to a link.
using MomentumScrew = Screw<screw_kind::Momentum>;
/// {m Γ_G [N], δ_A [N m]}, what Newton-Euler's theorems make equal to the wrench.
using DynamicScrew = Screw<screw_kind::Dynamic>;

template <class Kind>
const Vector& resultant_of(const Screw<Kind>& screw) {
  return screw.resultant;
}
template <class Kind>
const Vector& moment_of(const Screw<Kind>& screw) {
  return screw.moment;
}
inline const Vector& resultant_of(const Twist& twist) { return twist.angular; }
inline const Vector& moment_of(const Twist& twist) { return twist.linear; }

/// The same screw at B: {R, M_A + R ∧ AB}. `ab` in the screw's axes [m].
template <class Kind>
Screw<Kind> reduced_at(const Screw<Kind>& screw, const Vector& ab) {
  return {resultant_of(screw), moment_of(screw) + cross(resultant_of(screw), ab)};
}

/// The same screw along other axes, at the same point: the columns of `rotation` are the old axes seen in the new ones.
template <class Kind, class Turn>
requires std::same_as<Turn, Matrix> || std::same_as<Turn, Rotation> Screw<Kind> turned(const Turn& rotation,
                                                                                       const Screw<Kind>& screw) {
  const Vector resultant = rotation * resultant_of(screw);
  return {resultant, rotation * moment_of(screw)};
}

template <class Kind>
Screw<Kind> operator+(const Screw<Kind>& a, const Screw<Kind>& b) {
  return {resultant_of(a) + resultant_of(b), moment_of(a) + moment_of(b)};
}
template <class Kind>
Screw<Kind> operator-(const Screw<Kind>& a, const Screw<Kind>& b) {
  return {resultant_of(a) - resultant_of(b), moment_of(a) - moment_of(b)};
}
template <class Kind>
Screw<Kind> operator-(const Screw<Kind>& screw) {
  return {-resultant_of(screw), -moment_of(screw)};
}
template <class Kind>
Screw<Kind> operator*(const Value& k, const Screw<Kind>& screw) {
  const Vector resultant = k * resultant_of(screw);  // named: a product may create definitions
  return {resultant, k * moment_of(screw)};
}

/// Reciprocal product R·V(A) + M_A·Ω of two screws reduced at the same point: the power of a wrench, twice the kinetic
/// energy from the momentum screw. It does not depend on the point. Two screws of one nature have none here.
template <class Kind>
requires(!std::same_as<Kind, screw_kind::Twist>) Value
    reciprocal_product(const Screw<Kind>& screw, const Twist& twist) {
  const Value linear = dot(screw.resultant, twist.linear);
  const Value angular = dot(screw.moment, twist.angular);
  return linear + angular;
}

/// The invariant R·M_A, the same at every point (the other one is R itself). It vanishes where the screw is a sliding
/// vector or a couple.
template <class Kind>
Value scalar_invariant(const Screw<Kind>& screw) {
  return dot(resultant_of(screw), moment_of(screw));
}

}  // namespace torsor
