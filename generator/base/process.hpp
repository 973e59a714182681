// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// What a program left: its exit code (128 + n after signal n) and what it wrote to standard output and error.
struct ProcessResult {
  int code = 0;
  std::string output;
};

/// Runs a program, found on the PATH, with arguments, without a shell, and waits for it.
/// Throws FileError where the program cannot be started.
ProcessResult run_process(const std::vector<std::string>& words);

}  // namespace torsor
