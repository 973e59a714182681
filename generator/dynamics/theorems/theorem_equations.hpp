// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"

namespace torsor {

// The theorems as a person writes them for isolated bodies: what joints transmit stands there by name
// (joint_actions.hpp), so that they are equations for motion and reactions and not identities.

/// m Γ_G · u or δ_A · u on the left; weight, actions, inertia wrenches, multipliers and joints across the boundary on
/// the right.
struct TheoremEquation {
  Value left, right;
  std::vector<SymbolPointer> unknowns;     ///< components of joints that stand on the right
  std::vector<SymbolPointer> multipliers;  ///< of constraints, that stand there
  std::vector<std::string> remarks;        ///< on the joints concerned
};

/// Newton-Euler's theorem for bodies. Throws as `newton_euler_along`.
TheoremEquation theorem_equation(const Equations& equations, const BodyNames& bodies, const TheoremQuery& query,
                                 const NaturalLanguage& say = {});

/// dT/dt on the left, P_ext + P_int on the right.
struct EnergyEquation {
  Value kinetic_energy;
  TheoremEquation equation;
  Value external_power, internal_power;
};
EnergyEquation energy_equation(const Equations& equations, const BodyNames& bodies,
                               const FrameReference& observer = "ground", const NaturalLanguage& say = {});

}  // namespace torsor
