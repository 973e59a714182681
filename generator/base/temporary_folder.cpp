// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix) {
  std::string name = (parent / (prefix + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw FileError(fmt::format("cannot make a folder in '{}': {}", parent.string(), std::strerror(errno)));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path folder_of_temporary_files() {
  std::error_code failure;
  std::filesystem::path path = std::filesystem::temp_directory_path(failure);
  if (failure) throw FileError(fmt::format("no folder for temporary files: {}; set TMPDIR to one", failure.message()));
  return path;
}

}  // namespace torsor
