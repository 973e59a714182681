// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "generator/mechanics/scene.hpp"

namespace CLI {
class App;
}

namespace torsor {

/// What a program's commands work on: a scene written in C++, or one read from a file that the command line names.
struct SceneSource {
  std::string description;                     ///< the first line of --help
  std::function<void(CLI::App&)> add_options;  ///< adds what the source needs to one command; may be empty
  std::function<Scene()> make;                 ///< called when the command line has been read
  std::function<bool()> quiet = {};            ///< whether notes are left out; may be empty
};

/// The command line of every program (scene_program.hpp) on that source.
int run_commands(int argc, const char* const* argv, const SceneSource& source);

}  // namespace torsor
