// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {

/// What run-time parameters make of a scene's sizes: for each bound the size, what it is compared with, and what is shown
/// beside them. Not among the kernels that have names: libraries and units look at it where parameters are set.
Kernel make_sizes(const Equations& equations, const std::vector<SizeBound>& bounds);

}  // namespace torsor
