// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/mechanics/central_axis.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// Velocity of one point, as known from outside.
struct PointVelocity {
  std::string name;
  Vector position;  ///< from any common origin [m]
  Vector velocity;  ///< [m/s]
};

/// Throws SceneError naming the first pair A, B for which AB·V_A = AB·V_B does not hold identically: such a field is
/// not that of a body.
void check_equiprojective(const std::vector<PointVelocity>& points);

/// The twist, at A, of the body whose points A, B, C have the given velocities: with β = V_B − V_A, γ = V_C − V_A,
/// b = AB, c = AC, n = b ∧ c, its angular velocity follows from Ω·n = β·c, Ω·b = (b² γ·n − b·c β·n)/n² and
/// Ω·c = (b·c γ·n − c² β·n)/n². Throws SceneError naming the points when they are aligned, or a pair as above.
Twist twist_of_velocities(const PointVelocity& a, const PointVelocity& b, const PointVelocity& c);

enum class MotionKind {
  rest,
  translation,  ///< Ω = 0
  rotation,     ///< Ω·V = 0: at every instant about an axis
  screw,        ///< turns about an axis and slides along it
};
std::string_view to_string(MotionKind kind);

/// What a twist says about the motion.
struct RigidMotion {
  MotionKind kind = MotionKind::rest;
  /// The instantaneous axis, where there is one; its pitch is the advance per radian.
  std::optional<CentralAxis> axis;
  /// Whether that axis stays where it is in the frame of reference.
  bool fixed_axis = false;
};

/// Recognises the motion of a body from its twist at a point that is fixed in the frame of reference, along that
/// frame's axes: identities in all symbols, not properties of one state. The axis is fixed when Ω' ∧ Ω = 0 and AH' ∧ Ω
/// = 0.
RigidMotion recognise(const Twist& twist);

}  // namespace torsor
