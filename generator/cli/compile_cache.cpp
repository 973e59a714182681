// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/compile_cache.hpp"

#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

fs::path cache_folder() {
  std::string folder = environment("TORSOR_CACHE");
  if (folder.empty()) {
    const std::string cache = environment("XDG_CACHE_HOME"), home = environment("HOME");
    if (cache.empty() && home.empty()) {
      throw FileError("no folder to keep compiled mechanisms in: set TORSOR_CACHE, XDG_CACHE_HOME or HOME");
    }
    folder = cache.empty() ? home + "/.cache/torsor" : cache + "/torsor";
  }
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    throw FileError(fmt::format("cannot make the folder '{}': {}; set TORSOR_CACHE", folder, failure.message()));
  return fs::absolute(folder);
}

}  // namespace torsor
