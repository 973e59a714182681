// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// One component, across the axis of a joint, of the force that the joint transmits to the link that it carries:
/// R = Σ B_i a_i + Σ C_k r_k + Σ D_j λ_j + R0, with the accelerations of the unknowns, the reactions of the rows of all
/// contacts and the multipliers.
struct BearingReaction {
  std::size_t across = 0;  ///< along which of the two directions across the axis
  std::vector<Value> by_accelerations, by_reactions, by_multipliers;
  Value rest;
  Value without_contacts;  ///< R at r = 0, accelerations and multipliers symbols: for who reads it
};

/// Of each contact that is friction in proportion to a joint's reaction, the components of that: two, or one where the other
/// vanishes identically, as in a plane mechanism. None of other contacts. What works on a formula (motors, stops, dry
/// friction) acts in the joints and is no force on the bodies. Throws SceneError where a joint transmits nothing, and where
/// a formula may load it (PlacelessLoads).
/// Source: Newton's theorem for all that the joint carries (Pommier, Dynamique des systèmes de solides, §6.3).
std::vector<std::vector<BearingReaction>> bearing_reactions(const Equations& equations);

}  // namespace torsor
