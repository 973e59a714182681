// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/base/process.hpp"
#include "torsor/generator/base/temporary_folder.hpp"
#include "torsor/generator/base/zip_archive.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/compiled_library.hpp"
#include "torsor/generator/cli/compiler.hpp"
#include "torsor/generator/cli/fmi_platform.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/emission/fmi_description.hpp"
#include "torsor/generator/emission/fmi_sources.hpp"

namespace torsor {
namespace {

struct UnitRequest : KernelOptions {
  std::string flags = "-O2";
  int fmi = 2;
  bool sources_only = false;
  OutputNames outputs;

  FmiVersion version() const { return fmi == 2 ? FmiVersion::two : FmiVersion::three; }
};

/// An option that takes names of things of a scene.
struct NamesOption {
  std::string option;
  std::string what;                ///< a name of it stands for
  std::vector<std::string> known;  ///< which of them the scene has
};

/// Names given to an option, each once; `all` stands for the known ones.
std::vector<std::string> chosen(const Scene& scene, const std::vector<std::string>& names, const NamesOption& of) {
  const auto& [option, what, known] = of;
  std::vector<std::string> all;
  for (const std::string& name : names) {
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    if (!is_known && name != "all") {
      throw UsageError(fmt::format("unknown {} '{}' in {}: {}the scene '{}' has {}", what, name, option,
                                   did_you_mean(name, known), scene.name(),
                                   known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
    for (const std::string& each : is_known ? std::vector<std::string>{name} : known) {
      if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
    }
  }
  return all;
}

OutputNames chosen_outputs(const Scene& scene, const OutputNames& asked) {
  const SceneContent& content = scene.content();
  std::vector<std::string> points, frames, released;
  for (const PointContent& point : content.points) points.push_back(point.name);
  for (const FrameContent& frame : content.frames) {
    if (!content.is_rotor(frame)) frames.push_back(frame.name);
  }
  for (const CoordinateContent& coordinate : content.coordinates) {
    if (coordinate.released) released.push_back(coordinate.q->name);
  }
  return {chosen(scene, asked.points, {"--points", "point", points}),
          chosen(scene, asked.frames, {"--frames", "frame", frames}),
          chosen(scene, asked.reactions, {"--reactions", "released coordinate", released})};
}

void write_sources(const std::filesystem::path& folder, const std::vector<SourceFile>& sources) {
  for (const SourceFile& source : sources) {
    const std::filesystem::path path = folder / source.path;
    std::filesystem::create_directories(path.parent_path());
    write_file_if_changed(path.string(), source.text);
  }
}

void compile(const Compiler& compiler, const std::vector<std::string>& flags, const std::vector<std::string>& words) {
  std::vector<std::string> command = compiler.words;
  command.insert(command.end(), {"-fPIC", "-fvisibility=hidden"});
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), words.begin(), words.end());
  const ProcessResult said = run_process(command);
  if (said.code == 0) return;
  throw FileError(fmt::format("the compiler '{}' fails: {}{}", fmt::join(compiler.words, " "),
                              compiler_errors(said.output), eigen_remedy(said.output)));
}

/// First the file of each language that a compiler is given.
struct UnitSources {
  std::vector<SourceFile> c, cpp;
};

/// A binary, and where in a unit it belongs.
ArchivedFile compiled_unit(const FmiUnit& unit, const UnitSources& sources, const UnitRequest& request) {
  const Compiler compiler = found_compiler("CC", {"cc", "gcc", "clang"}, "C99");
  const std::vector<std::string> flags = compiler_flags({.flags = request.flags}, unit.scene());
  const FmiPlatform platform = fmi_platform(predefined_macros(compiler, flags), unit.version);
  const TemporaryFolder folder(folder_of_temporary_files(), "torsor-fmu-");
  const auto file = [&folder](const std::string& of) { return (folder.path() / of).string(); };
  write_sources(folder.path(), sources.c);
  write_sources(folder.path(), sources.cpp);
  const std::string made = file("unit" + platform.suffix);
  if (!unit.has_contacts()) {
    compile(compiler, flags, {"-std=c99", "-shared", "-o", made, file(sources.c.front().path), "-lm"});
  } else {
    compile(compiler, flags, {"-std=c99", "-c", "-o", file("unit.o"), file(sources.c.front().path)});
    const Compiler other = found_compiler("CXX", {"c++", "g++", "clang++"}, "C++20");
    compile(other, flags,
            {"-std=c++20", "-shared", "-isystem", eigen_folder(), "-I", folder.path().string(), "-o", made,
             file(sources.cpp.front().path), file("unit.o"), compiled_contact_layer(other, flags), "-lm"});
  }
  return {fmt::format("binaries/{}/{}{}", platform.folder, unit.name(), platform.suffix), compiled_bytes(made)};
}

/// Of a robot's file --points says which links get points, their origins. Contacts have points of their own.
std::vector<std::string> origins_of_links(const Scene& scene) {
  std::vector<std::string> names;
  for (const PointContent& point : scene.content().points) {
    if (point.name.ends_with("_origin")) names.push_back(point.name);
  }
  return names;
}

CommandResult make_unit(const Scene& scene, const UnitRequest& request, const std::string& output) {
  if (output == "-") throw UsageError("a unit of FMI is a file: give --output x.fmu");
  if (request.sources_only && request.flags != UnitRequest().flags) {
    throw UsageError("--sources-only compiles nothing: give what --flags says to the compiler of who imports the unit");
  }
  const FmiUnit unit =
      lower_unit(scene, request.version(), chosen_outputs(scene, request.outputs), request.model(scene));
  std::vector<ArchivedFile> archive = {{"modelDescription.xml", fmi_description(unit)}};
  archive.push_back({"documentation/index.html", fmi_documentation(unit)});
  for (const SourceFile& text : fmi_licence_files(unit))
    archive.push_back({"documentation/licenses/" + text.path, text.text});
  UnitSources sources{fmi_sources(unit), {}};
  if (unit.has_contacts()) sources.cpp = fmi_contact_sources(unit);
  if (!request.sources_only) archive.push_back(compiled_unit(unit, sources, request));
  for (const std::vector<SourceFile>* files : {&sources.c, &sources.cpp}) {
    for (const SourceFile& source : *files) archive.push_back({"sources/" + source.path, source.text});
  }
  if (unit.version == FmiVersion::three)
    archive.push_back({"sources/buildDescription.xml", fmi_build_description(unit)});
  return {zip_archive(archive)};
}

}  // namespace

void add_fmu_command(CommandSet& commands) {
  const auto request = std::make_shared<UnitRequest>();
  const auto of_robot = std::make_shared<CLI::Option*>(nullptr);
  CLI::App& command =
      commands.add("fmu", "write a functional mock-up unit of FMI 2.0 or 3.0, for model exchange and co-simulation",
                   [request, of_robot, &commands](const Scene& scene) {
                     if (*of_robot != nullptr && !(*of_robot)->empty())
                       request->outputs.points = origins_of_links(scene);
                     return make_unit(scene, *request, commands.output());
                   });
  command.add_option("--fmi", request->fmi, "version of the interface, 2 or 3")
      ->capture_default_str()
      ->check(CLI::IsMember({2, 3}));
  command.add_option("--run-time", request->run_time, "parameters that can be tuned, comma-separated, or all");
  const auto add_outputs = [&command](const char* name, std::vector<std::string>& names, const char* text) {
    command.add_option(name, names, text)->delimiter(',')->allow_extra_args(false);
  };
  *of_robot = command.get_option_no_throw("--points");
  if (*of_robot == nullptr) {
    add_outputs("--points", request->outputs.points, "points whose positions are outputs, comma-separated, or all");
  }
  add_outputs("--frames", request->outputs.frames, "frames whose poses are outputs, comma-separated, or all");
  add_outputs("--reactions", request->outputs.reactions,
              "released coordinates whose reactions are outputs, comma-separated, or all");
  command.add_option("--flags", request->flags, "of the compiler $CC, separated by spaces")->capture_default_str();
  command.add_flag("--sources-only", request->sources_only, "no binary: who imports the unit compiles sources/");
  command.get_option("--output")->required()->description("unit to write, x.fmu");
}

}  // namespace torsor
