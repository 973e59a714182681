// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/base/unit.hpp"

namespace torsor {

/// What a symbol stands for. The kind fixes its time derivative and the earliest stage at which its value is known.
enum class SymbolKind {
  pi,            ///< the constant π, the only named number
  time,          ///< t
  parameter,     ///< constant in time; folded to its value unless it is a run-time parameter
  coordinate,    ///< q_i; its rate is a velocity
  velocity,      ///< dq_i/dt; its rate is an acceleration
  acceleration,  ///< d²q_i/dt²
  input,         ///< force or torque of a motor, set from outside at each call
  multiplier,    ///< λ_j of a constraint, or the intensity of the reaction that enforces it
};

struct AttitudeSymbols;
struct Measure;  ///< of a scene (generator/mechanics/measure.hpp)

/// A named quantity of a scene. Symbols are compared by identity: two scenes never share one.
struct Symbol {
  std::string name;                             ///< as the user wrote it, e.g. "theta_1"
  Unit unit;                                    ///< SI dimensions; radians are dimensionless
  SymbolKind kind = SymbolKind::parameter;      ///< decides derivative and stage
  int index = 0;                                ///< order of creation in its scene: the canonical order of everything
  std::shared_ptr<const Symbol> rate;           ///< dq/dt of a coordinate, d²q/dt² of a velocity, else null
  std::weak_ptr<const AttitudeSymbols> attitude{};  ///< of a component of a unit quaternion: where its rate comes from
  std::shared_ptr<const Measure> measure{};         ///< of what follows from the motion of frames: no variable, but
  std::vector<std::shared_ptr<const Symbol>> made_of{};  ///< a function of these
  std::string unit_text{};  ///< as its author wrote it ("N m/rad" has the dimension of "N m"); empty where nobody did
};

using SymbolPointer = std::shared_ptr<const Symbol>;

/// A unit quaternion e = (w, x, y, z) and the angular velocity ω in moving axes that turns it, kept by the scene:
/// ė_w = −½ (e_x ω_x + e_y ω_y + e_z ω_z), ė_x = ½ (e_w ω_x + e_y ω_z − e_z ω_y), and so on cyclically.
struct AttitudeSymbols {
  std::array<SymbolPointer, 4> e;
  std::array<SymbolPointer, 3> omega;
};

}  // namespace torsor
