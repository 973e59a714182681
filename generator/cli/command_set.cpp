// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/command_set.hpp"

#include <set>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/kernel_options.hpp"

namespace torsor {

CLI::App& CommandSet::add(const std::string& name, const std::string& text, Run run) {
  CLI::App* command = app_.add_subcommand(name, text);
  if (source_.add_options) source_.add_options(*command);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  command->add_option("-o,--output", output_, "file to write; the standard output when absent or -");
  return *command;
}

void CommandSet::starts_from(CLI::App& command, std::function<GivenStart()> start) {
  starts_.emplace_back(&command, std::move(start));
}

GivenStart CommandSet::start() const {
  for (const auto& [command, start] : starts_) {
    if (command->parsed()) return start();
  }
  return {};
}

void add_about(CLI::App& command, About& about, const std::string& text) { add_assignments(command, "--about", about, text); }

void add_assignments(CLI::App& command, const std::string& name, About& assignments, const std::string& text) {
  command.add_option_function<std::vector<std::string>>(
      name,
      [&assignments, name](const std::vector<std::string>& words) {
        std::set<std::string> given;
        for (const std::string& assignment : words) {
          const std::size_t equals = assignment.find('=');
          if (equals == std::string::npos) {
            throw UsageError(fmt::format("{} takes NAME=VALUE, e.g. theta=0, and got '{}'", name, assignment));
          }
          const std::string name_of_value = assignment.substr(0, equals);
          take_once(given, name, name_of_value);
          assignments.emplace_back(name_of_value, assignment.substr(equals + 1));
        }
      },
      text);
}

PageStyle PageRequest::style() const {
  const PageStyle style{parse_format(format), document, NaturalLanguage::named(language)};
  if (document && style.format == Format::text) {
    throw UsageError("--document is for --format latex: a page of text is whole as it is");
  }
  return style;
}

void add_language(CLI::App& command, std::string& language) {
  command.add_option("--language", language, "of the sentences: en (English) or fr (French)")->capture_default_str();
}

void add_format(CLI::App& command, PageRequest& request) {
  command.add_option("--format", request.format, "text or latex")->capture_default_str();
  command.add_flag("--document", request.document, "LaTeX: a whole document");
  add_language(command, request.language);
}

}  // namespace torsor
