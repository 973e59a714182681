// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {

/// Accelerations and multipliers as symbols become those of the motion.
Substitution at_motion(const Equations& equations, const ForwardSolution& motion);

/// A a + γ of every constraint, at accelerations as symbols.
std::vector<Value> constraint_accelerations(const Equations& equations);

/// Derivatives of values by one derivation, then at the motion.
std::vector<Value> slopes_at_motion(const std::vector<Value>& values, Derivation& by, Substitution& motion);

/// The motion's answer to a change of its data: M δa − B δλ = −δ(M a + h − B λ − E u), A δa = −δ(A a + γ), the changes
/// on the right at fixed accelerations and multipliers.
ForwardSolution answer_of_motion(const Equations& equations, const std::vector<Value>& residual_change,
                                 const std::vector<Value>& constraint_change);

}  // namespace torsor
