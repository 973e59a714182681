// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/cli/command_tree_text.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace CLI {
class App;
}

namespace torsor {

/// The files of a source, once the scene has been made.
struct SourceFiles {
  std::vector<std::string> read;    ///< what the scene was made of: no command may overwrite it
  std::vector<OutputFile> written;  ///< with those of the command, or not at all
};

/// What a program's commands work on: a scene written in C++, or one read from a file that the command line names.
struct SceneSource {
  std::string description;                     ///< the first line of --help
  std::function<void(CLI::App&)> add_options;  ///< adds what the source needs to one command; may be empty
  std::function<Scene()> make;                 ///< called when the command line has been read
  std::function<bool()> quiet = {};            ///< whether notes are left out; may be empty
  std::function<SourceFiles()> files = {};     ///< called after `make`; may be empty
  OtherCommands others = {};                   ///< of the program, for its manual page and its completion
};

/// The command line of every program (scene_program.hpp) on that source.
int run_commands(int argc, const char* const* argv, const SceneSource& source);

/// What one command leaves where no program prints it.
struct CommandOutcome {
  std::string text;  ///< empty when it was written to the file of --output
  bool passed = true;  ///< false: what was checked does not hold
  std::vector<std::string> notes;
};

/// One command of a scene program, its words without the program's name: {"equations", "--format", "latex"}. Files are
/// written as programs do, none of those that were read. Throws what programs print: UsageError for words that are not understood,
/// any other Error.
CommandOutcome run_command(const std::vector<std::string>& words, const Scene& scene, const std::vector<std::string>& read = {});

}  // namespace torsor
