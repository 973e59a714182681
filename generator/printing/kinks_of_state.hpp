// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"

namespace torsor::printing {

/// Where a state lies on a kink of the equations of motion: they have no linearisation about it.
struct Kinks {
  std::vector<Value> conditions;  ///< which vanish there, see forms_that_meet.hpp; in the program of the equations
  std::vector<std::string> laws;  ///< names of the actions whose own forces, or slopes of them, have two values
};

/// Of the forces and of the matrices M, C, K and E of the linearised equations. Parameters have the scene's values; coordinates,
/// velocities and inputs that the state does not give have numbers beside those of the scene's start.
Kinks kinks_of_state(const Equations& equations, const AtState::Named& state);

}  // namespace torsor::printing
