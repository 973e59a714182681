// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// The files besides itself that an MJCF file names and that are there: included ones, theirs, and those of assets
/// (meshes, height fields), which moments of inertia depend on; in the order of the text, each once.
std::vector<std::string> mjcf_files(const std::string& path);

}  // namespace torsor
