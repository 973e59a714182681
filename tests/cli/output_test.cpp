// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "torsor/generator/cli/command_line.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace torsor::output_test {
namespace {

using namespace testing_programs;
namespace fs = std::filesystem;

class SceneProgramOutput : public ::TemporaryFolder {
 protected:
  std::string text(const std::string& name) const { return contents(path(name)); }
};

TEST_F(SceneProgramOutput, IsTheSameInAFileAndOnTheStandardOutput) {
  const std::vector<std::vector<std::string>> commands{
      {"list"}, {"counts"}, {"counts", "--json"}, {"equations"}, {"generate", "--kernels", "energy"}};
  for (std::vector<std::string> command : commands) {
    command.push_back("--output");
    command.push_back("-");
    const Outcome shown = run(pendulum, command);
    EXPECT_EQ(shown.code, 0);
    EXPECT_GT(shown.out.size(), 100U);
    command.back() = path("file");
    const Outcome written = run(pendulum, command);
    EXPECT_EQ(written.code, 0);
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(text("file"), shown.out);
    EXPECT_EQ(files(), 1U);
  }
}

TEST_F(SceneProgramOutput, OfGenerateIsAHeaderThatIsNotTouchedWhenNothingChanges) {
  const std::vector<std::string> command{"generate", "--kernels", "mass_matrix,bias", "-o", path("pendulum.hpp")};
  EXPECT_EQ(run(pendulum, command).code, 0);
  EXPECT_NE(text("pendulum.hpp").find("struct Mechanism"), std::string::npos);
  const auto long_ago = fs::last_write_time(path("pendulum.hpp")) - std::chrono::hours(1);
  fs::last_write_time(path("pendulum.hpp"), long_ago);
  EXPECT_EQ(run(pendulum, command).code, 0);
  EXPECT_EQ(fs::last_write_time(path("pendulum.hpp")), long_ago);
}

TEST_F(SceneProgramOutput, IntoAMissingFolderFails) {
  const std::string file = path("missing/pendulum.hpp");
  expect_failure(
      run(pendulum, {"generate", "--output", file}), 3,
      "cannot write '" + file + "': No such file or directory; create the folder first, or choose another one");
  EXPECT_EQ(files(), 0U);
}

// Sources of a library, too, spare what the scene was made of.
TEST_F(SceneProgramOutput, OverwritesNothingThatTheSceneWasMadeOf) {
  std::ofstream(path("library.cpp")) << "the scene";
  for (const std::vector<std::string>& words : {std::vector<std::string>{"build", "--kernels", "energy", "--sources", folder.string()},
                                                {"generate", "--output", path("library.cpp")}}) {
    const std::string message = testing_symbols::error_of<UsageError>([&] { run_command(words, pendulum(), {path("library.cpp")}); });
    EXPECT_EQ(message, "'" + path("library.cpp") + "' is to be written and would overwrite '" + path("library.cpp") +
                           "', which the command reads: give another name");
    EXPECT_EQ(text("library.cpp"), "the scene");
  }
}

TEST_F(SceneProgramOutput, OntoAFolderFails) {
  expect_failure(run(pendulum, {"generate", "--output", folder.string()}), 3,
                 "cannot write '" + folder.string() + "': Is a directory; name a file in it");
}

TEST_F(SceneProgramOutput, OntoAFullDeviceFails) {
  expect_failure(run(pendulum, {"generate", "--output", "/dev/full"}), 3,
                 "cannot write '/dev/full': No space left on device; make room, or choose another disk");
}

TEST_F(SceneProgramOutput, OntoAFullStandardOutputFails) {
  const int full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  std::fflush(stdout);
  const int saved = ::dup(STDOUT_FILENO);
  ::dup2(full, STDOUT_FILENO);
  testing::internal::CaptureStderr();
  const char* list[] = {"scene", "list"};
  const int code_of_list = run_scene_program(2, list, pendulum);
  std::clearerr(stdout);
  const char* help[] = {"scene", "--help"};
  const int code_of_help = run_scene_program(2, help, pendulum);
  const std::string err = testing::internal::GetCapturedStderr();
  std::clearerr(stdout);
  ::dup2(saved, STDOUT_FILENO);
  ::close(saved);
  ::close(full);
  EXPECT_EQ(code_of_list, 3);
  EXPECT_EQ(code_of_help, 3);
  const std::string message = "scene: cannot write to the standard output: is the disk full or the reader gone?\n";
  EXPECT_EQ(err, message + message);
}

/// A limit on the size of files stands for a disk that fills up half-way.
TEST_F(SceneProgramOutput, OnADiskThatFillsUpLeavesWhatWasThereAndNothingElse) {
  std::ofstream(path("pendulum.hpp")) << "old";
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit small = before;
  small.rlim_cur = 2048;  // less than a header, more than a message
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const Outcome outcome = run(pendulum, {"generate", "--output", path("pendulum.hpp")});
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  expect_failure(outcome, 3,
                 "cannot write '" + path("pendulum.hpp") + "': File too large; make room, or choose another disk");
  EXPECT_EQ(text("pendulum.hpp"), "old");
  EXPECT_EQ(files(), 1U);
}

/// Another user than root for as long as this lives: permissions mean nothing to root.
class Unprivileged {
 public:
  Unprivileged() {
    if (::geteuid() == 0) switched_ = ::seteuid(65534) == 0;
  }
  ~Unprivileged() {
    if (switched_ && ::seteuid(0) != 0) std::abort();
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  bool switched_ = false;
};

TEST_F(SceneProgramOutput, IntoAFolderThatMayNotBeWrittenFails) {
  fs::permissions(folder.string(),
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  Outcome outcome;
  {
    const Unprivileged user;
    if (::access(folder.string().c_str(), W_OK) == 0 && ::geteuid() == 0) GTEST_SKIP() << "cannot give up being root here";
    outcome = run(pendulum, {"generate", "--output", path("pendulum.hpp")});
  }
  expect_failure(outcome, 3,
                 "cannot write '" + path("pendulum.hpp") +
                     "': Permission denied; ask for the right to write there, or choose another place");
  EXPECT_EQ(files(), 0U);
  fs::permissions(folder.string(), fs::perms::owner_all);
}

// An option that a command would not look at is refused.
TEST(Options, WithoutEffectAreRefused) {
  const auto refused = [](const std::vector<std::string>& words, const std::string& message) {
    expect_failure(run(pendulum, words), 2, message);
  };
  refused({"theorem", "--at", "arm"}, "the theorem of the resultant has no point: leave --at out, or ask for --kind moment");
  refused({"structure", "--json", "--language", "fr"},
          "--language is for text, and --json prints names that programs read: leave one of them out");
  refused({"graph", "--inputs-outputs", "arm"},
          "--inputs-outputs is for --of reduced: the other graphs show all joints alike");
  refused({"list", "--kernels", "energy"},
          "--kernels is for --json, which prints their shapes: the text names all kernels of the scene");
  const std::string folder = testing::TempDir() + "sources_of_nothing";
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--fused"}, {"--flags", "-O1"}}) {
    std::vector<std::string> all{"build", "--sources", folder};
    all.insert(all.end(), words.begin(), words.end());
    refused(all, "--sources compiles nothing: give what --flags and --fused say to your own compiler");
  }
  refused({"fmu", "--sources-only", "--flags", "-O1", "-o", testing::TempDir() + "of_sources.fmu"},
          "--sources-only compiles nothing: give what --flags says to the compiler of who imports the unit");
  refused({"verify", "--markdown", "--all"}, "--all excludes --markdown; see --help");
}

}  // namespace
}  // namespace torsor::output_test
