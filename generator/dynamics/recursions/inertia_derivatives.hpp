// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

/// ∂P_i/∂q_j and ∂P_i/∂v_j of generalised forces P, unknowns only. Along an attitude q_j is a turn about its moving
/// axis j, and v_j its angular velocity.
struct ForceDerivatives {
  ValueMatrix by_position, by_velocity;
};

/// Derivatives of the generalised forces of inertia and gravity M q̈ + h at the accelerations as symbols, by one
/// recursion over pairs of joints, for mechanisms in which each unknown is the displacement of one joint
/// (has_simple_joints). A small turn of joint j about s changes what the links beyond it meet as if their common
/// parent moved otherwise: {w, α', β} = {Ω_p ∧ s, U_p s, Γ(O_j) ∧ s} with Ω_p, U_p = [Ω̇_p] + [Ω_p][Ω_p] of the parent
/// and Γ less gravity; a change of its rate gives {s, Ω_p ∧ s + Ω ∧ s, 0}; slides give {0, 0, U s} and {0, 0, 2 Ω ∧ s}.
/// Here w = δΩ, α' = δΩ̇ − w ∧ Ω, β = δΓ(O), and w and α' are the same for all links beyond j. A composite body of mass
/// m, first moment h, operator J, whose points have velocities u relative to its origin, answers with
///   δF = m β + α' ∧ h + w ∧ l,             l = 2 ∫ u dm,
///   δN = J α' + h ∧ β + (tr(Q) 1 − Q) w,   Q = 2 ∫ u rᵀ dm,
/// and moved to a parent that sees the origin at ρ with relative velocity V, β becomes β + α' ∧ ρ + 2 w ∧ V. Entries
/// with i beyond j are rows {A, p, c}, δP_i = A · w + p · α' + c · β, carried towards the ground; the others are the
/// changed wrenches, carried likewise. The classical accelerations make linear velocities drop out, which spatial
/// vectors (Singh, Russell & Wensing, Efficient analytical derivatives of rigid-body dynamics using spatial vector
/// algebra, IEEE RA-L 7, 2022, eqs. 19-26) need.
ForceDerivatives inertia_derivatives(const BodyTree& tree);

/// What accelerations of the motion are differentiated with: less to compute where M⁻¹ follows.
struct InertiaSlopes {
  /// by_position[i][j] is ∂P_i/∂q_j − κ_j M_ij: a change of the joint's own acceleration is a column of M, so that its
  /// part of α' (of β, where it slides) is left out.
  ForceDerivatives forces;
  std::vector<Value> own;  ///< κ
  /// h = ½ (∂h/∂v) v + G: forces that are quadratic in v (Euler), and those of rest. Where each joint is free.
  std::vector<Value> bias;
};
InertiaSlopes inertia_slopes(const BodyTree& tree);
/// Whether they have a bias.
bool all_joints_are_free(const BodyTree& tree);

}  // namespace torsor
