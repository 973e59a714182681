// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/geometry/vector.hpp"

namespace torsor {

// Every matrix here holds the axes of the turned base in its columns, as `Rotation` does: v_before = R v_turned.

/// One rotation about axis 0, 1 or 2 (x, y, z) of the base that the rotations before it have turned.
struct PlaneRotation {
  int axis = 2;
  Value angle;
};

/// c 1 + s n∧ with n that axis. Throws SceneError for an axis that does not exist.
Matrix rotation_matrix(Program& program, const PlaneRotation& turn);

/// Any sequence, first rotation first: R = R1 R2 … Rn.
Matrix rotation_matrix(Program& program, const std::vector<PlaneRotation>& sequence);

/// Angular velocity of the last base in the first, along the first base's axes: Σ α_k' n_k, each n_k turned by the
/// rotations before it.
Vector angular_velocity(Program& program, const std::vector<PlaneRotation>& sequence);

/// Euler's angles, precession ψ about z, nutation θ about x, own rotation φ about z.
std::vector<PlaneRotation> euler(const Value& psi, const Value& theta, const Value& phi);
/// Cardan's angles α, β, γ about x, y, z (roll, pitch, yaw).
std::vector<PlaneRotation> cardan(const Value& alpha, const Value& beta, const Value& gamma);

/// A rotation by an angle about a direction. The unit vector may move, but stays unit: its components are the same in
/// both bases.
struct AxisAngle {
  Vector axis;
  Value angle;
};

/// Throws SceneError unless e² = 1 identically.
void check_unit_axis(Program& program, const Vector& axis);

/// Rodrigues: R = cosα 1 + (1 − cosα) e ⊗ e + sinα e∧. Checks that e is a unit vector.
Matrix rotation_matrix(Program& program, const AxisAngle& turn);

/// Ω = α' e + sinα e' + (1 − cosα) e ∧ e', along the axes of the base that does not turn. Checks that e is a unit
/// vector.
Vector angular_velocity(Program& program, const AxisAngle& turn);

/// ½ Σ e_i ∧ e_i' with e_i the columns of R, along the axes of the base that does not turn: 2Ω = Σ e_i ∧ de_i/dt, from
/// any parametrisation.
Vector angular_velocity(const Matrix& rotation);

}  // namespace torsor
