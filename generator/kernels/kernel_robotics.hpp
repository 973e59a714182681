// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Gravity's part of the bias alone, of the configuration.
Kernel make_gravity(const Equations& equations);
std::string no_gravity(const Equations& equations);

/// Centre of mass, momentum about it and the centroidal momentum matrix.
Kernel make_centroidal_momentum(const Equations& equations);
std::string no_moving_mass(const Equations& equations);

}  // namespace torsor
