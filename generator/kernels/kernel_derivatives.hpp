// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// ∂f/∂q and ∂f/∂v of the inverse dynamics f(q, v, a, λ); ∂f/∂a is the mass matrix.
Kernel make_inverse_dynamics_derivatives(const Equations& equations);

/// ∂/∂q, ∂/∂v, ∂/∂(generalised force), ∂/∂u of the accelerations and multipliers of the motion.
Kernel make_forward_dynamics_derivatives(const Equations& equations);

}  // namespace torsor
