// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "generator/base/error.hpp"
#include "generator/base/output_file.hpp"
#include "generator/base/process.hpp"
#include "generator/base/zip_archive.hpp"
#include "generator/cli/command_set.hpp"
#include "generator/cli/compiler.hpp"
#include "generator/cli/kernel_options.hpp"
#include "generator/dynamics/equations/contact_checks.hpp"
#include "generator/dynamics/equations/contact_checks.hpp"
#include "generator/emission/fmi_description.hpp"

namespace torsor {
namespace {

namespace files = std::filesystem;

struct UnitRequest : KernelOptions {
  std::string flags = "-O2";
  bool sources_only = false;
};

/// A folder for one compilation, removed with all that is in it.
class CompilationFolder {
 public:
  CompilationFolder() : path_(files::temp_directory_path() / fmt::format("torsor-fmu-{}", ::getpid())) {
    std::error_code failure;
    files::remove_all(path_, failure);
    if (!files::create_directory(path_, failure)) {
      throw FileError(fmt::format("cannot make the folder '{}': {}; set TMPDIR", path_.string(), failure.message()));
    }
  }
  CompilationFolder(const CompilationFolder&) = delete;
  CompilationFolder& operator=(const CompilationFolder&) = delete;
  ~CompilationFolder() {
    std::error_code ignored;
    files::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  files::path path_;
};

std::string compiled_unit(const std::vector<SourceFile>& sources, const std::string& flags) {
  const Compiler compiler = found_compiler("CC", {"cc", "gcc", "clang"}, "C99");
  const CompilationFolder folder;
  for (const SourceFile& source : sources) write_file_if_changed(folder.file(source.path), source.text);
  const std::string made = folder.file("unit.so");
  std::vector<std::string> command = compiler.words;
  for (const char* word : {"-std=c99", "-shared", "-fPIC", "-fvisibility=hidden", "-ffp-contract=off"})
    command.push_back(word);
  for (std::string& word : separate_words(flags)) command.push_back(std::move(word));
  for (const std::string& word : {std::string("-o"), made, folder.file(sources.front().path), std::string("-lm")}) {
    command.push_back(word);
  }
  const ProcessResult said = run_process(command);
  if (said.code != 0) {
    throw FileError(
        fmt::format("the compiler '{}' fails: {}", fmt::join(compiler.words, " "), compiler_errors(said.output)));
  }
  std::ifstream file(made, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

CommandResult make_unit(const Scene& scene, const UnitRequest& request, const std::string& output) {
  if (output == "-") throw UsageError("a unit of FMI is a file: give --output x.fmu");
  refuse_contacts(scene, "a unit of FMI");
  const MechanismListing mechanism = lower_mechanism(scene, fmi_kernels(scene), request.model(scene));
  std::vector<ArchivedFile> archive = {{"modelDescription.xml", fmi_description(mechanism)}};
  const std::vector<SourceFile> sources = fmi_sources(mechanism);
  if (!request.sources_only) {
    archive.push_back({fmt::format("binaries/linux64/{}.so", scene.name()), compiled_unit(sources, request.flags)});
  }
  for (const SourceFile& source : sources) archive.push_back({"sources/" + source.path, source.text});
  return {zip_archive(archive)};
}

}  // namespace

void add_fmu_command(CommandSet& commands) {
  const auto request = std::make_shared<UnitRequest>();
  CLI::App& command =
      commands.add("fmu", "write a functional mock-up unit of FMI 2.0, for model exchange and co-simulation",
                   [request, &commands](const Scene& scene) { return make_unit(scene, *request, commands.output()); });
  command.add_option("--run-time", request->run_time, "parameters that can be tuned, comma-separated, or all");
  command.add_option("--flags", request->flags, "of the compiler $CC, separated by spaces")->capture_default_str();
  command.add_flag("--sources-only", request->sources_only, "no binary: who imports the unit compiles sources/");
  command.get_option("--output")->required()->description("unit to write, x.fmu");
}

}  // namespace torsor
