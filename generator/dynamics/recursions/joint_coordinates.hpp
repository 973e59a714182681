// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"

namespace torsor {

/// Displacements of the joints in place of the unknowns: as many, and each depends on the unknowns by constants, as the
/// angle θ2 − θ1 of a joint does on absolute angles.
struct JointCoordinates {
  std::vector<std::size_t> joints;           ///< their links, ascending
  std::vector<std::vector<Number>> inverse;  ///< ∂q_i/∂s_k: [unknown][joint]
};

/// Nothing where the joints are others: driven by a formula, coupled, or more than unknowns.
std::optional<JointCoordinates> joint_coordinates(const BodyTree& tree);

}  // namespace torsor
