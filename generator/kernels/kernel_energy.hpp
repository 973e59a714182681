// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

struct Energies {
  Value kinetic, force_function;  ///< T, and U of weight, springs, attractions and given functions [J]
};

/// Where a light body may carry a heavy one, in forms that lose nothing of what is small beside it.
Energies energies_of(const Equations& equations);

/// T, U, and the power of what has no force function.
Kernel make_energy(const Equations& equations);

}  // namespace torsor
