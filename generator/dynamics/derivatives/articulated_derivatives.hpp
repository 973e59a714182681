// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"

namespace torsor {

/// Whether articulated_derivatives applies: no constraints, no wrenches given on bodies, and each unknown the
/// displacement of one joint.
bool fits_articulated_derivatives(const Equations& equations);

/// Derivatives of the accelerations of the motion by articulated bodies: of order n² where solving with the
/// factorisation of M is of order n³. Changes are pairs of accelerations and turning: {α, β}, w = δΩ, with
/// α = δΩ̇ − w ∧ Ω and β = δΓ(O) − 2 w ∧ V(O), so that a parent hands w on as it is, and α, β as accelerations.
///
/// A change of joint j (joint_changes.hpp) is one {α, β, w} that all links beyond it meet. Towards the ground:
///   I, g, d    articulated inertia, gain and pivot of each joint: q̈ = u/d − g · A;
///   B          what an articulated body asks for a turning: δ{N, F} = I {α, β} + B w. Of a rigid body
///              N = (tr(Q) 1 − Q) w with Q = 2 ∫ (V + u) rᵀ dm and F = w ∧ 2 (m V + Ω ∧ h); elimination of a joint
///              takes g (s · B) away, as g (s · I) from I.
/// Towards the tips:
///   C          inverse operational-space inertia: what a wrench on a link does to its accelerations, (1 − s gᵀ) C (1 − g sᵀ) + s sᵀ/d (the
///              operational-space inertia of Kreutz-Delgado, Jain & Rodriguez, Recursive formulation of operational
///              space control, 1992, inverted).
/// So joint j asks its parent for p = I {α, β} + B w, and for the turn of what it asked already; the parent gives way
/// by −C p, and {α, β} − C p, w is all that the links beyond see. Of each joint k then
///   rows       q̈_k as a function of {α, β, w} of each link that carries it, from itself to the ground;
///   columns    {α, β} of every link beyond it (or on other branches) for a unit force at k: they give M⁻¹, and, M⁻¹
///   being
///              symmetric, q̈_k for p at any of those links.
ForwardDerivatives articulated_derivatives(const Equations& equations);

}  // namespace torsor
