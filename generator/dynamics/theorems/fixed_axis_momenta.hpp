// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"

namespace torsor {

/// What a turn about a fixed axis says of a body whose attitude is a unit quaternion.
struct FixedAxisMomentum {
  std::string frame;                 ///< that the attitude turns
  std::string base, axis;            ///< the axis is x, y or z of this frame
  bool about_base = false;           ///< through the base's origin, or where `zero` are; else through the body's own origin
  std::vector<std::string> zero;     ///< lengths of a body that lead from another point
  Value momentum;                    ///< about the axis; the integral, where nothing stands against it
  std::vector<std::string> reasons;  ///< why it is none; empty where it is constant
};

/// Noether's theorem for turns about fixed axes: the turn of an attitude about an axis d of the frame before it, ω = Rᵀ d, and
/// the same with the turn d ∧ r of the lengths of a free body across d. Where T does not change by it and no force works along it,
/// Σ ξ_i ∂T/∂v_i is constant (Arnold, Mathematical Methods of Classical Mechanics, §20). Three for every attitude: of the two
/// turns the first one that keeps the momentum, or the turn about the body's own origin. Meant for a reader, as `missing_momenta`.
std::vector<FixedAxisMomentum> fixed_axis_momenta(const Equations& equations, const NaturalLanguage& say = {});

}  // namespace torsor
