// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/geometry/rotation.hpp"

namespace torsor {

/// The rotation of a quaternion of decimals, exactly a rotation.
struct ExactRotation {
  Rotation rotation;
  /// What it was taken for where that is another one than the quaternion's: "Rz(pi/2) Rx(0.3...)"; empty otherwise.
  std::string taken_for;
};

/// The rotation of the quaternion (w, x, y, z), of any length but zero: v ↦ q v q*/|q|², whose entries are rational.
Rotation quaternion_rotation(const std::array<Number, 4>& quaternion);

/// The same unless it is a product of turns about axes, Rz Ry Rx or any other of the twelve sequences, in which angles
/// are within the tolerance [rad] of multiples of π/12. Those angles are then these multiples and the others as
/// exact_direction has them: the zeros of the matrix are zeros. The sequence with most such angles is taken, the first of them in the
/// order of URDF's rpy, then the rest.
ExactRotation exact_rotation(const std::array<Number, 4>& quaternion, const Number& tolerance);

}  // namespace torsor
