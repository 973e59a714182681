// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/expression/high_precision.hpp"
#include "generator/mechanics/scene_content.hpp"

namespace torsor {

/// Value of a formula of parameters, each at its own value (run-time parameters at their default), at the working
/// precision. Throws SceneError naming a parameter without a value or a symbol that is no parameter.
Real parameter_value(const SceneContent& scene, const Expression& formula);

}  // namespace torsor
