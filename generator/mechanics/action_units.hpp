// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// Refuses springs, dampers, forces and torques whose quantities are not in the units that their equations need. Throws
/// UnitError that names the action, the quantity and what was given for it. Other actions are looked at when they are
/// declared.
void require_action_units(const ActionContent& action);

}  // namespace torsor
