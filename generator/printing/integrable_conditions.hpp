// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/printing/lagrange_equations.hpp"

namespace torsor::printing {

/// Non-holonomic constraints of which a combination says that a sum of coordinates is constant: two wheels of one axle,
/// whose rolling ties the angle of the vehicle to their difference.
struct IntegrableCondition {
  std::vector<std::string> constraints;  ///< those that are combined
  Sum constant;                          ///< Σ c_i q_i, c_i of parameters alone
};

/// Those that follow at sight: λ of parameters alone with Σ_k λ_k a_k = c of no configuration and no time, of one constraint
/// or of twelve at most together. Other integrable conditions are not looked for. (Neimark & Fufaev, Dynamics of
/// Nonholonomic Systems, on integrable combinations of equations of constraints.)
std::vector<IntegrableCondition> integrable_conditions(LagrangeEquations& equations);

}  // namespace torsor::printing
