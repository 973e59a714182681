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

/// A folder of this process, made empty, and removed with all that is in it.
class WorkFolder {
 public:
  explicit WorkFolder(std::filesystem::path path);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace torsor
