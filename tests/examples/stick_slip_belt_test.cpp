// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generated/stick_slip_belt.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::stick_slip_belt_test {
namespace {

using namespace torsor::runtime;
using Block = MechanismWithContacts<stick_slip_belt::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

// A hundred steps within 1e-13, and events located to that of velocities below 1 m/s.
constexpr double allowed = 1e-11;

struct Switch {
  ContactEventKind kind;
  double time, x;
};

// stick_slip_belt.md, A: the block joins the belt once and is on its cycle from then on.
TEST(StickSlipBelt, IsOnItsCycleFromTheFirstSticking) {
  const Block block;
  Block::State y = block.initial();
  std::vector<Switch> switches;
  const auto result =
      integrate_contacts(block, y, 0, 6, precise, {}, [&](const ContactEvent& event) {
        switches.push_back({event.kind, event.time, event.state[0]});
        return true;
      });
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_LE(result.worst_residual, 1e-13);
  ASSERT_GE(switches.size(), 5U);
  // At rest on the running belt it is dragged, without any impact.
  for (std::size_t i = 0; i < switches.size(); ++i) {
    EXPECT_EQ(switches[i].kind, i % 2 == 0 ? ContactEventKind::slip_ends : ContactEventKind::slips) << i;
  }
  for (std::size_t i = 1; i + 1 < switches.size(); i += 2) {
    EXPECT_NEAR(switches[i].x, 0.1962, allowed);
    if (i > 1) {
      EXPECT_NEAR(switches[i].time - switches[i - 1].time, 0.5886, allowed);
    }
    EXPECT_NEAR(switches[i + 1].time - switches[i].time, 0.8670739255408371736850496412, allowed);
    EXPECT_NEAR(switches[i + 1].x, 2 * 0.35 * 19.62 / 50 - 0.1962, allowed);
  }
}

TEST(StickSlipBelt, SwingsBetweenThePlacesOfTheSheet) {
  const Block block;
  Block::State y = block.initial();
  ASSERT_TRUE(integrate_contacts(block, y, 0, 2, precise));
  // The extremes, where the block stands: by the energy about f N/k while it slips.
  double most = 0, least = 1;
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(integrate_contacts(block, y, 2 + 0.01 * i, 2 + 0.01 * (i + 1), precise));
    if (y[2] >= 0.2 - 1e-9) continue;  // with the belt
    const double middle = 0.35 * 19.62 / 50, reach = std::hypot(y[0] - middle, y[2] / 5);
    most = std::max(most, middle + reach);
    least = std::min(least, middle - reach);
  }
  EXPECT_NEAR(most, 0.2085052977229773134882287092, allowed);
  EXPECT_NEAR(least, 0.06617470227702268651177129085, allowed);
}

}  // namespace
}  // namespace torsor::stick_slip_belt_test
