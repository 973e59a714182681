// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Two directions across the axis n of a joint, in the axes of the link that it carries, orthonormal whatever n is:
/// t_x = e_x − n_x h/(1 + |n_z|) with h = n ± e_z, the sign that of n_z, and the same of y.
/// Source: Duff et al., Building an orthonormal basis, revisited, 2017.
std::vector<Vector> across_axis(Program& program, const Link& link);

/// By link: whether the joint of `link` carries it.
std::vector<bool> carried_links(const Model& model, int link);

/// What a unit multiplier of each constraint adds to the force that a joint transmits to the link that it carries, along
/// each direction across its axis, by constraint. Constraints given as formulas act in the joints and add nothing.
std::vector<std::vector<Value>> constraint_loads(const Model& model, int link);

}  // namespace torsor
