// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace torsor {

/// A new folder that only this user can enter, removed with all that is in it.
class TemporaryFolder {
 public:
  /// In `parent`, under a name that begins with `prefix` and that nobody can foresee.
  /// Throws FileError naming folder and reason.
  TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix);
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// $TMPDIR, or what stands for it. Throws FileError where that is no folder.
std::filesystem::path folder_of_temporary_files();

}  // namespace torsor
