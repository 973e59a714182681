// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/command_tree_text.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace torsor {
namespace {

/// As roff prints it: no escape, no request at the beginning of a line, hyphens that can be searched for.
std::string roff(const std::string& text) {
  std::string safe;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
    begins = c == '\n';
  }
  return safe;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Of an option "-o,--output": these two. Empty for an argument without a name.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string described(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    std::vector<std::string> names = names_of(*option);
    const bool positional = names.empty();
    if (positional) names.push_back(option->get_name(true));
    for (std::string& name : names) name = "\\fB" + roff(name) + "\\fR";
    text += fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (!positional && option->get_items_expected_max() > 0) text += " \\fI" + roff(option->get_type_name()) + "\\fR";
    text += "\n" + roff(option->get_description()) + "\n";
  }
  return text;
}

std::string words(const std::vector<std::string>& all) { return fmt::format("{}", fmt::join(all, " ")); }

/// One word of a shell, whatever it holds.
std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  }
  return quoted + "'";
}

/// Of one line, so that it can stand in a comment.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, '?');
  return text;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : names_of(*option)) all.push_back(name);
  }
  return all;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& program, const OtherCommands& others) {
  std::string title = program;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c); });
  std::string text = fmt::format(".TH \"{}\" 1 \"\" \"torsor {}\" \"User Commands\"\n", roff(title), TORSOR_VERSION);
  text += fmt::format(".SH NAME\n{} \\- equations of motion of mechanisms, as text and as code\n", roff(program));
  text += fmt::format(".SH SYNOPSIS\n.B {}\n\\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n", roff(program));
  text += ".SH DESCRIPTION\n" + roff(app.get_description()) + "\n";
  text += ".SH OPTIONS\n" + described(app);
  text += ".SH COMMANDS\n";
  for (const auto& [usage, does] : others) text += fmt::format(".SS {}\n{}\n", roff(usage), roff(does));
  for (const CLI::App* command : commands_of(app)) {
    text +=
        fmt::format(".SS {}\n{}\n", roff(command->get_name()), roff(command->get_description())) + described(*command);
  }
  text +=
      ".SH EXIT STATUS\n.TP\n0\nsuccess\n.TP\n1\na check failed\n.TP\n2\nbad usage, an unknown kernel "
      "included\n.TP\n3\n"
      "an error in a scene or a file\n";
  return text;
}

std::string bash_completion(const CLI::App& app, const std::string& program, const OtherCommands& others) {
  std::string function = "_" + program;
  std::replace_if(
      function.begin(), function.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  std::vector<std::string> first = option_names(app), commands;
  std::string cases;
  for (const auto& [usage, does] : others) first.push_back(usage.substr(0, usage.find(' ')));
  for (const CLI::App* command : commands_of(app)) {
    first.push_back(command->get_name());
    commands.push_back(command->get_name());
    cases += fmt::format("    {}) words='{}' ;;\n", command->get_name(), words(option_names(*command)));
  }
  return fmt::format(
      R"(# bash completion of {4}, made by {4} --bash-completion
{1}() {{
  local words='' command='' word current="${{COMP_WORDS[COMP_CWORD]}}"
  COMPREPLY=()
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$word" in {5}) command="$word"; break ;; esac
  done
  case "$command" in
{3}    '') if [ "$COMP_CWORD" -eq 1 ]; then words='{2}'; else words='{6}'; fi ;;
  esac
  case "$current" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
    *) compopt -o filenames 2> /dev/null
       [ -z "$command" ] || words=''
       mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; compgen -f -- "$current") ;;
  esac
}}
complete -F {1} -- {0}
)",
      shell_quoted(program), function, words(first), cases, on_one_line(program), fmt::join(commands, "|"), words(commands));
}

void add_tree_texts(CLI::App& app, const std::string& program, const OtherCommands& others) {
  const auto print = [&app, program, others](std::string (*make)(const CLI::App&, const std::string&, const OtherCommands&)) {
    return [&app, program, others, make]() {
      std::string text = make(app, program, others);
      text.pop_back();  // CLI11 ends it with a line
      throw CLI::CallForVersion(text, 0);
    };
  };
  app.add_flag_callback("--man-page", print(man_page), "print the manual page of all commands and exit");
  app.add_flag_callback("--bash-completion", print(bash_completion),
                        "print a script that completes commands in bash and exit");
}

}  // namespace torsor
