// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// Unknowns that can accelerate without moving any mass, in their order: those whose row of M vanishes identically, and
/// those whose pivot of the elimination of M is less than 10⁻⁵⁰ of its diagonal entry at each of a few generic states.
/// Without them M is regular.
std::vector<int> massless_coordinates(const Equations& equations);

/// Why kernels that solve with the mass matrix are absent: names the coordinates that move no mass, and the remedy.
/// Empty when there is none.
std::string lack_of_mass(const Equations& equations, const NaturalLanguage& say = {});

/// Throws SceneError with that reason when a coordinate moves no mass.
void require_mass(const Equations& equations);

}  // namespace torsor
