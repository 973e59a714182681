// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/import/mechanism_file.hpp"

namespace torsor {

/// The tool `torsor`: every command of a scene program, on the robot of a URDF, xacro or MJCF file, e.g.
/// `torsor generate robot.urdf --kernels forward_dynamics --output robot.hpp`. Exit codes as those of scene programs; 3
/// for a file that cannot be read. `torsor scene.cpp COMMAND` compiles a scene and becomes its program. Without a reader of MJCF such files are refused.
int run_torsor(int argc, const char* const* argv, MjcfReader mjcf_reader = nullptr);

}  // namespace torsor
