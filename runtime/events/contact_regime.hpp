// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <limits>

namespace torsor::runtime {

// What Coulomb's laws (course, §6.2.3) allow of a contact whose forces a kernel has computed in an assumed regime:
// N = n · R(2 → 1) along the normal n from 2 to 1, T in the tangent plane, and the moments of resistance to rolling and
// spinning, whose coefficients h and k are lengths. A kernel watches no regime: these tell when one ends.

/// Length of a tangential force or moment by its components in the tangent plane.
template <class Scalar>
[[nodiscard]] Scalar tangential(const Scalar& along_x, const Scalar& along_y = Scalar(0)) noexcept {
  return std::hypot(along_x, along_y);
}

/// The contact presses: N >= 0. Below zero it opens, and its constraint is to be dropped. False for a NaN.
template <class Scalar>
[[nodiscard]] bool presses(const Scalar& normal) noexcept {
  return normal >= Scalar(0);
}

/// coefficient N − |T|: what is left before an adhering contact slips (coefficient f), rolls (h) or spins (k). Negative
/// when the adherence assumed is not possible.
template <class Scalar>
[[nodiscard]] Scalar adherence_margin(const Scalar& coefficient, const Scalar& normal, const Scalar& size) noexcept {
  return coefficient * normal - size;
}

/// Whether adherence is possible: the contact presses and |T| <= f N. False for a NaN.
template <class Scalar>
[[nodiscard]] bool adheres(const Scalar& coefficient, const Scalar& normal, const Scalar& size) noexcept {
  return presses(normal) && size <= coefficient * normal;
}

/// The least coefficient with which the contact adheres, |T|/N; infinite when it carries a tangential force without
/// pressing, zero when it carries nothing.
template <class Scalar>
[[nodiscard]] Scalar required_friction(const Scalar& normal, const Scalar& size) noexcept {
  if (normal > Scalar(0)) return size / normal;
  return size == Scalar(0) ? Scalar(0) : std::numeric_limits<Scalar>::infinity();
}

/// Whether a slip still goes the way its friction assumes: the component of the relative velocity along the direction
/// given to the scene is positive. Where it reaches zero the contact adheres or slips back.
template <class Scalar>
[[nodiscard]] bool keeps_sliding(const Scalar& velocity_along_direction) noexcept {
  return velocity_along_direction > Scalar(0);
}

}  // namespace torsor::runtime
