// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace torsor {

/// The manual page (section 1) of a program, from the commands and options that it declares.
std::string man_page(const CLI::App& app, const std::string& program);

/// A script for bash that completes commands, options and names of files.
std::string bash_completion(const CLI::App& app, const std::string& program);

/// Adds --man-page and --bash-completion, which print one of these and end the program, as --version does.
void add_tree_texts(CLI::App& app, const std::string& program);

}  // namespace torsor
