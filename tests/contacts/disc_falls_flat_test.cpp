// SPDX-License-Identifier: GPL-3.0-or-later
// A thin disc that leans on its rim and falls flat: its lowest point jumps to the other side there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/contacts/simple_systems.hpp"

namespace disc_falls_flat_test {
namespace {

using namespace simple_systems;

constexpr double R = 0.1, I = R * R / 4;

// Energy says how fast it turns when it is flat: (I + R^2 cos^2 β) β'^2/2 = g R (sin β0 - sin β). It went on flat without
// an end, as if the impact of the other side were a part of a step.
TEST(DiscFallsFlat, HasNoPointThere) {
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-10, 1e-13}) {
    for (const double start : {0.02, 0.3, 0.8}) {
      std::array<double, 4> y{R * std::sin(start), start, 0, 0};
      const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      ContactOptions options;
      const auto steps = [n = 0](const double&, const auto&) mutable { return ++n < 10000; };
      const ContactResult result = integrate_contacts(leaning_disc(R), y, 0, 1, method, options, steps);
      EXPECT_EQ(result.status, ContactStatus::no_point) << tolerance << " " << start << ": " << describe(result.status);
      EXPECT_EQ(result.contact, 0);
      EXPECT_NEAR(y[1], 0, 100 * tolerance);
      EXPECT_NEAR(y[3], -std::sqrt(2 * g * R * std::sin(start) / (I + R * R)), 1000 * tolerance + 1e-10);
    }
  }
}

}  // namespace
}  // namespace disc_falls_flat_test
