// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsor {

/// The tool `torsor`: every command of a scene program, on the robot of a URDF file, e.g.
/// `torsor generate robot.urdf --kernels forward_dynamics --output robot.hpp`. Exit codes as those of scene programs; 3
/// for a file that cannot be read.
int run_torsor(int argc, const char* const* argv);

}  // namespace torsor
