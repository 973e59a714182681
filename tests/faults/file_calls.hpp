// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace torsor::testing_files {

/// The calls of this program that bring a file to the disk, as they were made: "fsync", "close", "fclose", "rename". One of
/// them can be made to fail, as on a disk that is full or broken.
struct FileCalls {
  std::string fails;  ///< the call that fails from now on; none when empty
  std::vector<std::string> made;
};
[[nodiscard]] FileCalls& file_calls();

}  // namespace torsor::testing_files
