// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// The equations of motion as an implicit integrator asks for them, n + m rows r(q, v, a, λ, u, t) = 0:
///   M a + h − B λ − E u,   A a + γ,   with λ_j in the place of each constraint j that repeats others.
/// M is never solved with, and rows hold what their own bodies and joints have.
Kernel make_residual(const Equations& equations);

/// ∂r/∂(q, v, a, λ) without the entries that vanish identically, in compressed rows. Along an attitude q_j is a turn
/// about its moving axis j.
Kernel make_residual_jacobian(const Equations& equations);

}  // namespace torsor
