// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// The structures every header has, in its order: Parameters, Coordinates, Velocities, Accelerations,
/// GeneralizedForces, Inputs, Multipliers.
std::vector<Structure> common_structures(const Equations& equations, const std::vector<SymbolPointer>& parameters);

/// Throws SceneError for a member's name that cannot stand in a generated text or comes twice.
void check_names(const Structure& structure);

/// A structure in C++. When all members are scalars it has `size` and `operator[]`, through a constexpr table of member
/// pointers; without members both are there too.
std::string structure_text(const Structure& structure);

}  // namespace torsor
