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

/// How many first moments across the axis of its joint (each twice) and products of inertia a link has about another
/// origin [m] in other axes, which this rotation takes to its own; 0 where they depend on parameters without values.
int inertia_entries(const SceneContent& scene, const MassProperties& body, const Rotation& rotation,
                    const std::array<Number, 3>& origin, int axis);

}  // namespace torsor
