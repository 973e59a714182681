// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// M, C, K, F, E about the state, and the state matrices A, B where the coordinates are independent.
Kernel make_linearisation(const Equations& equations);
/// Why there is none; empty where there is one.
std::string no_linearisation(const Equations& equations);

}  // namespace torsor
