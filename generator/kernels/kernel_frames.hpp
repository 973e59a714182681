// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// At each point of the scene, with the axes of its frame: pose, twist, Jacobian of six rows and drift J̇ v.
Kernel make_frames(const Equations& equations);

/// At each point of the scene J M⁻¹ Jᵀ, whose inverse is the operational-space inertia (Khatib 1987); with constraints what
/// they leave of it.
Kernel make_operational_inertia(const Equations& equations);

std::string no_points(const Equations& equations);
std::string no_operational_inertia(const Equations& equations);

}  // namespace torsor
