// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/output_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <list>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int reason) {
  const char* remedy = "check the path and its permissions";
  switch (reason) {
    case ENOENT:
    case ENOTDIR:
      remedy = "create the folder first, or choose another one";
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      remedy = "ask for the right to write there, or choose another place";
      break;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      remedy = "make room, or choose another disk";
      break;
    case EISDIR:
      remedy = "name a file in it";
      break;
    default:
      break;
  }
  throw FileError(fmt::format("cannot write '{}': {}; {}", path, std::strerror(reason), remedy));
}

/// An open file that closes itself; errors carry the name the user gave.
class Descriptor {
 public:
  Descriptor(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {
    if (descriptor_ < 0) fail(path_, errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  /// A name must not appear before the bytes that it stands for: the loss of power would leave an empty file.
  void synchronise() const {
    if (::fsync(descriptor_) != 0) fail(path_, errno);
  }
  /// Some file systems tell only now that the disk is full.
  void close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(path_, errno);
  }
  int number() const { return descriptor_; }

 private:
  int descriptor_;
  std::string path_;
};

/// Removes the temporary file unless it was renamed.
class TemporaryName {
 public:
  explicit TemporaryName(std::string name) : name_(std::move(name)) {}
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  void release() { name_.clear(); }

 private:
  std::string name_;
};

/// The number in /dev/stdout, /dev/stderr, /dev/fd/<n>: opening such a name anew would start at offset 0 of a file that
/// a shell has redirected to.
std::optional<int> inherited_descriptor(const std::string& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string number = path.substr(folder.size());
    if (number.empty() || number.size() > 6 || number.find_first_not_of("0123456789") != std::string::npos) continue;
    return std::stoi(number);
  }
  return std::nullopt;
}

bool has_bytes(const std::string& path, std::string_view bytes) {
  std::error_code ignored;
  if (fs::file_size(path, ignored) != bytes.size() || ignored) return false;
  std::ifstream file(path, std::ios::binary);
  const std::string present((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return file && present == bytes;
}

/// A regular file whose bytes lie beside it, under another name, until `appear`.
class Replacement {
 public:
  Replacement(std::string path, std::string target, std::string_view bytes, const struct stat* present)
      : path_(std::move(path)), target_(std::move(target)), temporary_(fmt::format("{}.{}.tmp", target_, ::getpid())) {
    Descriptor file(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666), path_);
    guard_.emplace(temporary_);
    if (present != nullptr && ::fchmod(file.number(), present->st_mode & 07777U) != 0) fail(path_, errno);
    file.write(bytes);
    file.synchronise();
    file.close();
  }

  void appear() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
    guard_->release();
  }

 private:
  std::string path_, target_, temporary_;
  std::optional<TemporaryName> guard_;
};

void write_through(int descriptor, const std::string& path, std::string_view bytes) {
  Descriptor file(descriptor, path);
  file.write(bytes);
  file.close();
}

/// A file on its way: everything that can fail before its name appears is done in the constructor.
class Writing {
 public:
  Writing(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {
    if (path.empty()) throw FileError("cannot write a file without a name: give a path, or /dev/stdout");
    inherited_ = inherited_descriptor(path);
    if (inherited_) return;
    struct stat present {};
    if (::stat(path.c_str(), &present) != 0) {
      if (errno != ENOENT) fail(path, errno);
      // A link to nothing: the file it names is what has to appear.
      std::error_code not_a_link;
      const fs::path linked = fs::read_symlink(path, not_a_link);
      replacement_.emplace(path, not_a_link ? path : (fs::path(path).parent_path() / linked).string(), bytes, nullptr);
      return;
    }
    if (S_ISDIR(present.st_mode)) fail(path, EISDIR);
    if (!S_ISREG(present.st_mode)) return;
    same_ = has_bytes(path, bytes);
    if (same_) return;
    if (::access(path.c_str(), W_OK) != 0) fail(path, errno);  // a rename would not ask
    replacement_.emplace(path, fs::canonical(path).string(), bytes, &present);
  }

  /// Returns whether the file had to be written.
  bool finish() {
    if (same_) return false;
    if (replacement_) {
      replacement_->appear();
    } else if (inherited_) {
      std::cout.flush();
      std::fflush(stdout);
      write_through(::dup(*inherited_), path_, bytes_);
    } else {
      write_through(::open(path_.c_str(), O_WRONLY | O_CLOEXEC), path_, bytes_);
    }
    return true;
  }

 private:
  std::string path_;
  std::string_view bytes_;
  std::optional<int> inherited_;
  std::optional<Replacement> replacement_;
  bool same_ = false;
};

}  // namespace

bool write_file_if_changed(const std::string& path, std::string_view bytes) { return Writing(path, bytes).finish(); }

void write_files_if_changed(const std::vector<OutputFile>& files) {
  std::list<Writing> all;
  for (const OutputFile& file : files) all.emplace_back(file.path, file.text);
  for (Writing& each : all) each.finish();
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code unknown;
  if (fs::exists(a, unknown) && !fs::is_regular_file(a, unknown)) return false;  // /dev/null takes everything
  if (fs::equivalent(a, b, unknown) && !unknown) return true;
  // Of a relative name that is not there yet nothing would be made absolute.
  const auto whole = [&unknown](const std::string& path) { return fs::weakly_canonical(fs::absolute(path, unknown), unknown); };
  const fs::path of_a = whole(a), of_b = whole(b);
  return of_a == of_b;
}

}  // namespace torsor
