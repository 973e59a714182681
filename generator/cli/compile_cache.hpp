// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace torsor {

/// The value of a variable of the environment; empty where it is not set.
std::string environment(const char* name);

/// Where what a compiler made is kept: $TORSOR_CACHE, or torsor in $XDG_CACHE_HOME, or ~/.cache/torsor; made where it is
/// missing. Throws FileError where it cannot be.
std::filesystem::path cache_folder();

}  // namespace torsor
