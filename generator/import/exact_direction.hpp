// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/geometry/rotation.hpp"

namespace torsor {

// Angles and directions of files are decimals; the exact ones nearby whose zeros are zeros.

/// Sine and cosine of an angle, exactly on the unit circle.
struct ExactAngle {
  Number sine, cosine;
  std::optional<Number> twelfths;  ///< the integer k when the angle was taken as k π/12
};

/// The integer k when |angle − k π/12| ≤ tolerance [rad], whole turns included. Angles up to 10³⁰.
std::optional<Number> twelfths_of_pi(const Number& angle, const Number& tolerance);

/// The exact multiple of π/12 when the angle [rad] is within the tolerance of one. Otherwise rational sine and cosine:
/// with the nearest quarter turn split off, r = angle − k π/2, they are those of 2 arctan t, t being the rational of
/// smallest denominator within 10⁻¹⁸ |r| of tan(r/2); so the angle is good to 2·10⁻¹⁸ of r.
ExactAngle exact_angle(const Number& angle, const Number& tolerance);

/// Rotation about axis 0, 1 or 2 (x, y, z).
Rotation rotation_about(int axis, const ExactAngle& angle);

/// A direction of unit length, exactly.
struct ExactDirection {
  std::array<Number, 3> components;
  bool changed = false;  ///< by more than normalising: components set to zero or angles taken as multiples of π/12
};

/// v/|v|. A component smaller than tolerance times the largest is zero; a direction in a coordinate plane within the
/// tolerance of a multiple of π/12 is that one; equal magnitudes within the tolerance are equal. What is then no
/// multiple of a direction with components in Q(√2, √3) becomes the rational point of the unit sphere that is nearby:
/// by stereographic projection, n = (2 a, 2 b, 1 − a² − b²)/(1 + a² + b²) with a, b good to 10⁻¹⁸ relative. `v` must
/// not be null.
ExactDirection exact_direction(const std::array<Number, 3>& v, const Number& tolerance);

/// A rotation whose third column is the direction: the permutation of axes that carries z there when it is x, y or z,
/// a half turn about the axis after it when it is −x, −y or −z besides, otherwise the smallest turn from z.
Rotation rotation_to(const std::array<Number, 3>& direction);

}  // namespace torsor
