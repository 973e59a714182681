// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/motion/frame_motion.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// How a screw of bodies is asked for.
struct ScrewQuery {
  PointReference point;                ///< A, where it is reduced: a geometric point, it may move in its frame
  FrameReference axes = "ground";      ///< along whose axes its components are given
  FrameReference observer = "ground";  ///< R, relative to which motion is seen
};

/// Momentum screw of bodies relative to R, {m V_G, σ_A}: σ_A = ∫ AP ∧ V(P/R) dm, for one body
/// m AG ∧ V(A ∈ S/R) + J_A Ω(S/R) with the velocity of the body's own point at A (course, §4.3).
MomentumScrew momentum_screw(const Model& model, const BodyNames& bodies, const ScrewQuery& query);

/// Dynamic screw of bodies relative to R, {m Γ_G, δ_A}: δ_A = ∫ AP ∧ Γ(P/R) dm, which is
/// [dσ_A/dt]_R + m V(A/R) ∧ V_G with the velocity of the geometric point A (course, §4.4). Accelerations q̈ are symbols.
DynamicScrew dynamic_screw(const Model& model, const BodyNames& bodies, const ScrewQuery& query);

/// The same two from positions alone, with no twist: components in R's axes of the origins and axes of the links are
/// differentiated, and the dynamic moment is [dσ_A/dt]_R + m V(A/R) ∧ V_G.
MomentumScrew momentum_screw_from_positions(const Model& model, const BodyNames& bodies, const ScrewQuery& query);
DynamicScrew dynamic_screw_from_positions(const Model& model, const BodyNames& bodies, const ScrewQuery& query);

/// T = ½ Σ_S (momentum screw of S · twist of S) relative to R [J].
Value kinetic_energy(const Model& model, const BodyNames& bodies, const FrameReference& observer = "ground");

/// T of bodies that form one rigid body by 2T = m V_Q² + Ω·J_Q Ω + 2 m V_Q·(Ω ∧ QG), Q any point, V_Q the velocity
/// relative to R of the body's own point at Q and J_Q the operator there (the course's summary prints J_G). Throws
/// SceneError when the bodies move relative to one another.
Value kinetic_energy_at(const Model& model, const BodyNames& bodies, const PointReference& point,
                        const FrameReference& observer = "ground");

/// A screw reduced at the origin of a link, in its axes, reduced at the query's point along the query's axes.
template <class Kind>
Screw<Kind> as_asked(const Model& model, const Screw<Kind>& screw, int link, const ScrewQuery& query) {
  Program& program = model.program();
  const std::string user = "a screw query";
  const FramePlace& axes = model.place(query.axes, user);
  const Vector arm = bound(program, model.locate(query.point, link, user));
  const Vector given = bound(program, resultant_of(screw));
  const Vector moment = bound(program, moment_of(reduced_at(Screw<Kind>{given, moment_of(screw)}, arm)));
  const Rotation to_axes = axes.rotation.transpose();
  const Vector turned_resultant = to_axes * model.express(given, link, axes.link);
  const Vector turned_moment = to_axes * model.express(moment, link, axes.link);
  return {turned_resultant, turned_moment};
}

/// {∫ Γ dm, ∫ OP ∧ Γ dm} of matter that moves as a rigid body, O the origin of its motion: {m Γ_O + Ω̇ ∧ h +
/// Ω ∧ (Ω ∧ h), J_O Ω̇ + Ω ∧ J_O Ω + h ∧ Γ_O}, h = m OG.
DynamicScrew dynamic_screw_at_origin(Program& program, const MassProperties& body, const BodyMotion& motion);

}  // namespace torsor
