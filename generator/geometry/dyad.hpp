// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/geometry/vector.hpp"

namespace torsor {

/// The dyad a ⊗ b = a bᵀ: (a ⊗ b) v = (b·v) a. Components of both along the same axes.
Matrix dyad(const Vector& a, const Vector& b);

/// The operator a∧ with (a∧) v = a ∧ v; its square is a ⊗ a − a² 1.
Matrix cross_operator(const Vector& a);

/// The vector w of the antisymmetric part of an operator: ½ (m − mᵀ) v = w ∧ v.
Vector axial_vector(const Matrix& m);

/// The operator of a point of unit mass at `place` about the origin, place² 1 − place ⊗ place: sums of masses times it
/// are inertia operators. [m²] for a place in m.
Matrix unit_inertia(Program& program, const Vector& place);

}  // namespace torsor
