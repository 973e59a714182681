// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// The command line of every scene program: docs/commands.md lists its commands. Exit codes: 0; 1 a check failed; 2
/// bad usage, an unknown kernel included; 3 an error in the scene or with a file.
int run_scene_program(int argc, const char* const* argv, Scene (*make_scene)());

}  // namespace torsor

/// Gives a scene function a main, unless TORSOR_NO_MAIN is defined (for programs that use the function themselves).
#ifdef TORSOR_NO_MAIN
#define TORSOR_SCENE(function) static_assert(true, "");
#else
#define TORSOR_SCENE(function) \
  int main(int argc, char** argv) { return torsor::run_scene_program(argc, argv, function); }
#endif
