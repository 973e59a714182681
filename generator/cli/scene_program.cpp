// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/scene_program.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/decimal_point.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/cli/command_line.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/command_tree_text.hpp"
#include "torsor/generator/cli/scene_file.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/dynamics/equations/singular_start.hpp"
#include "torsor/generator/dynamics/equations/start_error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"

namespace torsor {
namespace {

constexpr const char* scene_program_description = "Equations of motion and specialised kernels of one mechanism.";
constexpr int check_failed = 1;
constexpr int bad_usage = 2;
constexpr int bad_scene_or_file = 3;

void write_to_standard_output(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw FileError("cannot write to the standard output: is the disk full or the reader gone?");
  }
}

/// Before CLI11 says only that something is missing.
void check_command_name(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string likely = did_you_mean(argv[1], names);
  const std::string last = names.back();
  names.pop_back();
  throw UsageError(
      fmt::format("unknown command '{}': {}use {} or {}; see --help", argv[1], likely, fmt::join(names, ", "), last));
}

/// The first option on the command line that the chosen command does not know, and the one that may be meant.
struct UnknownOption {
  std::string word, likely{};  ///< "; did you mean '--output'?", or empty
};

std::optional<UnknownOption> unknown_option(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return std::nullopt;
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_subcommand(argv[1])->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word.rfind("--", 0) != 0 || word == "--" || std::find(known.begin(), known.end(), word) != known.end()) continue;
    const std::string likely = did_you_mean(word, known);
    return UnknownOption{word, likely.empty() ? likely : "; " + likely.substr(0, likely.size() - 1)};
  }
  return std::nullopt;
}

std::string likely_options(const CLI::App& app, int argc, const char* const* argv) {
  if (argv[1][0] == '-') return "; options of a command stand behind its name";
  const std::optional<UnknownOption> unknown = unknown_option(app, argc, argv);
  return unknown ? unknown->likely : std::string();
}

/// Reads the command line. Nothing: the chosen command is to be run; else the help that was asked for.
std::optional<std::string> read_command_line(CLI::App& app, int argc, const char* const* argv) {
  check_command_name(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    app.exit(help, text, text);
    return text.str();
  } catch (const CLI::ExtrasError& error) {
    throw UsageError(fmt::format("{}{}; see --help", error.what(), likely_options(app, argc, argv)));
  } catch (const CLI::RequiredError& error) {
    // A misspelt option may be what is missing.
    const std::optional<UnknownOption> unknown = unknown_option(app, argc, argv);
    throw UsageError(unknown ? fmt::format("unknown option '{}'{}; see --help", unknown->word, unknown->likely)
                             : fmt::format("{}; see --help", error.what()));
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}; see --help", error.what()));
  }
  return std::nullopt;
}

/// What is remarkable about the scene may be why a command fails: the error says it too.
CommandResult run_with_remarks(const CommandSet& commands, const Scene& scene, const std::vector<std::string>& remarks) {
  if (remarks.empty()) return commands.run(scene);
  try {
    return commands.run(scene);
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    throw Error(fmt::format("{}; {}", error.what(), fmt::join(remarks, "; ")));
  }
}

/// The scene, which stands where the chosen command starts: at its own start, or at values that the command was given.
Scene standing(const SceneSource& source, const GivenStart& start) {
  const Scene scene = source.make();
  const bool elsewhere = !start.values.empty();
  bool stands = true;
  try {
    validate(scene);
  } catch (const StartError& error) {
    if (!elsewhere) throw SceneError(error.what() + nearest_closed_start(scene, static_cast<bool>(source.add_options)));
    stands = false;
  }
  require_possible(scene, start.parameters);
  if (!elsewhere || (scene.content().constraints.empty() && scene.content().contacts.empty())) return scene;
  const Scene moved = with_closed_start(scene, start);
  try {
    // With other parameters the scene's own say nothing: the motion is what judges the start.
    if (start.parameters.empty()) validate(moved);
  } catch (const StartError& error) {
    throw SceneError(fmt::format("{}; the start is the one of --initial", error.what()));
  }
  return stands ? scene : moved;
}

void refuse_to_overwrite(const std::string& output, const std::vector<std::string>& read) {
  for (const std::string& input : read) {
    if (!same_file(output, input)) continue;
    throw UsageError(fmt::format("'{}' is to be written and would overwrite '{}', which the command reads: give another name",
                                 output, input));
  }
}

/// The files of the source. A program that runs in place of a scene's file has its name: that file was read too.
SourceFiles files_of(const SceneSource& source, const std::string& program) {
  SourceFiles files = source.files ? source.files() : SourceFiles();
  if (!names_scene_file(program)) return files;
  files.read.push_back(program);
  for (std::string& included : inputs_of_this_program()) files.read.push_back(std::move(included));
  return files;
}

/// What the chosen command leaves, and where its text goes; nothing when help was asked for, which is the text then.
struct Ran {
  CommandResult result;
  std::string output = "-";
  SourceFiles source = {};

  /// All files of the command, its text among them unless that goes to the standard output.
  void write_files() const {
    std::vector<OutputFile> files = result.files;
    if (output != "-") files.push_back({output, result.text});
    files.insert(files.end(), source.written.begin(), source.written.end());
    for (const OutputFile& file : files) refuse_to_overwrite(file.path, source.read);
    for (std::size_t i = 0; i < files.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!same_file(files[i].path, files[j].path)) continue;
        throw UsageError(fmt::format("'{}' and '{}' name one file, and each is to be written: give one of them another name",
                                     files[j].path, files[i].path));
      }
    }
    write_files_if_changed(files);
  }
};

Ran run(int argc, const char* const* argv, const SceneSource& source) {
  const DecimalPoint point;
  CLI::App app{source.description};
  app.require_subcommand(1);
  app.set_version_flag("--version", "torsor " TORSOR_VERSION, "print the version of torsor and exit");
  const std::string path = argc > 0 ? argv[0] : "torsor";
  add_tree_texts(app, path.substr(path.find_last_of('/') + 1), source.others);
  CommandSet commands(app, source);
  add_equations_command(commands);
  add_kernel_commands(commands);
  add_build_command(commands);
  add_fmu_command(commands);
  add_verification_commands(commands);
  add_statics_commands(commands);
  add_structure_commands(commands);
  add_report_command(commands);
  add_simulate_command(commands);
  if (const std::optional<std::string> help = read_command_line(app, argc, argv)) return {{.text = *help}};
  const GivenStart start = commands.start();
  const Scene scene = standing(source, start);
  SourceFiles files = files_of(source, path);
  if (commands.output() != "-") refuse_to_overwrite(commands.output(), files.read);
  const std::vector<std::string> remarks = singular_start(with_start(scene, start.values));
  CommandResult result = run_with_remarks(commands, scene, remarks);
  result.notes.insert(result.notes.end(), remarks.begin(), remarks.end());
  return {std::move(result), commands.output(), std::move(files)};
}

}  // namespace

int run_commands(int argc, const char* const* argv, const SceneSource& source) {
  const auto fail = [argv](const std::string& message, int code) {
    std::fprintf(stderr, "%s\n", printable(fmt::format("{}: {}", argv[0], message)).c_str());
    return code;
  };
  try {
    const Ran ran = run(argc, argv, source);
    ran.write_files();
    if (ran.output == "-") write_to_standard_output(ran.result.text);
    if (!source.quiet || !source.quiet()) {
      for (const std::string& note : ran.result.notes) std::fprintf(stderr, "note: %s\n", printable(note).c_str());
    }
    return ran.result.passed ? 0 : check_failed;
  } catch (const UsageError& error) {
    return fail(error.what(), bad_usage);
  } catch (const Error& error) {
    return fail(error.what(), bad_scene_or_file);
  } catch (const std::exception& error) {
    return fail(fmt::format("unexpected failure: {}", error.what()), bad_scene_or_file);
  }
}

CommandOutcome run_command(const std::vector<std::string>& words, const Scene& scene, const std::vector<std::string>& read) {
  std::vector<const char*> arguments{scene.name().c_str()};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  Ran ran = run(static_cast<int>(arguments.size()), arguments.data(),
                {scene_program_description, {}, [&scene] { return scene; }, {}, [&read] { return SourceFiles{read, {}}; }});
  CommandOutcome outcome{{}, ran.result.passed, std::move(ran.result.notes)};
  ran.write_files();
  if (ran.output == "-") outcome.text = std::move(ran.result.text);
  return outcome;
}

int run_scene_program(int argc, const char* const* argv, Scene (*make_scene)()) {
  return run_commands(argc, argv, {scene_program_description, {}, make_scene, {}});
}

}  // namespace torsor
