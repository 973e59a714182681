// SPDX-License-Identifier: GPL-3.0-or-later
// An ensemble of piles of grains, on as many processes as mpirun starts.
#include <gtest/gtest.h>

#include <array>

#include "examples/grains/piles.hpp"
#include "tests/mpi/processes.hpp"
#include "torsor/runtime/mpi/ensemble_mpi.hpp"

namespace torsor::mpi_test {
namespace {

using namespace torsor::runtime;
constexpr std::uint64_t piles = 12;

// Each number of processes gives the bytes of one process without MPI, on two threads, so that all give the same.
TEST(GrainPilesOverMpi, AreThoseOfOneProcess) {
  const SharedFolder folder;
  const RecordHead head = grains_example::pile_head(piles);
  const auto progress =
      run_ensemble_over_mpi(folder.path / "piles", head, grains_example::compute_pile, {.at_once = 3});
  EXPECT_EQ(progress.done, piles);
  if (rank() != 0) return;
  run_ensemble(folder.path / "alone", head, grains_example::compute_pile, {.threads = 2});
  EXPECT_EQ(contents(folder.path / "piles"), contents(folder.path / "alone"));

  // And they are piles: all lie still, no two alike, and rough discs lie less close than smooth ones.
  const auto records = read_records(folder.path / "piles");
  std::array<double, grains_example::pile_frictions.size()> centres{};
  for (std::uint64_t i = 0; i < piles; ++i) {
    const auto record = records[i];
    centres[i % centres.size()] += record[1];
    EXPECT_LT(record[1], record[0]);
    EXPECT_LT(record[2], 1e-4) << i;  // [J], of some 2 J that they fell with
    for (std::uint64_t j = 0; j < i; ++j) EXPECT_NE(records[j][1], record[1]) << i << " and " << j;
  }
  EXPECT_LT(centres.front(), centres.back());
}

}  // namespace
}  // namespace torsor::mpi_test
