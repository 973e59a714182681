// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of loops whose rows repeat each other in a way that changes along them.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/bricard.hpp"

namespace torsor::bricard_test {
namespace {

using namespace testing_programs;
using namespace testing_mechanisms;

// It passes θ = 0 after 1.59 s, where the last of the rows counts and the others do not suffice without it.
TEST(Bricard, PassesThePlacesWhereOtherRowsCount) {
  const Outcome outcome = run(threefold_linkage, {"simulate", "--to", "3", "--step", "0.1", "--tolerance", "1e-11"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  double least = 10, largest = -10;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    const double theta = motion.at(row, "t0"), phi = motion.at(row, "t1");
    EXPECT_NEAR(std::cos(theta) + std::cos(phi) + std::cos(theta) * std::cos(phi), 0, 1e-13) << row;
    for (const char* other : {"t2", "t4"}) EXPECT_NEAR(motion.at(row, other), theta, 1e-12) << row;
    for (const char* other : {"t3", "t5"}) EXPECT_NEAR(motion.at(row, other), phi, 1e-12) << row;
    EXPECT_NEAR(motion.at(row, "mechanical_energy"), motion.at(0, "mechanical_energy"), 1e-8) << row;
    least = std::min(least, theta);
    largest = std::max(largest, theta);
  }
  EXPECT_LT(least, -0.5);
  EXPECT_GT(largest, 0.5);
}

// No row of this one can be left out everywhere. Its motion ends near such a place, and says so.
TEST(Bricard, NamesTheRowsLeftOutWhereTheyCount) {
  const Outcome outcome = run(trihedral_linkage, {"simulate", "--to", "20", "--step", "0.1"});
  ASSERT_EQ(outcome.code, 1) << outcome.out;
  EXPECT_NE(outcome.err.find("left out ('close_"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("It is no change point"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace torsor::bricard_test
