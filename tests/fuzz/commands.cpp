// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines of scene programs and of the tool torsor, run in this process in a folder of its own.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "torsor/generator/cli/scene_program.hpp"
#include "torsor/generator/cli/torsor_program.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/fuzz/text_rules.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::fuzzing {
namespace {

namespace fs = std::filesystem;

/// The folder that programs run in; what they write there is removed.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("torsor_fuzz_folder_" + std::to_string(::getpid()))) {
    fs::create_directory(path_);
    fs::current_path(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::current_path("/", ignored);
    fs::remove_all(path_, ignored);
  }
  void empty() const {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
  }

 private:
  fs::path path_;
};

/// A stream of the process, written to a file for a while and then read back.
class Captured {
 public:
  Captured(std::FILE* stream, int number) : stream_(stream), number_(number), kept_(::dup(number)), file_(std::tmpfile()) {
    std::fflush(stream_);
    if (kept_ < 0 || file_ == nullptr || ::dup2(::fileno(file_), number_) < 0) throw std::runtime_error("no file to write to");
  }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;
  ~Captured() {
    std::fflush(stream_);
    ::dup2(kept_, number_);
    ::close(kept_);
    std::fclose(file_);
  }
  std::string text() {
    std::fflush(stream_);
    std::rewind(file_);
    std::string text;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), file_)) > 0;) text.append(buffer.data(), n);
    return text;
  }

 private:
  std::FILE* stream_;
  int number_, kept_;
  std::FILE* file_;
};

/// Commands that may rightly take long, and words that are no names of files in the folder.
bool is_left_out(const std::string& word) {
  static constexpr std::array<std::string_view, 3> long_ones{"check", "verify", "reference"};
  return word.find('/') != std::string::npos || word.find('\0') != std::string::npos ||
         std::find(long_ones.begin(), long_ones.end(), word) != long_ones.end();
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// What a program of that command line says and does is what --help promises.
template <class Program>
void run_program(const std::vector<std::string>& words, const Program& program) {
  if (std::any_of(words.begin(), words.end(), is_left_out)) return;
  std::vector<const char*> argv{"program"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  std::string out, err;
  int code = 0;
  {
    Captured output(stdout, STDOUT_FILENO), error(stderr, STDERR_FILENO);
    code = program(static_cast<int>(argv.size()), argv.data());
    out = output.text();
    err = error.text();
  }
  if (code < 0 || code > 3) throw std::logic_error("exit code " + std::to_string(code));
  if (code >= 2 && (err.empty() || !out.empty())) throw std::logic_error("a refusal without a reason, or with results");
  expect_lines(err);
  expect_lines(out);
}

/// A pendulum that names a few of all there is.
Scene pendulum() {
  Scene scene = testing_mechanisms::pendulum_with_motor();
  scene.point("tip", "arm", {0, Expression::quantity("-1", "m"), 0});
  return scene;
}

}  // namespace

void run_scene_command(std::string_view input) {
  static const Folder folder;
  run_program(lines_of(input), [](int argc, const char* const* argv) { return run_scene_program(argc, argv, pendulum); });
  folder.empty();
}

void run_robot_command(std::string_view input) {
  static const Folder folder;
  const std::size_t end = std::min(input.find("\n\n"), input.size());
  const std::string_view robot = input.substr(std::min(end + 2, input.size()));
  std::ofstream("robot.urdf", std::ios::binary).write(robot.data(), static_cast<std::streamsize>(robot.size()));
  run_program(lines_of(input.substr(0, end)), [](int argc, const char* const* argv) { return run_torsor(argc, argv); });
  folder.empty();
}

}  // namespace torsor::fuzzing
