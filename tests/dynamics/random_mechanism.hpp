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
  bool joints = false;      ///< every joint of the table instead of revolute and prismatic ones, quaternions included
  bool loops = false;       ///< a free body tied to another one by a joint of the table
  bool held = false;        ///< a constraint holds what `released` would release: the same mechanism by another road
  int most_bodies = 5;
};

/// A tree of one to five bodies with random joints (revolute and prismatic, aligned and skew axes, some displaced by
/// formulas of several coordinates), placements, inertias and actions. The same seed gives the same scene everywhere.
/// All numbers are small fractions, so that no two units or places coincide by accident.
Scene random_mechanism(unsigned seed, const RandomMechanismOptions& options = {});

}  // namespace torsor::testing_mechanisms
