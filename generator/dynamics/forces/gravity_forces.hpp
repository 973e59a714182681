// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"

namespace torsor {

/// Generalised forces of gravity as the bias has them, −Q_i(gravity) = −∂U/∂q_i, along every coordinate of the tree
/// (unknowns, then released ones) [N or N m]. Joint k turns all that it carries, of mass m and first moment h about the
/// joint's origin: s · (h ∧ −g) for a turn about s, m s · (−g) for a slide. h goes inwards from link to link, −g
/// outwards; no link asks for a wrench.
std::vector<Value> gravity_forces(const BodyTree& tree);

}  // namespace torsor
