// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/base/process.hpp"
#include "torsor/generator/base/temporary_folder.hpp"
#include "torsor/generator/cli/compile_cache.hpp"
#include "torsor/generator/cli/compiler.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"

namespace torsor {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Where this program and its libraries are installed, or were built: both have the program in bin.
fs::path own_prefix() {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  return failure ? fs::path() : program.parent_path().parent_path();
}

/// The state of a file in few words. An input is read where that is cheap: a copy of a file has another date.
std::string state_of(const fs::path& path) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path, failure);
  if (failure) return "absent";
  constexpr std::uintmax_t text_size = 1U << 22U;
  if (size < text_size) return fmt::format("{:016x}", Fnv().add(text_of(path)).value());
  return fmt::format("{}-{}", size, fs::last_write_time(path, failure).time_since_epoch().count());
}

std::string states_of(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += fmt::format("{} {}\n", state_of(file), file);
  return text;
}

struct RecordedInput {
  std::string state, path;
};

/// Of a program in the cache; none where nothing was recorded.
std::vector<RecordedInput> inputs_recorded(const fs::path& program) {
  std::vector<RecordedInput> inputs;
  std::istringstream lines(text_of(program.string() + ".inputs"));
  RecordedInput input;
  while (lines >> input.state && lines.get() == ' ' && std::getline(lines, input.path)) inputs.push_back(input);
  return inputs;
}

/// Whether every input is what it was when the program was built.
bool inputs_are_unchanged(const fs::path& program) {
  const std::vector<RecordedInput> inputs = inputs_recorded(program);
  const auto unchanged = [](const RecordedInput& input) { return state_of(input.path) == input.state; };
  return !inputs.empty() && std::all_of(inputs.begin(), inputs.end(), unchanged);
}

/// The files of a rule of make, without its target; a blank in a name stands behind a backslash.
std::vector<std::string> prerequisites(const std::string& rule) {
  std::vector<std::string> files{""};
  for (std::size_t i = rule.find(": ") + 1; i < rule.size(); ++i) {
    const char c = rule[i];
    if (c == '\\' && i + 1 < rule.size() && rule[i + 1] != '\n') {
      files.back() += rule[++i];
    } else if (c == '$' && i + 1 < rule.size() && rule[i + 1] == '$') {
      files.back() += rule[++i];
    } else if (c != ' ' && c != '\n' && c != '\\') {
      files.back() += c;
    } else if (!files.back().empty()) {
      files.emplace_back();
    }
  }
  if (files.back().empty()) files.pop_back();
  return files;
}

/// What the build read: the files of its rules, and the library that it linked.
std::vector<std::string> inputs_of(const fs::path& build) {
  std::vector<std::string> files{text_of(build / "library.txt")};
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(build / "CMakeFiles" / "scene.dir")) {
      if (entry.path().extension() != ".d" || entry.path().filename().string().find(".o") == std::string::npos) continue;
      for (std::string& file : prerequisites(text_of(entry.path()))) files.push_back(std::move(file));
    }
  } catch (const fs::filesystem_error&) {
    return {};
  }
  return files;
}

/// Whether none was written since: what the compiler read is then what they hold now.
bool all_older(const std::vector<std::string>& files, fs::file_time_type moment) {
  for (const std::string& file : files) {
    std::error_code failure;
    const fs::file_time_type written = fs::last_write_time(file, failure);
    if (failure || written >= moment) return false;
  }
  return true;
}

bool misses_main(const std::string& output) {
  constexpr std::string_view symbol = "undefined symbol: main";
  const std::size_t at = output.find(symbol);
  const std::size_t end = at + symbol.size();
  if (at != std::string::npos && (end == output.size() || output[end] == '\n' || output[end] == '\r')) return true;
  return output.find("undefined reference to `main'") != std::string::npos;
}

[[noreturn]] void fail_to_build(const std::string& path, const std::string& output) {
  if (output.find("torsorConfig.cmake") != std::string::npos || output.find("torsor::generator") != std::string::npos) {
    throw FileError(fmt::format("cannot build the scene '{}': torsor's libraries are not found (Debian: "
                                "libtorsor-generator-dev), or what they need is missing; set torsor_ROOT to the folder "
                                "where torsor was installed or built",
                                path));
  }
  if (misses_main(output)) {
    throw FileError(fmt::format("the scene '{}' has no program: end it with TORSOR_SCENE(function), where the function "
                                "returns the scene",
                                path));
  }
  throw FileError(fmt::format("the compiler refuses the scene '{}': {}", path, compiler_errors(output)));
}

void run_cmake(const std::vector<std::string>& words, const std::string& path) {
  std::vector<std::string> command{"cmake"};
  command.insert(command.end(), words.begin(), words.end());
  ProcessResult said;
  try {
    said = run_process(command);
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}; a scene in C++ is built by CMake (Debian: cmake)", error.what()));
  }
  if (said.code != 0) fail_to_build(path, said.output);
}

void build(const std::string& path, const fs::path& program, const fs::path& record) {
  const TemporaryFolder folder(program.parent_path(), program.filename().string() + "-");
  const fs::path tree = folder.path() / "tree";
  write_file_if_changed((folder.path() / "CMakeLists.txt").string(),
                        std::string(embedded_template("scene_file/CMakeLists.txt.in")));
  std::vector<std::string> words{"-S", folder.path().string(), "-B", tree.string(),
                                 "-DSCENE:FILEPATH=" + path};
  if (environment("torsor_ROOT").empty() && environment("torsor_DIR").empty()) {
    words.push_back("-Dtorsor_ROOT:PATH=" + own_prefix().string());
  }
  const fs::file_time_type begun = fs::file_time_type::clock::now();
  run_cmake(words, path);
  run_cmake({"--build", tree.string()}, path);
  const std::vector<std::string> inputs = inputs_of(tree);
  // A file that was saved meanwhile may be newer than the program: without a record the next command builds again.
  const bool recorded = all_older(inputs, begun);
  const std::string states = states_of(inputs);
  std::error_code failure;
  fs::remove(record, failure);  // it must never tell of another program
  fs::rename(tree / "scene", program, failure);
  if (failure) throw FileError(fmt::format("cannot write '{}': {}", program.string(), failure.message()));
  if (recorded) write_file_if_changed(record.string(), states);
}

}  // namespace

bool names_scene_file(std::string_view word) {
  return word.ends_with(".cpp") || word.ends_with(".cc") || word.ends_with(".cxx");
}

std::string scene_file_program(const std::string& path) {
  std::error_code failure;
  const fs::path whole = fs::absolute(path, failure);
  if (failure || !fs::is_regular_file(whole, failure)) {
    throw FileError(fmt::format("there is no file '{}': give the name of a scene in C++", path));
  }
  const Compiler compiler = found_compiler("CXX", {"c++", "g++", "clang++"}, "C++20");
  Fnv key;
  for (const std::string& word : compiler.words) key.add(word).add("\n");
  key.add(compiler.version).add(TORSOR_VERSION).add("\n").add(own_prefix().string()).add("\n").add(whole.string());
  for (const char* name : {"torsor_ROOT", "torsor_DIR", "CXXFLAGS", "LDFLAGS", "CMAKE_PREFIX_PATH"}) {
    key.add("\n").add(environment(name));
  }
  const fs::path program = cache_folder() / fmt::format("scene-{:016x}", key.value());
  if (!fs::exists(program) || !inputs_are_unchanged(program)) {
    tell_of_compiling(path, compiler);
    build(whole.string(), program, program.string() + ".inputs");
  }
  return program.string();
}

std::vector<std::string> inputs_of_this_program() {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  std::vector<std::string> files;
  if (failure || !program.filename().string().starts_with("scene-")) return files;
  for (RecordedInput& input : inputs_recorded(program)) files.push_back(std::move(input.path));
  return files;
}

}  // namespace torsor
