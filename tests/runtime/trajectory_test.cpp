// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/records/trajectory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace trajectory_test {
namespace {

using namespace torsor::runtime;
using Two = std::array<double, 2>;

class TrajectoryFile : public TemporaryFolder {
 protected:
  std::array<Sample<double, 2>, 4> storage{};
  Trajectory<double, 2> trajectory{storage, {"theta", "theta'"}};
};

TEST_F(TrajectoryFile, HasAHeaderAndShortestDecimals) {
  trajectory(0.0, Two{0.1, -2.0});
  trajectory(0.25, Two{1e-300, 123456789.0});
  trajectory.write_csv(folder / "run.csv");
  EXPECT_EQ(contents(folder / "run.csv"), "time,theta,theta'\n0,0.1,-2\n0.25,1e-300,123456789\n");
  EXPECT_EQ(files(), 1U) << "the temporary file is gone";
}

TEST_F(TrajectoryFile, ComesBackBitForBit) {
  const Two rows[] = {{1.0 / 3.0, -0.0},
                      {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()},
                      {std::nextafter(1.0, 2.0), -9.81}};
  for (int i = 0; i < 3; ++i) trajectory(0.1 * i, rows[i]);
  trajectory.write_csv(folder / "run.csv");
  const auto back = read_reference<double>(folder / "run.csv");
  ASSERT_EQ(back.rows(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(back.times[i], trajectory.samples()[i].time);
    EXPECT_EQ(back.state<2>(i), rows[i]);
  }
  EXPECT_TRUE(std::signbit(back.value(0, 1)));
}

TEST_F(TrajectoryFile, RecordsAsAnObserverAndSaysWhatDidNotFit) {
  const auto system = [](double, const Two& y, Two& dydt) noexcept {
    dydt = {y[1], -y[0]};
    return Evaluation::ok;
  };
  Two y{1.0, 0.0};
  ASSERT_TRUE(integrate(system, y, 0, 1, Midpoint{.step = 0.2}, trajectory));
  EXPECT_EQ(trajectory.samples().size(), 4U);
  EXPECT_EQ(trajectory.lost(), 2);
  const std::string error = error_of<FileError>([&] { trajectory.write_csv(folder / "run.csv"); });
  EXPECT_TRUE(mentions(error, {"run.csv", "2 samples", "capacity of 4", "more storage"}));
  EXPECT_EQ(files(), 0U);
  trajectory.clear();
  EXPECT_EQ(trajectory.lost(), 0);
}

TEST_F(TrajectoryFile, ReplacesAnOlderFile) {
  put("run.csv", "old and much longer than what comes now, so that a rest of it would show\n");
  trajectory.write_csv(folder / "run.csv");
  EXPECT_EQ(contents(folder / "run.csv"), "time,theta,theta'\n");
}

TEST_F(TrajectoryFile, FollowsASymbolicLink) {
  put("target.csv", "old\n");
  std::filesystem::create_symlink("target.csv", folder / "link.csv");
  trajectory.write_csv(folder / "link.csv");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_EQ(contents(folder / "target.csv"), "time,theta,theta'\n");
}

TEST_F(TrajectoryFile, NamesTheFileAndTheReasonWhenTheFolderIsMissing) {
  const std::string error = error_of<FileError>([&] { trajectory.write_csv(folder / "nowhere" / "run.csv"); });
  EXPECT_TRUE(mentions(error, {"nowhere/run.csv", "No such file or directory", "choose a folder"}));
}

TEST_F(TrajectoryFile, NamesTheFileAndTheReasonWhenTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const std::string error = error_of<FileError>([&] { trajectory.write_csv("/dev/full"); });
  EXPECT_TRUE(mentions(error, {"/dev/full", "No space left on device", "has room"}));
}

TEST_F(TrajectoryFile, NamesTheFileAndTheReasonWhenThePathIsAFolder) {
  const std::string error = error_of<FileError>([&] { trajectory.write_csv(folder); });
  EXPECT_TRUE(mentions(error, {folder.c_str(), "Is a directory"}));
}

TEST_F(TrajectoryFile, RefusesAColumnNameThatWouldBreakTheLine) {
  const Trajectory<double, 2> wrong{storage, {"theta", "a,b"}};
  const std::string error = error_of<FileError>([&] { wrong.write_csv(folder / "run.csv"); });
  EXPECT_TRUE(mentions(error, {"run.csv", "'a,b'", "rename the column"}));
}

}  // namespace
}  // namespace trajectory_test
