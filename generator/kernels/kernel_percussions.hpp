// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Delassus' matrix W = J K Jᵀ of all contact rows and their accelerations without reactions of contacts. K is M⁻¹, with
/// loops M⁻¹ − M⁻¹ Aᵀ (A M⁻¹ Aᵀ)⁻¹ A M⁻¹.
Kernel make_delassus(const Equations& equations);
/// The jump equations of percussions: what unit impulses along the contact rows change of velocities, K Jᵀ, and the
/// impulses of constraints that go with them.
Kernel make_impact(const Equations& equations);

}  // namespace torsor
