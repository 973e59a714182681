// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// Conditions c of |c|, sign(c), selections and the cut of an angle that vanish at a state, where the values are not the same on
/// all sides of c = 0 and at the state. There −(U + T0) has no second derivatives, or the linearised equations are those of one side only. A spline at its
/// knot is the same on either side.
///
/// `at` puts the state into values, `numbers` gives what is left in them its value. Without numbers every condition counts
/// that vanishes whatever the parameters. At the working precision.
std::vector<Value> forms_that_meet(Program& program, const std::vector<Value>& values, const AtState& at,
                                   const std::optional<Evaluator<Real>::SymbolValue>& numbers);

}  // namespace torsor
