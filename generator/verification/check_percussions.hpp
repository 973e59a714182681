// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// The kernels `impact` and `delassus` of a scene with contacts, put back into equations of Lagrange's derivation at random
/// states: M Δv = Jᵀ P + Aᵀ L and A Δv = 0 for unit impulses, W = J Δv, and q = J a + drift of the forward dynamics.
/// Nothing for a scene without contacts.
std::vector<CheckResult> check_percussions(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
