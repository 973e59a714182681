// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/dynamics/equations.hpp"

namespace torsor {

/// A quantity that every motion of the scene conserves.
struct FirstIntegral {
  std::string name;           ///< "energy", "painleve" or "momentum_<coordinate>"
  std::string documentation;  ///< what it is, with its unit
  Value value;
};

/// Painlevé's equation d(T2 − T0)/dt + ∂T/∂t = Σ Q_i q̇_i + Σ λ_j b_j and what follows from it (course, §6.4).
struct PainleveReport {
  Value t2_minus_t0;                            ///< Σ q̇_i ∂T/∂q̇_i − T
  Value explicit_rate;                          ///< ∂T/∂t
  std::vector<FirstIntegral> first_integrals;
  std::vector<std::string> failing_conditions;  ///< empty when T2 − T0 − U is conserved
};

/// T2 − T0 − U is conserved when every action has a force function, T and U do not depend on time explicitly and every
/// constraint is homogeneous in the velocities (b_j = 0). It is the energy T − U when nothing is driven. A coordinate
/// that appears neither in T nor in a constraint and has Q_i = 0 gives the momentum ∂T/∂q̇_i.
PainleveReport painleve(const Equations& equations);

}  // namespace torsor
