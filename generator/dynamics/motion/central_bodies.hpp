// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"

namespace torsor {

/// A rigid body by its centre of mass, in the axes of its link and in the tree's units (BodyTree::length_unit): mass,
/// place, operator there. Unlike m, h and J about the link's origin, none of them holds the difference of others.
struct CentralBody {
  std::size_t link = 0;
  Value mass;
  Vector center;
  Matrix inertia;
};

/// All bodies on moving links of a tree whose inertia is that of its bodies, not regrouped, link by link. Bodies of one link become one where that is exact: where all are numbers.
std::vector<CentralBody> central_bodies(const BodyTree& tree);

}  // namespace torsor
