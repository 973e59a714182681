// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// The reaction P_q - Q_q against a released coordinate, by its place among all coordinates: what the joint exerts along
/// the released direction, at accelerations, multipliers and inputs as symbols.
Value released_reaction(const Equations& equations, std::size_t coordinate);

/// Those of all released coordinates.
Kernel make_reactions(const Equations& equations);
std::string no_reactions(const Equations& equations);

}  // namespace torsor
