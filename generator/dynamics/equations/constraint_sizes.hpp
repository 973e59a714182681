// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// What counts as small for the constraints of a scene, whatever their units: f = 0 may be written in metres or in
/// kilometres, be divided by a force or multiplied by a million.
///
/// The usual size of a term is the largest |A_ji| at the initial configuration and at three others, whose angles are up to
/// half a radian away. The reach r_i of a freedom that turns is 1. That of all freedoms of another unit is the median
/// of the levers Σ_turning |A_jk| / |A_ji|; where nothing turns, their largest initial value, or 1. Then
///   size_j = Σ_i |A_ji| r_i
/// is the change of f_j when everything moves by its reach: |f_j| / size_j has no unit.
struct ConstraintSizes {
  std::vector<Real> reach;  ///< by freedom, in the unit of its coordinate
  std::vector<Real> size;   ///< by constraint, in the unit of f (of its rate in seconds when it is not holonomic)
};

/// Whether that freedom is a turn, measured in radians; else it has a unit of its own.
bool freedom_turns(const Model& model, std::size_t freedom);

ConstraintSizes constraint_sizes(const Model& model, const std::vector<ConstraintRow>& rows);

}  // namespace torsor
