// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

// How a scene's author refers to what the scene holds, and places it.

struct FrameHandle { int index = 0; };
struct PointHandle { int index = 0; };
struct ConstraintHandle { int index = 0; };

/// A frame by handle or by name; names are looked up when the scene is validated. A text stands for a frame wherever
/// one is wanted.
struct FrameReference {
  FrameReference(FrameHandle handle) : target(handle.index) {}     // NOLINT(google-explicit-constructor)
  FrameReference(std::string name) : target(std::move(name)) {}    // NOLINT(google-explicit-constructor)
  FrameReference(const char* name) : target(std::string(name)) {}  // NOLINT(google-explicit-constructor)
  std::variant<int, std::string> target;
};
/// A point by handle or by name, which is said: `scene.point("tip")`. A text alone stands for a frame.
struct PointReference {
  PointReference(PointHandle handle) : target(handle.index) {}  // NOLINT(google-explicit-constructor)
  explicit PointReference(std::string name) : target(std::move(name)) {}
  std::variant<int, std::string> target;
};

/// Where a joint sits in its parent: origin, then a constant rotation.
struct Placement {
  Triple origin{Expression(0), Expression(0), Expression(0)};
  Rotation rotation{};
};

/// Axes (0, 1, 2 for x, y, z) of three plane rotations, each about an axis of the frame that the one before has turned.
struct AngleSequence {
  std::array<int, 3> axes;
  static const AngleSequence euler;   ///< ψ, θ, φ about z, x, z
  static const AngleSequence cardan;  ///< α, β, γ about x, y, z
};
inline constexpr AngleSequence AngleSequence::euler{{2, 0, 2}};
inline constexpr AngleSequence AngleSequence::cardan{{0, 1, 2}};

/// A unit quaternion as a scene's unknown: the orientation of a frame relative to its parent, by four coordinates e
/// whose rates come from the components ω of the relative angular velocity in the moving frame's axes
/// (quasi-velocities): ė_w = −½ (e_x ω_x + e_y ω_y + e_z ω_z), ė_x = ½ (e_w ω_x + e_y ω_z − e_z ω_y) and so on
/// cyclically.
struct AttitudeHandle { int index = 0; };

}  // namespace torsor
