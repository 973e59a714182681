// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// Value of a formula of parameters, each at its own value (run-time parameters at their default), at the working
/// precision. Throws SceneError naming a parameter without a value, unless one is to be invented (generic_value), or a
/// symbol that is no parameter.
Real parameter_value(const SceneContent& scene, const Expression& formula, bool invent = false);

/// The same, or nothing where the formula needs more than parameters that have values.
std::optional<Real> known_value(const SceneContent& scene, const Expression& formula);

/// Throws SceneError where the value of a parameter that is set at run time lies beyond double's range: there numbers of that
/// type take its place.
void require_double(const SceneContent& scene, const ParameterContent& parameter);

/// What `initial` says of a coordinate, a component of an attitude or a rate; nothing where it starts at zero.
std::optional<Expression> initial_formula(const SceneContent& scene, const SymbolPointer& symbol);

/// Value of a symbol at t = 0, without inputs: parameters at their values, coordinates and velocities as `initial` sets
/// them, everything else zero. `invent` is for a scene that leaves parameters open: those, and coordinates that are
/// given no initial value, get generic ones.
Real initial_value(const SceneContent& scene, const SymbolPointer& symbol, bool invent = false);

}  // namespace torsor
