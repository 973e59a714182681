// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/cli/command_line.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor {

/// What a command leaves: its text goes where --output says, its notes to the standard error, after the text.
struct CommandResult {
  std::string text;
  bool passed = true;  ///< false: what was checked does not hold, exit code 1
  std::vector<std::string> notes = {};
  std::vector<OutputFile> files = {};  ///< further ones, written with the text or not at all
};

/// The commands of a program while they are declared, and the one that the command line chose.
class CommandSet {
 public:
  using Run = std::function<CommandResult(const Scene&)>;

  CommandSet(CLI::App& app, const SceneSource& source) : app_(app), source_(source) {}

  /// Declares a command, with --output and the options of the source; the caller adds those of the command itself.
  CLI::App& add(const std::string& name, const std::string& text, Run run);

  /// Says that a command starts from values of its own.
  void starts_from(CLI::App& command, std::function<GivenStart()> start);

  /// Those of the command that the command line chose.
  GivenStart start() const;
  const std::string& output() const { return output_; }  ///< a file's name, or - for the standard output
  /// Runs the command that the command line chose; to be called once it has been read.
  CommandResult run(const Scene& scene) const { return chosen_(scene); }

 private:
  CLI::App& app_;
  const SceneSource& source_;
  std::string output_ = "-";
  Run chosen_;
  std::vector<std::pair<const CLI::App*, std::function<GivenStart()>>> starts_;
};

// Each adds the commands of its file, with their options.
void add_equations_command(CommandSet& commands);
void add_kernel_commands(CommandSet& commands);        ///< generate, counts, passes
void add_build_command(CommandSet& commands);          ///< build
void add_fmu_command(CommandSet& commands);            ///< fmu
void add_verification_commands(CommandSet& commands);  ///< check, verify, reference
void add_statics_commands(CommandSet& commands);       ///< force-function, unknowns, theorem, screw, statics
void add_structure_commands(CommandSet& commands);     ///< structure, graph, list
void add_report_command(CommandSet& commands);
void add_simulate_command(CommandSet& commands);

/// Adds --about NAME=VALUE, e.g. theta=0; repeatable. A word without = is a UsageError while the command line is read.
using About = std::vector<std::pair<std::string, std::string>>;
void add_about(CLI::App& command, About& about, const std::string& text);
/// The same for --NAME.
void add_assignments(CLI::App& command, const std::string& name, About& assignments, const std::string& text);

struct PageRequest {
  std::string format = "text";
  bool document = false;
  std::string language = "en";
  /// Throws UsageError for words that are none, and a whole document of text.
  PageStyle style() const;
};
/// Adds --language.
void add_language(CLI::App& command, std::string& language);
/// Adds --format, --document and --language.
void add_format(CLI::App& command, PageRequest& request);

}  // namespace torsor
