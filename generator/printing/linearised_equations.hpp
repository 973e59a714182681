// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/printing/lagrange_equations.hpp"
#include "torsor/generator/printing/state_values.hpp"

namespace torsor::printing {

using SumMatrix = std::vector<std::vector<Sum>>;
using About = std::vector<std::pair<std::string, std::string>>;  ///< see PrintOptions

/// M ε̈ + C ε̇ + K ε = F + E u about a state, ε the deviation of the unknowns from it: M = ∂R/∂q̈, C = ∂R/∂q̇,
/// K = ∂R/∂q, F = −R at the state and without input, E = ∂Q/∂u, with R = P − Q.
struct LinearisedEquations {
  SumMatrix M, C, K, E;
  std::vector<Sum> F;
};

/// By GiNaC's `diff` on equations that are written out. `about`: see PrintOptions. Throws UsageError naming a symbol or
/// formula of the state that it cannot read.
LinearisedEquations linearised(LagrangeEquations& equations, const Scene& scene, const About& about);

/// The symbols that a state names, with their values. Throws as `linearised`.
StateValues named_state(const Scene& scene, const About& about);

}  // namespace torsor::printing
