// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "torsor/generator/mechanics/scene_content.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// What a value comes to at the parameters' values in the scene, rounded: to choose between forms that are equal.
/// Nothing for a value that moves, or that has a parameter without a value.
std::optional<double> nominal_number(const SceneContent& scene, const Value& value);

}  // namespace torsor
