// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {

/// What run-time parameters make of a scene's sizes: for each bound the size, then what it is compared with. Not among the
/// kernels that have names: libraries and units look at it where parameters are set.
Kernel make_sizes(const Equations& equations, const std::vector<SizeBound>& bounds);

/// The bounds as entries of a table of C, in that order: `{0, "body 'arm' has the mass m = \001 kg: ..."}`, the relation
/// and what is said where it is broken, with places for the two numbers.
std::string size_table(const std::vector<SizeBound>& bounds);

}  // namespace torsor
