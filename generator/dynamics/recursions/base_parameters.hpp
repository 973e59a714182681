// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

/// Which columns of a regressor Y are independent functions of the state, and what the others are made of:
/// Y_d = Y_b K, so that Y π = Y_b (π_b + K π_d) whatever the inertia (Gautier, Numerical calculation of the base
/// inertial parameters of robots, 1991). Columns are met from the first link to the last, each link's in the order of
/// inertial_parameters, and kept when they do not depend on those kept before: what a joint cannot tell apart goes
/// towards the ground, as in Gautier & Khalil, Direct calculation of minimum set of inertial parameters of serial
/// robots, 1990.
///
/// Constraints are not used: on a closed loop v and a are taken as free, although a motion that respects it could tell
/// fewer parameters apart.
struct BaseParameters {
  std::vector<std::size_t> independent, dependent;  ///< columns, ascending
  std::vector<std::vector<Real>> combination;       ///< K, row by row: [independent][dependent]
  bool at_any_parameters = true;  ///< K holds when run-time parameters change; else at their values in the scene only
};

/// Columns of Y at pseudo-random states, the same on every run, as many as it takes: the relations found are tested at
/// further states, in 200 digits where 50 do not tell. Throws SceneError when the regressor is undefined wherever it is
/// looked at, Error when those are too few to tell.
BaseParameters base_parameters(const Model& model, const ValueMatrix& y);

}  // namespace torsor
