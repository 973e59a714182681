// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Reads a formula in the symbols of a scene: decimals, parameters, coordinates and their velocities (theta'), t, pi,
/// + - * / ^ (whole exponents), parentheses, sin, cos, tan, sqrt, exp, log. A plain number fits any unit only where it
/// stands alone. Throws UsageError naming the text and where it stops being understood, UnitError for units.
Expression parse_formula(const std::string& text, const Scene& scene);

}  // namespace torsor
