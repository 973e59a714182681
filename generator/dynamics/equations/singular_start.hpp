// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// A sentence when the mass matrix M of a scene that stands (validate) is singular at its initial state: some rates move no
/// mass there, as those of Euler's angles ψ and φ at θ = 0, and M q̈ = … determines no accelerations. It names the
/// coordinates and the remedies. Empty otherwise, and where parameters have no value. M is evaluated at 50 digits; a pivot
/// below 10^-30 of its diagonal entry is none.
std::vector<std::string> singular_start(const Scene& scene);

}  // namespace torsor
