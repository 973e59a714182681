// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/cli/torsor_program.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::testing_programs {

/// Runs the tool in this process, as `torsor <arguments>`, with a reader of MJCF files or none.
inline Outcome torsor_tool(const std::vector<std::string>& arguments, MjcfReader reader = nullptr) {
  return run_main("torsor", arguments,
                  [&](int argc, const char* const* argv) { return run_torsor(argc, argv, reader); });
}

}  // namespace torsor::testing_programs
