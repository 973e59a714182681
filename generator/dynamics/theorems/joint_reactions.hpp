// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// One unknown component of what a joint transmits: a wrench (X, Y, Z; L, M, N), mostly with a single entry 1.
struct ReactionComponent {
  std::string name;               ///< "X", or for a helical joint "X - 0.01 L", "X ~ L" where the factor is no number
  std::array<Real, 6> direction;  ///< resultant [N], then moment [N m]
};

/// What ties a body to the one before it in the tree: one link's joint, or those of several links in a row without
/// mass on which nothing acts.
struct Connection {
  std::string name;  ///< the joint's, as its author named it, else that of the frame it carries
  int top = 0;       ///< first link after `from`; components are along its axes
  int bottom = 0;    ///< last link, the body; components are at its origin
  int from = 0;      ///< link of the body before, 0 for the ground
  /// All wrenches that do no power in any virtual motion in which no other joint moves (ideal wrench, course §6.2.3),
  /// the efforts of joints driven by a law of time and those along released coordinates included.
  std::vector<ReactionComponent> components;
};

/// All connections of the scene's tree, parents first. Decided at a generic state with high precision: a component is
/// free when its power vanishes there, with probability one everywhere.
std::vector<Connection> connections(const Equations& equations);

/// By link: whether it counts as a body. The ground does, links with matter, and those on which an action or a constraint
/// acts; what acts on a link without mass is no action of its joint on the next body.
std::vector<bool> standing_links(const Equations& equations);

/// Evaluates at a generic state; quaternions have norm 1 there.
Evaluator<Real> at_generic_state(const Equations& equations, int state = 0);

/// Whether a number evaluated at the generic state is zero but for rounding.
bool is_negligible(const Real& x);

}  // namespace torsor
