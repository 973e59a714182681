// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/expression/symbol.hpp"

namespace torsor {

/// A unit as a person writes it: "N m" for kg m² s⁻², "rad/s" for s⁻¹, "kg/m^3" for kg m⁻³. `parse` reads it back. "1"
/// when dimensionless.
std::string written_unit(const Unit& unit);

/// That of a symbol: as its author wrote it, if somebody did ("N m/rad" has the dimension of "N m"). A coordinate without a
/// dimension is otherwise an angle in rad, unless it belongs to a quaternion.
std::string written_unit(const Symbol& symbol);

}  // namespace torsor
