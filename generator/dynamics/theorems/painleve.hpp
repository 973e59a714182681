// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// A quantity that every motion of the scene conserves.
struct FirstIntegral {
  std::string name;     ///< "energy", "painleve" or "momentum_<coordinate>"
  std::string meaning;  ///< what it is
  std::string unit;     ///< as a person writes it
  Value value;
};

/// Painlevé's equation d(T2 − T0)/dt + ∂T/∂t = Σ Q_i q̇_i + Σ λ_j b_j and what follows from it (course, §6.4).
struct PainleveReport {
  Value t2_minus_t0;                            ///< Σ q̇_i ∂T/∂q̇_i − T
  Value explicit_rate;                          ///< ∂T/∂t
  std::vector<FirstIntegral> first_integrals;
  std::vector<std::string> failing_conditions;  ///< empty when T2 − T0 − U is conserved
};

/// T2 − T0 − U is conserved when the power Σ Q_i q̇_i of the actions without a force function vanishes identically, T and
/// U do not depend on time explicitly, U jumps nowhere (as with a stiffness by pieces) and every constraint is homogeneous
/// in the velocities (b_j = 0). It is the energy T − U when nothing is driven. A coordinate that appears neither in T nor in
/// a constraint and has Q_i = 0 gives the momentum ∂T/∂q̇_i.
PainleveReport painleve(const Equations& equations, const NaturalLanguage& say = {});

/// A coordinate without a momentum integral, and what stands against it.
struct MissingMomentum {
  std::string coordinate;
  std::vector<std::string> reasons;  ///< "T depends on it", "U depends on it", "'friction' works along it", ...
};

/// Every unknown coordinate whose ∂T/∂q̇_i is not among the first integrals, with all the terms of
/// d(∂T/∂q̇_i)/dt = ∂T/∂q_i + Q_i + Σ λ_j a_ji (less ω ∧ ∂T/∂ω of an attitude) that do not vanish. Apart from
/// `painleve`, which kernels are made with: it adds definitions to the program that only a reader wants.
std::vector<MissingMomentum> missing_momenta(const Equations& equations, const PainleveReport& report,
                                             const NaturalLanguage& say = {});

}  // namespace torsor
