// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/body_screws.hpp"

namespace torsor {

// Inertia wrenches of bodies seen from a frame R that moves relative to the ground (course, §6.3.4). With them the
// theorems hold in R: {D(S/R)} = {actions on S} + {transport} + {Coriolis}. R is the query's observer.

/// −{m Γ(G ∈ R/ground); AG ∧ m Γ(G ∈ R/ground) + J_G Ω̇ + Ω ∧ J_G Ω}, Ω = Ω(R/ground): of matter that is carried along
/// by R. The course's version, −{m Γ(G/ground); AG ∧ m Γ(G/ground) + d(J_G Ω)/dt}, holds only for a body fixed in R.
Wrench transport_inertia_wrench(const Model& model, const BodyNames& bodies, const ScrewQuery& query);

/// −{2 m Ω ∧ V(G/R); ∫ AP ∧ (2 Ω ∧ V(P/R)) dm}; the integral over a rigid body with ω = Ω(S/R) is
/// AG ∧ 2 m Ω ∧ V(G/R) + 2 ω ∧ J_G Ω + tr(J_G) Ω ∧ ω.
Wrench coriolis_inertia_wrench(const Model& model, const BodyNames& bodies, const ScrewQuery& query);

/// Both together for what is attached to one link, at the link's origin in its axes; `observer` is R's link.
Wrench inertia_wrench_at_origin(const Model& model, const MassProperties& mass, int link, int observer);

}  // namespace torsor
