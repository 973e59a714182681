// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor::printing {

/// A sentence for each set of names that typeset formulas spell in one way, as m1 and m_1: with them a formula is not the
/// scene's.
std::vector<std::string> alike_names(const SceneContent& scene, const NaturalLanguage& say);

}  // namespace torsor::printing
