// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/forces/constraints.hpp"

namespace torsor {

/// Adds the friction of contacts to the rows of their normal constraints: for a unit normal force the force −f d at the
/// contact, or the moment −h d, d = direction/|direction|, works with the coordinates (course, §6.2.3). Fills `column`,
/// `friction` and `friction_power`. Throws SceneError when the multiplier of the constraint is no force [N], when the
/// direction is the null vector, or when body and other are one rigid body.
void add_friction(const Model& model, std::vector<ConstraintRow>& rows);

}  // namespace torsor
