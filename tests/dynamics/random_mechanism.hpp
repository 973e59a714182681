// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/mechanics/scene.hpp"

namespace torsor::testing_mechanisms {

/// What a random mechanism may contain.
struct RandomMechanismOptions {
  bool actions = true;      ///< springs, dampers, given forces and torques
  bool motors = false;      ///< a motor on every unknown instead of a few
  bool driven = true;       ///< laws of time
  bool released = true;     ///< a released coordinate
  bool constraints = true;  ///< holonomic, non-holonomic and closure constraints
};

/// A tree of one to five bodies with random joints (revolute and prismatic, aligned and skew axes, some displaced by
/// formulas of several coordinates), placements, inertias and actions. The same seed gives the same scene everywhere.
/// All numbers are small fractions, so that no two units or places coincide by accident.
Scene random_mechanism(unsigned seed, const RandomMechanismOptions& options = {});

}  // namespace torsor::testing_mechanisms
