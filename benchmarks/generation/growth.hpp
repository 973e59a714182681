// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// Prints seconds, peak memory and operations from a chain's scene to its header, for each number of joints, every one
/// in a process of its own; with a folder, growth.csv and pictures of time and operations go there. Throws
/// std::runtime_error where a process fails.
void measure_growth(const std::vector<int>& joints, const std::string& folder);

}  // namespace torsor
