// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/compiled_library.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/base/process.hpp"
#include "torsor/generator/base/temporary_folder.hpp"
#include "torsor/generator/cli/compile_cache.hpp"
#include "torsor/generator/cli/compiler.hpp"
#include "torsor/generator/emission/library_sources.hpp"

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

/// The file that says it: an object and a library that are linked must have been made with one Eigen.
std::string eigen_version() {
  std::ifstream file(fs::path(eigen_folder()) / "Eigen/src/Core/util/Macros.h", std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What the compiler is asked.
struct Compilation {
  const Compiler& compiler;
  Words options;
  std::vector<SourceFile> sources;  ///< the first includes the others
  Words objects = {};               ///< to link with
};

/// `user` is for the message.
void compile(const Compilation& asked, const std::string& user, const fs::path& target) {
  const auto& [compiler, options, sources, objects] = asked;
  tell_of_compiling(user, compiler);
  const TemporaryFolder folder(target.parent_path(), target.stem().string() + "-");
  for (const SourceFile& source : sources) {
    const fs::path path = folder.path() / source.path;
    fs::create_directories(path.parent_path());
    write_file_if_changed(path.string(), source.text);
  }
  const fs::path made = folder.path() / ("made" + target.extension().string());
  Words command = compiler.words;
  command.insert(command.end(), options.begin(), options.end());
  const std::string first = (folder.path() / sources.front().path).string();
  command.insert(command.end(), {"-I", folder.path().string(), "-o", made.string(), first});
  command.insert(command.end(), objects.begin(), objects.end());
  const ProcessResult said = run_process(command);
  if (said.code != 0) {
    throw FileError(fmt::format("the compiler '{}' fails for '{}': {}{}", fmt::join(compiler.words, " "), user,
                                compiler_errors(said.output), eigen_remedy(said.output)));
  }
  std::error_code failure;
  fs::rename(made, target, failure);
  if (failure) throw FileError(fmt::format("cannot write '{}': {}", target.string(), failure.message()));
}

/// Where the cache has what comes of it. The objects follow from the options and are no part of the key.
fs::path kept(const std::string& name, const std::string& suffix, const Compilation& asked) {
  const auto& [compiler, options, sources, objects] = asked;
  Fnv key;
  for (const SourceFile& source : sources) key.add(source.path).add(source.text);
  for (const std::string& word : compiler.words) key.add(word).add(" ");
  for (const std::string& word : options) key.add(word).add(" ");
  key.add(compiler.version).add(processor());
  if (std::find(options.begin(), options.end(), eigen_folder()) != options.end()) key.add(eigen_version());
  return cache_folder() / fmt::format("{}-{:016x}{}", name, key.value(), suffix);
}

}  // namespace

Words compiler_flags(const LibraryOptions& options, const Scene& scene) {
  Words flags = separate_words(options.flags);
  flags.push_back(options.fused ? "-ffp-contract=fast" : "-ffp-contract=off");
  if (!scene.content().contacts.empty()) flags.push_back(fmt::format("-DTORSOR_MOST_CONTACTS={}", room_for_contacts(scene)));
  return flags;
}

std::string compiled_contact_layer(const Compiler& compiler, const Words& options) {
  Words words = {"-std=c++20", "-c", "-fPIC", "-fvisibility=hidden", "-isystem", eigen_folder()};
  words.insert(words.end(), options.begin(), options.end());
  const Compilation asked{compiler, std::move(words), contact_layer_sources()};
  const fs::path object = kept("contact_layer", ".o", asked);
  if (!fs::exists(object)) compile(asked, "the contact layer", object);
  return object.string();
}

std::string compiled_library(const MechanismListing& mechanism, const LibraryOptions& options) {
  const Compiler compiler = found_compiler("CXX", {"c++", "g++", "clang++"}, "C++20");
  const std::string& name = mechanism.scene().name();
  const bool contacts = !mechanism.scene().content().contacts.empty();
  const Words flags = compiler_flags(options, mechanism.scene());
  Words words = {"-std=c++20", "-shared", "-fPIC", "-fvisibility=hidden", "-pthread"};
  words.insert(words.end(), flags.begin(), flags.end());
  if (contacts) words.insert(words.end(), {"-isystem", eigen_folder(), "-DTORSOR_CONTACT_LAYER_APART"});
  Compilation asked{compiler, std::move(words), library_sources(mechanism)};
  const fs::path library = kept(name, ".so", asked);
  if (!fs::exists(library)) {
    if (contacts) asked.objects = {compiled_contact_layer(compiler, flags)};
    compile(asked, name, library);
  }
  return library.string();
}

}  // namespace torsor
