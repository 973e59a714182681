// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Part of `validate`: every symbol of the scene's formulas is the scene's own, also where one of another scene has its
/// name. Throws SceneError that names the object, the symbol and the remedy.
void check_ownership(const Scene& scene);

}  // namespace torsor
