// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// Writes the folder `name` with the beginning of a project: scene.cpp, main.cpp, CMakeLists.txt and README.md, which says how
/// to build it and to make its page. Returns the files' names. Throws SceneError for a name that no scene can have and
/// FileError where the folder exists already or cannot be made.
std::vector<std::string> write_new_project(const std::string& name);

}  // namespace torsor
