// SPDX-License-Identifier: GPL-3.0-or-later
// Slips that begin from rest where velocities have been put to zero again and again, and where a loop brings them back.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/contact_motion.hpp"
#include "tests/contacts/rod_over_table.hpp"

namespace rod_over_table_test {
namespace {

using namespace rod_over_table;

constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

// What is left of a velocity at rest is 1e-58 m/s here, and its own rounding less by as much: it was once taken for a slip
// with a direction. The first start lies on the table, the second falls on it.
TEST(RodOverTable, BeginsToSlipFromRestHoweverSmallWhatIsLeftOfVelocities) {
  struct Run { double height, end; };
  for (const Run run : {Run{0, 0.06}, Run{0.1, 1.95}}) {
    SCOPED_TRACE(run.height);
    const Rod rod;
    Rod::State y = rod.above(run.height);
    int slips = 0;
    const ContactResult result = integrate_contacts(rod, y, 0, run.end, precise, {}, [&slips](const ContactEvent& event) {
      slips += event.kind == ContactEventKind::slips ? 1 : 0;
      return true;
    });
    EXPECT_TRUE(result) << describe(result.status) << ": " << describe(result.integration_event) << " at " << result.time;
    EXPECT_LE(result.worst_residual, 1e-13);
    EXPECT_GE(slips, 1);
  }
}

// The first particle swings about the second, which is at rest. The rod is off its rate by rounding of the first one's
// velocity, and putting it back moves both.
TEST(RodOverTable, KnowsWhatLoopsLeaveOfAVelocityAtRest) {
  const Rod rod;
  const ContactMechanismOf<Rod> mechanism(rod);
  int moved = 0;
  for (int k = 1; k <= 20; ++k) {
    const double angle = 0.31 * k, c = std::cos(angle), s = std::sin(angle);
    ContactMotion motion(mechanism);
    for (int i = 0; i < 2; ++i) motion.states[static_cast<std::size_t>(i)] = {.touches = true, .regime = ContactRegime::slides};
    Rod::State y{0, 0, 0, Rod::length * c, Rod::length * s, 0, -0.07 * s, 0.07 * c, rod.A * Rod::w, 0, 0, rod.A * Rod::w};
    ASSERT_EQ(motion.project(0, y), Evaluation::ok);
    for (const int row : {4, 5}) {
      EXPECT_LE(std::abs(motion.reading().w(row)), motion.rounding_of(row));
      moved += motion.reading().w(row) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 5);
}

}  // namespace
}  // namespace rod_over_table_test
