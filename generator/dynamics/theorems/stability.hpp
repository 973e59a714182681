// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// Leading minors of a matrix, multiplied out: a symmetric one is positive definite exactly when all are positive
/// (Sylvester). Of the Hessian of −(U + T0) at a rest they are the conditions of Lejeune-Dirichlet as formulas.
std::vector<Value> sylvester_conditions(Program& program, const ValueMatrix& matrix);

/// What Lejeune-Dirichlet says about one rest.
struct LejeuneDirichlet {
  bool stable = false;  ///< if not, the criterion cannot conclude
  std::string reason;
  std::vector<Real> residual;  ///< what is left of the equations there: whether it is a rest is for the reader to see
  std::vector<Real> pivots;    ///< of L D Lᵀ of the Hessian of −(U + T0), until one is not positive
};

/// Stable where −(U + T0) has a strict minimum, also with dissipative and gyroscopic forces (Pommier, §7.4.2);
/// otherwise, and where T or U depends on time explicitly, nothing is concluded. Where M is singular the energy keeps
/// coordinates near the rest, but no rate along what M does not see: such a rest is not called stable. At the working
/// precision; `state` gives every symbol its value (coordinates, parameters that are symbols, time, inputs). A pivot
/// below n roundings of its diagonal entry counts as zero. Throws UsageError for a scene with constraints: reduce it to
/// independent coordinates, or use the runtime's search.
LejeuneDirichlet lejeune_dirichlet(const Equations& equations, const EquilibriumEquations& statics,
                                   const Evaluator<Real>::SymbolValue& state, const NaturalLanguage& say = {});

}  // namespace torsor
