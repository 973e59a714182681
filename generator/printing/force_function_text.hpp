// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/dynamics/forces/selected_actions.hpp"

namespace torsor {

/// What a person reads of classify_force_function (generator/dynamics/theorems/force_function.hpp): the Q_i and the whole power of the
/// selected actions, which of the three cases it is, why, and U. Formulas with parameters as symbols.
std::string force_function_text(const Scene& scene, const ActionSelection& selection);

}  // namespace torsor
