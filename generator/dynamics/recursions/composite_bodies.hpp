// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// A wrench about the origin of a link, in its axes.
struct WrenchAt {
  std::size_t link = 0;
  Wrench wrench;
};

/// The bodies that remain when all joints beyond one are locked, and what moves them (Walker & Orin, 1982).
struct CompositeBodies {
  /// By link: it and all that it carries, about its origin, in its axes.
  std::vector<MassProperties> bodies;
  /// By link: the wrench that gives its composite the unit acceleration of its joint, {s ∧ h, J s} for a turn about s
  /// and {m s, h ∧ s} for a slide, seen from the link itself, then from each that carries it, down to the first.
  std::vector<std::vector<WrenchAt>> unit_wrenches;
};

/// How far unit wrenches are carried.
enum class UnitWrenches { to_the_first_link, not_at_all };

CompositeBodies composite_bodies(const BodyTree& tree, UnitWrenches carried = UnitWrenches::to_the_first_link);

/// A wrench at the origin of a link, seen from the origin of the link that carries it, in that one's axes.
Wrench in_parent(const BodyTree& tree, const Link& link, const Wrench& wrench);

}  // namespace torsor
