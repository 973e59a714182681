// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace torsor {

/// Commands that a program looks for before it reads a command line: their words, and what they do.
using OtherCommands = std::vector<std::pair<std::string, std::string>>;

/// The manual page (section 1) of a program, from the commands and options that it declares.
std::string man_page(const CLI::App& app, const std::string& program, const OtherCommands& others = {});

/// A script for bash that completes commands, options and names of files. Files may stand before the command.
std::string bash_completion(const CLI::App& app, const std::string& program, const OtherCommands& others = {});

/// Adds --man-page and --bash-completion, which print one of these and end the program, as --version does.
void add_tree_texts(CLI::App& app, const std::string& program, const OtherCommands& others);

}  // namespace torsor
