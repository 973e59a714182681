// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/compiled_library.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/base/error.hpp"
#include "generator/base/fnv.hpp"
#include "generator/base/output_file.hpp"
#include "generator/base/process.hpp"
#include "generator/base/temporary_folder.hpp"
#include "generator/cli/compile_cache.hpp"
#include "generator/cli/compiler.hpp"
#include "generator/emission/library_sources.hpp"

namespace torsor {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// What -march=native means here: a folder may be shared by machines.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string text;
  for (std::string line; std::getline(file, line) && !line.empty();) {
    if (line.starts_with("model name") || line.starts_with("flags") || line.starts_with("Features"))
      text += line + "\n";
  }
  return text;
}

Words compiler_options(const MechanismListing& mechanism, const LibraryOptions& options) {
  Words words = {"-std=c++20", "-shared", "-fPIC", "-fvisibility=hidden", "-pthread"};
  for (const std::string& flag : separate_words(options.flags)) words.push_back(flag);
  words.push_back(options.fused ? "-ffp-contract=fast" : "-ffp-contract=off");
  if (!mechanism.scene().content().contacts.empty()) words.insert(words.end(), {"-isystem", eigen_folder()});
  return words;
}

void compile(const Compiler& compiler, const Words& options, const std::vector<SourceFile>& sources,
             const MechanismListing& mechanism, const fs::path& library) {
  const TemporaryFolder folder(library.parent_path(), library.stem().string() + "-");
  for (const SourceFile& source : sources) {
    const fs::path path = folder.path() / source.path;
    fs::create_directories(path.parent_path());
    write_file_if_changed(path.string(), source.text);
  }
  const fs::path made = folder.path() / "library.so";
  Words command = compiler.words;
  command.insert(command.end(), options.begin(), options.end());
  for (const std::string& word : {std::string("-I"), folder.path().string(), std::string("-o"), made.string(),
                                  (folder.path() / sources.front().path).string()}) {
    command.push_back(word);
  }
  const ProcessResult said = run_process(command);
  if (said.code != 0) {
    throw FileError(fmt::format("the compiler '{}' fails for '{}': {}{}", fmt::join(compiler.words, " "),
                                mechanism.scene().name(), compiler_errors(said.output), eigen_remedy(said.output)));
  }
  std::error_code failure;
  fs::rename(made, library, failure);
  if (failure) throw FileError(fmt::format("cannot write '{}': {}", library.string(), failure.message()));
}

}  // namespace

std::string compiled_library(const MechanismListing& mechanism, const LibraryOptions& options) {
  const Compiler compiler = found_compiler("CXX", {"c++", "g++", "clang++"}, "C++20");
  const std::vector<SourceFile> sources = library_sources(mechanism);
  const Words words = compiler_options(mechanism, options);
  Fnv key;
  for (const SourceFile& source : sources) key.add(source.path).add(source.text);
  for (const std::string& word : compiler.words) key.add(word).add(" ");
  for (const std::string& word : words) key.add(word).add(" ");
  key.add(compiler.version).add(processor());
  const fs::path library = cache_folder() / fmt::format("{}-{:016x}.so", mechanism.scene().name(), key.value());
  if (!fs::exists(library)) compile(compiler, words, sources, mechanism, library);
  return library.string();
}

}  // namespace torsor
