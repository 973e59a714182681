// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/mechanics/rigid_motion.hpp"

namespace torsor {

// Motion of any link relative to any other. Frames welded to a link move with it: `Model::place` tells a frame's link.
// Link 0 is the ground.

/// Twist of a link relative to another at the first one's origin, in the first one's axes: {Ω(link/reference),
/// V(O ∈ link/reference)}. Twists compose: twist(a/c) = twist(a/b) + twist(b/c) once at one point along the same axes,
/// and twist(b/a) = −twist(a/b).
Twist relative_twist(const Model& model, int link, int reference);

/// Ω(link/reference) in the axes of the link `axes` [rad/s].
Vector angular_velocity(const Model& model, int link, int reference, int axes);

/// The same from the turning axes alone, with no twist: ½ Σ e_i ∧ [de_i/dt]_reference.
Vector angular_velocity_from_axes(const Model& model, int link, int reference, int axes);

/// [dv/dt]_reference = [dv/dt]_link + Ω(link/reference) ∧ v of a vector given in a link's axes, in those axes (change
/// of frame of differentiation; Pommier, Dynamique des systèmes de solides, §2.3). The components may depend on time,
/// coordinates and velocities.
Vector derivative_in(const Model& model, const Vector& v, int link, int reference);

/// Velocities and accelerations of the points of a link relative to another link, in the first one's axes. The
/// accelerations of a body are no screw: Γ_B = Γ_A + Ω' ∧ AB + Ω ∧ (Ω ∧ AB).
struct BodyMotion {
  Twist twist;                  ///< at the link's origin O
  Vector angular_acceleration;  ///< Ω' [rad/s²], the same rate in both frames
  Vector origin_acceleration;   ///< Γ(O ∈ link/reference) [m/s²]

  /// V(P ∈ link/reference) of the link's material point at `place` = OP in its axes.
  Vector velocity_at(const Vector& place) const;
  /// Γ(P ∈ link/reference).
  Vector acceleration_at(const Vector& place) const;
};
BodyMotion body_motion(const Model& model, int link, int reference);

/// Rest, translation, rotation or screw motion of a link relative to another; the axis is given from the reference's
/// origin, along its axes.
RigidMotion recognise_motion(const Model& model, int link, int reference);

}  // namespace torsor
