// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/events/contact_regime.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace contact_regime_test {
namespace {

using namespace torsor::runtime;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A block at rest on a slope of 3 in 5 needs f = 3/4, whatever its weight: N = 4 P/5, T = 3 P/5.
TEST(ContactRegime, AsksForTheSlopeOfABlockAtRest) {
  const double normal = 16.0, along = tangential(-12.0);
  EXPECT_EQ(along, 12.0);
  EXPECT_EQ(required_friction(normal, along), 0.75);
  EXPECT_TRUE(adheres(0.75, normal, along));
  EXPECT_FALSE(adheres(0.74, normal, along));
  EXPECT_EQ(adherence_margin(1.0, normal, along), 4.0);
  EXPECT_LT(adherence_margin(0.5, normal, along), 0.0);
  EXPECT_EQ(tangential(3.0, -4.0), 5.0);
}

TEST(ContactRegime, OpensWhereTheNormalForceWouldPull) {
  EXPECT_TRUE(presses(0.0));
  EXPECT_FALSE(presses(-1e-300));
  EXPECT_FALSE(adheres(10.0, -1.0, 0.0));
  EXPECT_EQ(required_friction(0.0, 0.0), 0.0);
  EXPECT_EQ(required_friction(0.0, 1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(required_friction(-2.0, 1.0), std::numeric_limits<double>::infinity());
}

TEST(ContactRegime, TrustsNoNaN) {
  EXPECT_FALSE(presses(nan));
  EXPECT_FALSE(adheres(0.5, nan, 1.0));
  EXPECT_FALSE(adheres(0.5, 1.0, nan));
  EXPECT_FALSE(keeps_sliding(nan));
}

TEST(ContactRegime, EndsASlipWhereItTurnsBack) {
  EXPECT_TRUE(keeps_sliding(1e-9));
  EXPECT_FALSE(keeps_sliding(0.0));
  EXPECT_FALSE(keeps_sliding(-1.0));
}

}  // namespace
}  // namespace contact_regime_test
