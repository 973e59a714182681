// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "torsor/generator/mechanics/scene.hpp"

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
  bool held = false;        ///< a constraint holds what `released` would release: the same mechanism by another derivation
  bool chains = false;        ///< a chain of several joints that closes, redundant ones among them
  bool conservative = false;  ///< only what has a first integral: motions are imposed by a turntable only
  bool weightless = false;
  int most_bodies = 5;
};

/// Every switch by its name.
struct RandomMechanismSwitch {
  const char* name;
  bool RandomMechanismOptions::*value;
};
inline constexpr std::array<RandomMechanismSwitch, 11> random_mechanism_switches{
    {{"actions", &RandomMechanismOptions::actions},
     {"motors", &RandomMechanismOptions::motors},
     {"driven", &RandomMechanismOptions::driven},
     {"released", &RandomMechanismOptions::released},
     {"constraints", &RandomMechanismOptions::constraints},
     {"joints", &RandomMechanismOptions::joints},
     {"loops", &RandomMechanismOptions::loops},
     {"held", &RandomMechanismOptions::held},
     {"chains", &RandomMechanismOptions::chains},
     {"conservative", &RandomMechanismOptions::conservative},
     {"weightless", &RandomMechanismOptions::weightless}}};

/// The call that builds the same mechanism again: random_mechanism(7, {.actions = true, ..., .most_bodies = 2}).
std::string call_of(unsigned seed, const RandomMechanismOptions& options);

/// A tree of one to five bodies with random joints (revolute and prismatic, aligned and skew axes, some displaced by
/// formulas of several coordinates), placements, inertias and actions. The same seed gives the same scene everywhere.
/// All numbers are small fractions, so that no two units or places coincide by accident.
Scene random_mechanism(unsigned seed, const RandomMechanismOptions& options = {});

}  // namespace torsor::testing_mechanisms
