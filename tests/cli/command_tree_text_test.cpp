// SPDX-License-Identifier: GPL-3.0-or-later
// Manual page and completion are made of what the program declares: every command and every option of --help is in
// both.
#include "torsor/generator/cli/command_tree_text.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
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

/// What bash offers for the last of these words.
std::set<std::string> offered(const std::string& words) {
  CLI::App app;
  app.add_subcommand("simulate", "")->add_option("--initial");
  app.add_subcommand("structure", "");
  const std::string folder = testing::TempDir() + "completed";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/simple.urdf") << "";
  std::ofstream(folder + "/script") << bash_completion(app, "torsor", {{"new NAME", ""}}) << "COMP_WORDS=(torsor " << words
                                    << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_torsor\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  std::FILE* const bash = popen(("cd '" + folder + "' && bash ./script").c_str(), "r");
  std::string text;
  for (int c = std::fgetc(bash); c != EOF; c = std::fgetc(bash)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(bash), 0);
  return found(text, std::regex("([^\n]+)\n"));
}

TEST(CommandTree, CompletesWhateverOrderFileAndCommandStandIn) {
  using Words = std::set<std::string>;
  EXPECT_EQ(offered("si"), (Words{"simulate", "simple.urdf"}));
  EXPECT_EQ(offered("ne"), Words{"new"});
  EXPECT_EQ(offered("simple.urdf si"), (Words{"simulate", "simple.urdf"}));
  EXPECT_EQ(offered("simple.urdf simulate --in"), Words{"--initial"});
  EXPECT_EQ(offered("simulate simple.urdf --in"), Words{"--initial"});
  EXPECT_EQ(offered("simulate si"), Words{"simple.urdf"});
  EXPECT_EQ(offered("structure --in"), Words{});
  CLI::App app;
  EXPECT_NE(man_page(app, "torsor", {{"new NAME", "Begins it."}}).find(".SS new NAME\nBegins it.\n"), std::string::npos);
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
