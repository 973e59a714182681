// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"

namespace torsor {

/// Wrenches on links, each in its link's axes at its origin, by link; 0 is the ground.
using WrenchOnLinks = std::map<int, Wrench>;

/// What the bodies feel for a unit multiplier of the scene's constraint number `index`: its force or couple on one link
/// with the opposite on the other (the ground included), and the friction of its contact. For any virtual motion their
/// power is Σ column_i q̇_i. Nothing for a constraint given as a formula without a named reaction: how its force acts on
/// the bodies is not said then, and it counts as acting in the joints whose displacements it ties. Points of closures
/// are taken to be fixed in their frames, or lowest points of contact.
std::optional<WrenchOnLinks> constraint_wrench(const Model& model, int index);
/// The same without friction: its power is Σ ideal_i q̇_i.
std::optional<WrenchOnLinks> ideal_wrench(const Model& model, int index);

/// A wrench and the place where it acts.
struct WrenchAtPoint {
  Wrench wrench;  ///< at the point, in the axes that the point is seen along
  SeenPoint point;
};
/// The link that a wrench acts on, and the one that its opposite acts on.
struct ActionPair {
  int on = 0, other = 0;
};
/// Adds a wrench to one link and its opposite to the other.
void add_pair(const Model& model, WrenchOnLinks& wrenches, const ActionPair& pair, const WrenchAtPoint& given);

}  // namespace torsor
