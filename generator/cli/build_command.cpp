// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/compiled_library.hpp"
#include "torsor/generator/cli/compiler.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/emission/library_sources.hpp"

namespace torsor {
namespace {

namespace fs = std::filesystem;

struct BuildRequest : KernelOptions {
  LibraryOptions library;
  std::string sources;  ///< a folder; nothing is compiled then
};

/// To be written as what a command leaves; their folders are made here.
std::vector<OutputFile> sources_in(const std::string& folder, const MechanismListing& mechanism) {
  std::vector<OutputFile> files;
  for (const SourceFile& source : library_sources(mechanism)) {
    const fs::path path = fs::path(folder) / source.path;
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    if (failure) throw FileError(fmt::format("cannot make the folder of '{}': {}", path.string(), failure.message()));
    files.push_back({path.string(), source.text});
  }
  return files;
}

CommandResult build(const Scene& scene, const BuildRequest& request, const std::string& output) {
  const MechanismListing mechanism = lower_library(scene, request.names(), request.model(scene));
  if (!request.sources.empty()) {
    if (output != "-")
      throw UsageError("--sources writes what a library is compiled from, and compiles nothing: leave --output out");
    if (request.library.fused || request.library.flags != LibraryOptions().flags)
      throw UsageError("--sources compiles nothing: give what --flags and --fused say to your own compiler");
    return {.text = (fs::path(request.sources) / "library.cpp").string() + "\n",
            .files = sources_in(request.sources, mechanism)};
  }
  const std::string library = compiled_library(mechanism, request.library);
  return {output == "-" ? library + "\n" : compiled_bytes(library)};
}

}  // namespace

void add_build_command(CommandSet& commands) {
  const auto request = std::make_shared<BuildRequest>();
  CLI::App& command =
      commands.add("build", "compile a shared library with the interface of runtime/abi.h, by $CXX",
                   [request, &commands](const Scene& scene) { return build(scene, *request, commands.output()); });
  add_kernel_options(command, *request);
  command.add_option("--flags", request->library.flags, "of the compiler, separated by spaces")->capture_default_str();
  command.add_flag(
      "--fused", request->library.fused,
      "let the compiler fuse products with sums: faster, and results differ in their last digits from those "
      "of other compilers, and a state's alone from the same among others");
  command.add_option("--sources", request->sources,
                     "folder to write the sources to, library.cpp and what it includes; nothing is compiled");
  command.get_option("--output")->description("library to write; its path in the cache is printed when absent");
}

}  // namespace torsor
