// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/geometry/vector.hpp"

namespace torsor {

/// The dyad a ⊗ b = a bᵀ: (a ⊗ b) v = (b·v) a. Components of both along the same axes.
Matrix dyad(const Vector& a, const Vector& b);

/// The operator a∧ with (a∧) v = a ∧ v; its square is a ⊗ a − a² 1.
Matrix cross_operator(const Vector& a);

}  // namespace torsor
