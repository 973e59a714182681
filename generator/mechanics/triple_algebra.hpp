// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

/// A 3 x 3 array of formulas, rows first.
using Tableau = std::array<std::array<Expression, 3>, 3>;

// Vector algebra on formulas. A literal 0 or 1 is folded at once, so that what is simple stays simple to read.

Expression folded_product(const Expression& a, const Expression& b);
Expression dot(const Triple& a, const Triple& b);
Triple operator+(const Triple& a, const Triple& b);
Triple operator-(const Triple& a, const Triple& b);
Triple operator*(const Expression& k, const Triple& v);
Triple operator*(const Tableau& m, const Triple& v);

/// R J Rᵀ.
Tableau turned(const Tableau& rotation, const Tableau& j);

/// k (v² 1 − v vᵀ): the operator of a mass k [kg] at v [m] about the origin.
Tableau operator_of_point(const Expression& k, const Triple& v);

/// The vector of length 1 along an axis of any length, which is itself where that is plain to see. Throws SceneError with these
/// words when the axis is null.
Triple unit_vector(const Triple& axis, const std::string& where_null);

/// Rotation by an angle about an axis of any length (Rodrigues): c 1 + s [n] + (1 − c) n nᵀ. Throws SceneError when the
/// axis is null.
Tableau rotation_about(const Triple& axis, const Expression& angle);

/// a − b, a itself when b is the literal zero, whatever its unit.
Expression difference(const Expression& a, const Expression& b);

}  // namespace torsor
