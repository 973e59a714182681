// SPDX-License-Identifier: MIT
#pragma once
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace torsor::runtime {

/// A file that cannot be read, written or understood; the text names the file, what is wrong and the remedy.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace detail {

[[noreturn]] inline void fail_to_write(const std::filesystem::path& path, int reason) {
  throw FileError("cannot write '" + path.string() + "': " + std::strerror(reason) +
                  "; choose a folder that exists, is writable and has room");
}

/// Hands what was written to the disk itself, where the system can be asked to. 0, or the system's reason.
inline int synchronise(std::FILE* file) noexcept {
  errno = 0;
  if (std::fflush(file) != 0) return errno != 0 ? errno : EIO;
#if __has_include(<unistd.h>)
  if (::fsync(::fileno(file)) != 0) return errno;
#endif
  return 0;
}

/// Writes the text and closes the file. `for_rename`: a name must not appear before the bytes that it stands for, which
/// the loss of power would otherwise leave as an empty file. 0, or the system's reason.
inline int write_all(std::FILE* file, std::string_view text, bool for_rename) noexcept {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int reason = written ? 0 : (errno != 0 ? errno : EIO);
  if (for_rename && reason == 0) reason = synchronise(file);
  errno = 0;
  if (std::fclose(file) != 0 && reason == 0) reason = errno != 0 ? errno : EIO;
  return reason;
}

/// A name beside `path` that no other process uses: the file is created by it and must not have existed.
inline std::filesystem::path temporary_beside(const std::filesystem::path& path, std::FILE*& file) {
  std::random_device entropy;
  for (int attempt = 0; attempt < 16; ++attempt) {
    std::filesystem::path candidate = path;
    candidate += '.';
    candidate += std::to_string(entropy());
    candidate += ".partial";
    errno = 0;
    file = std::fopen(candidate.string().c_str(), "wbx");
    if (file != nullptr) return candidate;
    if (errno != EEXIST) fail_to_write(path, errno);
  }
  fail_to_write(path, EEXIST);
}

}  // namespace detail

/// Writes the whole text to a temporary file beside `path` and renames it, so that a reader sees the old file or the
/// new one and never half of it. What exists and is no regular file (a device, a pipe) is written through; a symbolic
/// link is followed. Throws FileError with the system's reason.
inline void write_file(const std::filesystem::path& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    std::FILE* file = std::fopen(path.string().c_str(), "wb");
    if (file == nullptr) detail::fail_to_write(path, errno);
    if (const int reason = detail::write_all(file, text, false); reason != 0) detail::fail_to_write(path, reason);
    return;
  }
  std::error_code not_canonical;
  fs::path target = fs::canonical(path, not_canonical);
  if (not_canonical) target = path;
  std::FILE* file = nullptr;
  const fs::path temporary = detail::temporary_beside(target, file);
  int reason = detail::write_all(file, text, true);
  if (reason == 0) {
    std::error_code renaming;
    fs::rename(temporary, target, renaming);
    reason = renaming.value();
  }
  if (reason != 0) {
    fs::remove(temporary, ignored);
    detail::fail_to_write(path, reason);
  }
}

/// Opens a file to be read line by line. Throws FileError with the system's reason.
inline std::ifstream open_file(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream stream(path);
  if (!stream || std::filesystem::is_directory(path)) {
    const int reason = errno != 0 ? errno : EISDIR;
    throw FileError("cannot read '" + path.string() + "': " + std::strerror(reason) + "; check the path");
  }
  return stream;
}

}  // namespace torsor::runtime
