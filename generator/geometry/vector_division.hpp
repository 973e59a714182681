// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/geometry/vector.hpp"

namespace torsor {

/// All solutions X of A ∧ X = B: X = particular + α A, whatever α.
struct VectorQuotient {
  Vector particular;  ///< B ∧ A / A², the solution orthogonal to A
  Vector direction;   ///< A
  /// The solution of that α.
  Vector at(const Value& alpha) const { return particular + alpha * direction; }
};

/// Vector division of B by A (Pommier, Dynamique des systèmes de solides, §2.1.2). It exists only when A ≠ 0 and
/// A·B = 0. Throws SceneError, naming the condition that fails, when A vanishes identically or A·B does not.
VectorQuotient divide(const Vector& b, const Vector& a);

}  // namespace torsor
