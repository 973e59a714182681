// SPDX-License-Identifier: GPL-3.0-or-later
// Manual page and completion are made of what the program declares: every command and every option of --help is in
// both.
#include "torsor/generator/cli/command_tree_text.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include <CLI/CLI.hpp>

#include "torsor/generator/mechanics/scene.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::command_tree_text_test {
namespace {

Scene pendulum() {
  Scene scene("pendulum");
  const Expression q = scene.coordinate("q", "rad");
  scene.body("bob", scene.revolute("arm", scene.ground(), axis::z, q), Inertia::point(Expression::quantity("1", "kg")));
  return scene;
}

std::string said(const std::vector<std::string>& arguments) {
  const testing_programs::Outcome outcome = testing_programs::run(pendulum, arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

std::set<std::string> found(const std::string& text, const std::regex& pattern) {
  std::set<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) all.insert((*at)[1]);
  return all;
}

TEST(CommandTree, HasEveryCommandAndOptionInManualPageAndCompletion) {
  const std::string page = said({"--man-page"}), script = said({"--bash-completion"}), help = said({"--help"});
  const std::set<std::string> commands = found(help.substr(help.find("Subcommands:")), std::regex("\n  ([a-z-]+) "));
  ASSERT_GE(commands.size(), 10U);
  for (const std::string& command : commands) {
    std::string section = std::regex_replace(command, std::regex("-"), "\\-");
    const std::size_t begin = page.find(".SS " + section + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string described = page.substr(begin, page.find("\n.S", begin + 1) - begin);
    const std::size_t line = script.find("    " + command + ") words='");
    ASSERT_NE(line, std::string::npos) << command;
    const std::string completed = script.substr(line, script.find('\n', line) - line);
    const std::set<std::string> options = found(said({command, "--help"}), std::regex("(--[a-z-]+)[ ,\n]"));
    ASSERT_GE(options.size(), 2U) << command;
    for (const std::string& option : options) {
      if (option == "--help-all") continue;
      const std::string written = std::regex_replace(option, std::regex("-"), "\\-");
      EXPECT_NE(described.find("\\fB" + written + "\\fR"), std::string::npos) << command << " " << option;
      EXPECT_TRUE(std::regex_search(completed, std::regex("[ ']" + option + "[ ']"))) << command << " " << option;
    }
  }
}

TEST(CommandTree, WritesNoLineThatRoffWouldObey) {
  const std::string page = said({"--man-page"});
  const std::set<std::string> requests = found(page, std::regex("\n([.'][^ \n]*)"));
  for (const std::string& request : requests) {
    EXPECT_TRUE(request == ".SH" || request == ".SS" || request == ".TP" || request == ".B") << request;
  }
  EXPECT_EQ(page.rfind(".TH \"SCENE\" 1", 0), 0U);
}

TEST(CommandTree, QuotesTheNameOfTheProgramForTheShell) {
  CLI::App app;
  app.add_subcommand("build", "text");
  const std::string script = bash_completion(app, "it's a $(touch x)\nscene");
  EXPECT_NE(script.find("complete -F _it_s_a___touch_x__scene -- 'it'\\''s a $(touch x)\nscene'\n"), std::string::npos) << script;
  EXPECT_EQ(script.rfind("# bash completion of it's a $(touch x)?scene, made by", 0), 0U);
}

}  // namespace
}  // namespace torsor::command_tree_text_test
