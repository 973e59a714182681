// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// ∂²f/∂q∂q, ∂²f/∂q∂v, ∂²f/∂v∂v and ∂²f/∂a∂q = ∂M/∂q of the inverse dynamics f(q, v, a, λ).
Kernel make_inverse_dynamics_second_derivatives(const Equations& equations);

/// The same of the accelerations and multipliers of the motion, by q, v and u.
Kernel make_forward_dynamics_second_derivatives(const Equations& equations);

}  // namespace torsor
