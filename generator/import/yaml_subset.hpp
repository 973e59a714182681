// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// The value of a YAML file as robots' parameters are written: mappings and lists in blocks or in brackets, numbers,
/// booleans, null, texts plain or in quotes, comments, one document; !degrees x is x π/180, !radians, !meters,
/// !kilograms x, !millimeters, !centimeters, !inches and their like in SI. Throws FileError "file:line: ..." for what
/// else YAML has (anchors, texts of several lines, several documents).
Value yaml_value(const std::string& text, const std::string& file);

}  // namespace torsor::xacro
