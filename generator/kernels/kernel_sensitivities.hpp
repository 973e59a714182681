// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Derivatives of the inverse dynamics f(q, v, a, λ) by every run-time parameter.
Kernel make_inverse_dynamics_sensitivities(const Equations& equations);

/// Derivatives of the accelerations and multipliers of the motion by every run-time parameter.
Kernel make_forward_dynamics_sensitivities(const Equations& equations);

}  // namespace torsor
