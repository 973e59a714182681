// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/integration/work_precision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace torsor::work_precision_test {
namespace {

using namespace torsor::runtime;
using Pendulum = double_pendulum::Mechanism<double>;

/// The largest errors in a printed table, top to bottom: the fifth cell from the right, times having two words.
std::vector<double> errors_in(const Table& table) {
  std::stringstream text;
  text << table;
  std::string line;
  std::vector<double> errors;
  for (int row = 0; std::getline(text, line); ++row) {
    if (row < 2) continue;
    std::stringstream words(line);
    std::vector<std::string> cells;
    for (std::string word; words >> word;) cells.push_back(word);
    errors.push_back(std::stod(cells.at(cells.size() - 5)));
  }
  return errors;
}

// Halving the step divides the error of the midpoint method by 2^2 and that of Runge-Kutta by 2^4, in the limit of
// short steps; here within a fifth.
TEST(WorkPrecision, ShowsTheOrdersOfTheMethods) {
  Reference<double> reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/double_pendulum.reference.csv");
  reference.times.resize(1);  // 1 s: the motion is regular
  const auto motion = equations_of_motion<Pendulum>();
  const auto errors = errors_in(work_precision(
      motion, reference, Midpoint{.step = 4e-4}, Midpoint{.step = 2e-4}, RungeKutta4{.step = 4e-3},
      RungeKutta4{.step = 2e-3}, DormandPrince54{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10}));
  ASSERT_EQ(errors.size(), 5U);
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.8);
  EXPECT_NEAR(errors[2] / errors[3], 16.0, 3.2);
  EXPECT_LT(errors[4], 1e-8);
}

TEST(WorkPrecision, SaysWhyAMethodDidNotReachTheEnd) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/double_pendulum.reference.csv");
  std::stringstream text;
  text << work_precision(equations_of_motion<Pendulum>(), reference, Midpoint{.step = -1.0});
  EXPECT_NE(text.str().find("unusable options"), std::string::npos) << text.str();
}

class Demonstration : public testing::Test {
 protected:
  /// Runs a demonstration with a command line; what it says goes to `out` and `err`.
  int run(std::vector<std::string> words, const std::function<void(const Reference<double>&)>& show) {
    words.insert(words.begin(), "some/where/double_pendulum");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code =
        demonstrate(static_cast<int>(argv.size()), argv.data(), {.name = "double_pendulum", .about = "a test"}, show);
    out = testing::internal::GetCapturedStdout();
    err = testing::internal::GetCapturedStderr();
    return code;
  }
  const std::string file = TORSOR_SOURCE_DIR "/generated/double_pendulum.reference.csv";
  std::string out, err;
};

TEST_F(Demonstration, WritesPlotsOnlyWhereItIsAskedForThem) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "torsor_plots" / "of_a_test";
  std::filesystem::remove_all(folder.parent_path());
  const auto with_plots = [&](std::vector<std::string> words, const auto& show) {
    words.insert(words.begin(), {"some/where/double_pendulum", "--reference", file});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    return demonstrate_with_plots(static_cast<int>(argv.size()), argv.data(),
                                  {.name = "double_pendulum", .about = "a test"}, show);
  };
  bool wanted = true;
  EXPECT_EQ(with_plots({}, [&](const Reference<double>&, const PlotFolder& plots) { wanted = bool(plots); }), 0);
  EXPECT_FALSE(wanted);
  std::filesystem::path file_name;
  const auto ask = [&](const Reference<double>&, const PlotFolder& plots) { file_name = plots.file("a.svg"); };
  EXPECT_EQ(with_plots({"--plots", folder.string()}, ask), 0);
  EXPECT_EQ(file_name, folder / "a.svg");
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  std::filesystem::remove_all(folder.parent_path());
  // A program without plots knows no such option.
  EXPECT_EQ(run({"--plots", folder.string()}, [](const Reference<double>&) {}), 2);
}

TEST_F(Demonstration, ReadsTheReferenceItIsGiven) {
  std::size_t rows = 0;
  EXPECT_EQ(run({"--reference", file}, [&](const Reference<double>& reference) { rows = reference.rows(); }), 0);
  EXPECT_EQ(rows, 3U);
  EXPECT_EQ(err, "");
}

TEST_F(Demonstration, FindsTheReferenceInTheNearestFolderAboveTheProgram) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / "torsor_demonstration_test";
  fs::create_directories(root / "generated");
  fs::create_directories(root / "build" / "bin");
  const fs::path expected = root / "generated" / "known_here_only.reference.csv";
  std::ofstream(expected) << "time,x\n1,2\n";
  EXPECT_EQ(find_reference(root / "build" / "bin" / "program", "known_here_only"), fs::canonical(expected));
  EXPECT_THROW((void)find_reference(root / "build" / "bin" / "program", "known_nowhere"), torsor::runtime::FileError);
  fs::remove_all(root);
}

TEST_F(Demonstration, ExplainsItself) {
  EXPECT_EQ(run({"--help"}, [](const Reference<double>&) { FAIL(); }), 0);
  EXPECT_NE(out.find("usage: double_pendulum [--reference FILE] [--help]"), std::string::npos) << out;
}

TEST_F(Demonstration, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(run({"--speed"}, [](const Reference<double>&) { FAIL(); }), 2);
  EXPECT_EQ(err, "double_pendulum: cannot understand '--speed'; usage: double_pendulum [--reference FILE] [--help]\n");
  EXPECT_EQ(run({"--reference"}, [](const Reference<double>&) { FAIL(); }), 2);
}

TEST_F(Demonstration, ReportsAFileItCannotRead) {
  EXPECT_EQ(run({"--reference", "/no/such/file.csv"}, [](const Reference<double>&) { FAIL(); }), 3);
  EXPECT_EQ(err, "double_pendulum: cannot read '/no/such/file.csv': No such file or directory; check the path\n");
}

}  // namespace
}  // namespace torsor::work_precision_test
