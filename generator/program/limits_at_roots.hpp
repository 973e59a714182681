// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// The values with the limits that they have where a root V = √(Σ k_j u_j²), k_j > 0, in a denominator vanishes. A drag
/// −c V u has the slope −c (V + u²/V): at rest that is 0/0 as it stands, and tends to zero.
///
/// |u_j| ≤ V/√k_j. So each value is a sum of terms without V in a denominator and of some that are bounded by C V^o.
/// Where o > 0 in all values, 1/V is replaced by 1/(V > 0 ? V : 1), with which those terms are zero at V = 0. Elsewhere
/// nothing changes: the limit of a term of degree o = 0 would depend on the way, as that of u/V does. Of roots that have a u_j in
/// common one is looked at.
std::vector<Value> with_limits_at_roots(Program& program, const std::vector<Value>& values);

}  // namespace torsor
