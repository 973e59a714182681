// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/text_of_file.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

constexpr std::size_t most_bytes = std::size_t{256} << 20U;
constexpr std::chrono::seconds patience{5};
constexpr std::chrono::milliseconds nap{10};
constexpr int longest_silence = 60000;  // [ms]; expanding a large robot takes seconds

class Source {
 public:
  explicit Source(std::string path) : path_(std::move(path)) {
    struct stat status {};
    if (::stat(path_.c_str(), &status) != 0) fail();
    if (S_ISDIR(status.st_mode)) throw FileError(fmt::format("cannot read '{}': it is a folder; name a file in it", path_));
    // Of a named pipe, so that opening it does not wait for ever for a program that writes.
    is_pipe_ = S_ISFIFO(status.st_mode);
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | (is_pipe_ ? O_NONBLOCK : 0));
    if (descriptor_ < 0) fail();
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  std::string read_all() const {
    std::string text;
    std::array<char, 1U << 16U> buffer{};
    const auto start = std::chrono::steady_clock::now();
    while (true) {
      const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
      if (count > 0) {
        append(text, {buffer.data(), static_cast<std::size_t>(count)});
      } else if (count == 0) {
        if (!is_pipe_ || !text.empty() || has_ended()) return text;
        if (std::chrono::steady_clock::now() - start > patience) {
          throw FileError(fmt::format("cannot read '{}': no program writes to this pipe; start it first", path_));
        }
        std::this_thread::sleep_for(nap);
      } else if (errno == EAGAIN) {  // a program has opened the pipe and has not written yet
        struct pollfd waiting {descriptor_, POLLIN, 0};
        if (::poll(&waiting, 1, longest_silence) == 0) {
          throw FileError(fmt::format("cannot read '{}': the program that has opened this pipe writes nothing; end it", path_));
        }
      } else if (errno != EINTR) {
        fail();
      }
    }
  }

 private:
  /// Of a pipe without bytes: whether a program that wrote to it has gone.
  bool has_ended() const {
    struct pollfd state {descriptor_, POLLIN, 0};
    return ::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) != 0;
  }

  void append(std::string& text, std::string_view bytes) const {
    text += bytes;
    if (bytes.find('\0') != std::string_view::npos) {
      throw FileError(fmt::format("{}: the file is binary and no XML", path_));
    }
    if (text.size() > most_bytes) {
      throw FileError(fmt::format("cannot read '{}': it is larger than 256 MiB, which no robot is", path_));
    }
  }

  [[noreturn]] void fail() const {
    const int reason = errno;
    if (reason == ENOENT || reason == ENOTDIR) {
      throw FileError(fmt::format("cannot read '{}': does the file exist?", path_));
    }
    throw FileError(fmt::format("cannot read '{}': {}; check the path and its permissions", path_, std::strerror(reason)));
  }

  std::string path_;
  bool is_pipe_ = false;
  int descriptor_ = -1;
};

}  // namespace

std::string text_of_file(const std::string& path) { return Source(path).read_all(); }

}  // namespace torsor
