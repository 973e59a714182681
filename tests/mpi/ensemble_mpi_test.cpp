// SPDX-License-Identifier: GPL-3.0-or-later
// Run by mpirun with one and more processes, which all go through every test.
#include "torsor/runtime/mpi/ensemble_mpi.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include "tests/mpi/processes.hpp"

namespace {

using namespace torsor::runtime;
using namespace torsor::mpi_test;

constexpr RecordHead many{17, 200, 3};

void squares(std::uint64_t index, std::span<double> record) {
  // Members that take longer or shorter arrive in another order.
  if (index % 13 == 0) std::this_thread::sleep_for(std::chrono::microseconds(20 * index));
  const auto i = static_cast<double>(index);
  record[0] = i;
  record[1] = i * i;
  record[2] = 1.0 / i;
}

/// A folder that all processes know, and in it the file that one process alone writes.
class EnsembleOverMpi : public testing::Test {
 protected:
  EnsembleOverMpi() {
    if (rank() == 0) {
      run_ensemble(folder / "alone", many, squares);
      expected = contents(folder / "alone");
    }
  }
  /// Only the first process, which will open the file.
  void put(const std::string& text) const {
    if (rank() == 0) std::ofstream(folder / "results", std::ios::binary) << text;
  }
  EnsembleProgress run(const MpiEnsembleOptions& options = {}) const {
    return run_ensemble_over_mpi(folder / "results", many, squares, options);
  }
  void expect_whole() const { EXPECT_TRUE(rank() != 0 || contents(folder / "results") == expected); }
  template <class Action>
  static std::string error_of(const Action& action) {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }

  const SharedFolder shared;
  const std::filesystem::path& folder = shared.path;
  std::string expected;
};

TEST_F(EnsembleOverMpi, WritesTheBytesOfOneProcess) {
  int file = 0;
  for (const unsigned threads : {1U, 2U}) {
    for (const std::uint64_t at_once : {0U, 1U, 7U, 1000U}) {
      const auto path = folder / std::to_string(file++);
      const auto progress = run_ensemble_over_mpi(path, many, squares, {.threads = threads, .at_once = at_once});
      EXPECT_EQ(progress.done, 200U);
      EXPECT_EQ(progress.found, 0U);
      EXPECT_TRUE(rank() != 0 || contents(path) == expected) << threads << " threads, " << at_once << " at once";
    }
  }
}

// Members that are computed for what they do beside it: more of them than may be under way at once.
TEST_F(EnsembleOverMpi, EndsWhereRecordsHaveNoNumbers) {
  const RecordHead idle{17, 500, 0};
  const auto progress = run_ensemble_over_mpi(
      folder / "idle", idle, [](std::uint64_t, std::span<double>) {}, {.at_once = 2});
  EXPECT_EQ(progress.done, 500U);
}

TEST_F(EnsembleOverMpi, GoesOnWithAFileThatEndsAnywhere) {
  for (const std::size_t bytes : {0U, 5U, 56U, 57U, 56U + 40U * 13U, 56U + 40U * 77U + 39U, 56U + 40U * 200U}) {
    put(rank() == 0 ? expected.substr(0, bytes) : "");
    EXPECT_EQ(run({.at_once = 3}).found, bytes < 56 ? 0 : (bytes - 56) / 40) << bytes;
    expect_whole();
  }
}

TEST_F(EnsembleOverMpi, StopsWhenTheProgressCallbackSaysSo) {
  EnsembleProgress progress;
  int runs = 0;
  for (; progress.done < 200 && runs < 300; ++runs) {
    const auto until = [](const EnsembleProgress& p) { return p.done < p.found + 60; };
    progress = run({.at_once = 2, .progress = until});
  }
  EXPECT_GT(runs, 1);
  EXPECT_EQ(progress.done, 200U);
  expect_whole();
}

TEST_F(EnsembleOverMpi, ThrowsInAllProcessesWhatAMemberThrowsInOne) {
  const auto fails = [](std::uint64_t index, std::span<double> record) {
    if (index == 33) throw std::runtime_error("member 33 has no start");
    squares(index, record);
  };
  EXPECT_EQ(error_of([&] { run_ensemble_over_mpi(folder / "results", many, fails); }), "member 33 has no start");
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(rank() != 0 || read_records(folder / "results").size() <= 33U);
  run();
  expect_whole();
}

TEST_F(EnsembleOverMpi, ThrowsInAllProcessesWhatHasNoWords) {
  const auto fails = [](std::uint64_t, std::span<double>) { throw std::runtime_error(""); };
  EXPECT_THROW(run_ensemble_over_mpi(folder / "results", many, fails), std::runtime_error);
  // In the process that writes
  const auto progress = [](const EnsembleProgress&) -> bool { throw std::runtime_error(""); };
  EXPECT_THROW(run({.progress = progress}), std::runtime_error);
  run();
  expect_whole();
}

TEST_F(EnsembleOverMpi, RefusesAFileInAllProcesses) {
  put("something else");
  EXPECT_NE(error_of([&] { run(); }).find("is no file of records"), std::string::npos);
  EXPECT_TRUE(rank() != 0 || contents(folder / "results") == "something else");
}

TEST_F(EnsembleOverMpi, RefusesDifferentQuestions) {
  if (processes() == 1) GTEST_SKIP() << "one process asks one question";
  const RecordHead own{many.question + static_cast<std::uint64_t>(rank()), many.count, many.numbers};
  EXPECT_NE(error_of([&] { run_ensemble_over_mpi(folder / "results", own, squares); }).find("different questions"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "results"));
}

}  // namespace

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
