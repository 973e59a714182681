// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/geometry/orientation.hpp"
#include "torsor/generator/geometry/vector.hpp"

namespace torsor {

/// A quaternion p0 + p, scalar part first. A unit one is a rotation: p0 = cos(α/2), p = sin(α/2) e; p and −p are the
/// same rotation. No attitude is singular.
struct Quaternion {
  Value scalar;
  Vector vector;
};

/// p0 q0 − p·q + (p0 q + q0 p + p ∧ q): the rotation p followed, in the turned base, by q.
Quaternion operator*(const Quaternion& p, const Quaternion& q);
Quaternion conjugate(const Quaternion& p);
/// p0² + p², 1 for a rotation.
Value squared_norm(const Quaternion& p);

/// Half-angle form of a rotation about a unit vector (which is checked), and of a sequence.
Quaternion quaternion(Program& program, const AxisAngle& turn);
Quaternion quaternion(Program& program, const std::vector<PlaneRotation>& sequence);

/// Columns are the turned axes: (p0² − p²) 1 + 2 p ⊗ p + 2 p0 p∧, a rotation where the norm is 1.
Matrix rotation_matrix(Program& program, const Quaternion& p);

/// Ω = 2 (p0 p' − p0' p + p ∧ p'), along the axes of the base that does not turn; the norm is taken to be 1.
Vector angular_velocity(const Quaternion& p);

/// p' = ½ Ω p for Ω along the axes of the base that does not turn: the rates that an angular velocity gives. They keep
/// the norm: p·p' = 0.
Quaternion rate_of_turn(const Quaternion& p, const Vector& omega);

}  // namespace torsor
