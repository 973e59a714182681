// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/import/mjcf.hpp"

namespace torsor {

/// What a generated header tells of reading.
struct MjcfHead {
  std::vector<std::string> renamed, changed, data, notes;
};

/// Where a scene made of that model comes from: the file's name without any folder, the options that are not at their
/// defaults, and notes on names, angles, what is stated and what does not act.
SceneOrigin mjcf_origin(const MjcfModel& model, const MjcfOptions& options, const MjcfHead& head);

}  // namespace torsor
