// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/geometry/exact_turn.hpp"

namespace torsor {

/// Operations of a constant rotation times a vector.
int cost_of_turning(const Rotation& r);

/// Of an angle that is shifted: a rational constant is added; the addition theorem serves multiples of π/12.
int cost_of_shift(const ExactTurn& turn);

/// Another frame for a link.
struct OtherFrame {
  const Rotation& rotation;             ///< takes its axes to the link's own
  const std::array<Number, 3>& origin;  ///< in the link's own axes [m]
  int axis = 2;                         ///< of the joint: 0, 1, 2 for its x, y, z
};

/// How many first moments across the axis of its joint (each twice) and products of inertia a link has in another
/// frame; 0 where they depend on parameters without values.
int inertia_entries(const SceneContent& scene, const MassProperties& body, const OtherFrame& frame);

}  // namespace torsor
