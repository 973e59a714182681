// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "examples/grains/machines.hpp"

namespace grains_example_test {
namespace {

using namespace grains_example;

// Without friction the drum cannot lift anything; with it discs lie the steeper the rougher they are, and the drum's
// torque carries the centre of mass aside.
TEST(GrainsExample, LieSteeperInADrumTheRougherTheyAre) {
  double before = -0.05;
  for (const double f : {0.0, 0.1, 0.5}) {
    Drum drum(80, f, 0.07);
    (void)drum.run(0.8);
    const Drum::Shown shown = drum.run(0.8);
    EXPECT_GT(shown.angle, before);
    if (f == 0) {
      EXPECT_NEAR(shown.angle, 0, 0.02);
    }
    // The momentum that the grains have at the ends: all of them at the speed of the drum, over the time.
    const double change = 80 * 2500 * 3.2 * most_radius * most_radius * 0.07 * 0.07 * 0.4 * 2 / 0.8;
    EXPECT_NEAR(shown.torque, shown.weight, change);
    if (f > 0) {
      EXPECT_GT(shown.weight, 5 * change);
    }
    before = shown.angle + 0.05;
  }
  EXPECT_GT(before, 0.3);
  EXPECT_LT(before, 0.8);
}

// A wide opening lets discs flow, a narrow one is bridged by an arch.
TEST(GrainsExample, FlowOutOfASiloOrBridgeItsOpening) {
  Silo narrow(100, 0.8, 0.014, 0.12), wide(100, 0.3, 0.06, 0.12);
  (void)narrow.run(0.8);
  EXPECT_EQ(narrow.run(0.3), 0);
  (void)wide.run(0.3);
  const double first = wide.run(0.4), second = wide.run(0.4);
  EXPECT_GT(first, 5);
  EXPECT_NEAR(second, first, first / 2);
}

}  // namespace
}  // namespace grains_example_test
