// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/motion/frame_motion.hpp"

namespace torsor {

/// A named point of the scene; `user` names who asks, for the message of an unknown point.
GeometricPoint geometric_point(const Model& model, const PointReference& point, const std::string& user);

/// V(P/reference) = [dO'P/dt]_reference, O' fixed in the reference, in the axes of the point's link [m/s].
Vector velocity(const Model& model, const GeometricPoint& point, int reference);

/// Γ(P/reference) = [dV(P/reference)/dt]_reference, in the axes of the point's link [m/s²].
Vector acceleration(const Model& model, const GeometricPoint& point, int reference);

/// The hodograph of a point's velocity: the path of the point M with AM = τ V(P/reference), A fixed in the reference and
/// τ = 1 s, so that it is drawn a metre for each metre per second. The acceleration is tangent to it:
/// V(M/reference) = τ Γ(P/reference) (Pommier, Dynamique des systèmes de solides, §3.1). `from` is OA from the
/// reference's origin, in its axes [m]; the result moves in the reference.
GeometricPoint hodograph(const Model& model, const GeometricPoint& point, int reference, const Vector& from = {});

/// Of a point of the scene, from the origin of the reference's link. Throws SceneError naming what does not exist.
GeometricPoint hodograph(const Model& model, const PointReference& point, const FrameReference& reference);

/// Motion of a point relative to a reference frame R, decomposed by a frame R1 that moves in R:
/// V_a = V_r + V_t, Γ_a = Γ_r + Γ_t + Γ_c (Pommier, Dynamique des systèmes de solides, §3.4). Each part comes from its
/// own definition, none is the difference of others.
struct PointMotion {
  Vector position;                ///< from R's origin [m]
  Vector absolute_velocity;       ///< V(P/R)
  Vector relative_velocity;       ///< V(P/R1)
  Vector transport_velocity;      ///< V(P ∈ R1/R): of R1's own point where P is
  Vector absolute_acceleration;   ///< Γ(P/R)
  Vector relative_acceleration;   ///< Γ(P/R1)
  Vector transport_acceleration;  ///< Γ(P ∈ R1/R)
  Vector coriolis_acceleration;   ///< 2 Ω(R1/R) ∧ V(P/R1)
};

/// The links of R1, of R, and of the axes in which all vectors are.
struct MotionLinks {
  int moving = 0, reference = 0, axes = 0;
};

PointMotion point_motion(const Model& model, const GeometricPoint& point, const MotionLinks& links);

/// For a point and frames of the scene, in the axes of the ground. Throws SceneError naming what does not exist.
PointMotion point_motion(const Model& model, const PointReference& point, const FrameReference& moving,
                         const FrameReference& reference);

}  // namespace torsor
