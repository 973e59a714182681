// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::printing {

using Assignments = std::vector<std::pair<std::string, std::string>>;  ///< name and formula, as they were asked for

/// The scene with other values of some parameters, formulas of parameters; values of others that are formulas of these
/// follow. A plain number is in the parameter's unit. Throws UsageError where no parameter is named, and for a value that
/// depends on more than parameters or on itself.
Scene with_parameters(const Scene& scene, const Assignments& set);

/// A rest by name: unknown coordinates, components of attitudes, the time, inputs and multipliers; rates can only be zero.
/// An attitude whose four components are given is normalised, as the state at t = 0 is. Throws UsageError for what is no
/// part of a rest: a rate that is not zero, a coordinate that follows a law, a parameter; UnitError for units.
AtState::Named rest_state(const Scene& scene, const Assignments& about);

}  // namespace torsor::printing
