// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// Constraints at pseudo-random states, by difference quotients in more than twice the digits, which know nothing of
/// how the generator differentiates, moves points or takes moments:
/// * f along the motion q + q̇ h + q̈ h²/2 (quaternions by ė, ë from ω, ω̇) and at the time t + h: its first derivative
///   is Σ a_i q̇_i − b, its second Σ a_i q̈_i + γ; of a non-holonomic condition the first one of its left-hand side;
/// * f of points, planes and joints that close loops, from the poses of the two bodies alone: moved one by one along
/// each
///   of six virtual displacements, it changes by the work of a unit multiplier's wrench (of non-holonomic ones, the
///   power of that wrench in the motion is the left-hand side).
/// Nothing for a scene without constraints.
std::vector<CheckResult> check_constraints(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
