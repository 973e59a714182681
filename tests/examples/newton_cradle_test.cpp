// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "generated/newton_cradle.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::newton_cradle_test {
namespace {

using namespace torsor::runtime;
using Cradle = MechanismWithContacts<newton_cradle::Mechanism<double>>;
using Velocities = std::array<double, 5>;

struct Told { ContactEventKind kind; double energy_lost; Velocities v; };

/// Velocities to the right over that of the balls let go, at each event of `end` seconds.
std::vector<Told> swing(double e, int let_go, ImpactLaw law, double end) {
  const Cradle cradle({.e = e});
  Cradle::State y = cradle.initial();
  for (int i = 1; i < let_go; ++i) y[static_cast<std::size_t>(i)] = y[0];
  const double speed = std::sqrt(2 * 9.81 * (1 - std::cos(0.3)));
  std::vector<Told> events;
  const auto result =
      integrate_contacts(cradle, y, 0, end, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13},
                         {.law = law}, [&](const ContactEvent& event) {
                           Told told{event.kind, event.energy_lost, {}};
                           for (std::size_t i = 0; i < 5; ++i) told.v[i] = -event.state[Cradle::nq + i] / speed;
                           events.push_back(told);
                         });
  EXPECT_TRUE(result) << describe(result.status) << " at " << result.time;
  EXPECT_LE(result.worst_residual, 1e-13);
  return events;
}

void expect_first(const std::vector<Told>& events, const Velocities& exact) {
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events[0].kind, ContactEventKind::impact);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(events[0].v[i], exact[i], 1e-11) << i;
}

// Newton: w+ = -e w- of the struck contact, the others keep w = 0, so that four balls leave together. Poisson: the
// impulses (4, 3, 2, 1)/5 of compression, and as many once more.
TEST(NewtonCradle, SendsFourBallsOutWhereAllContactsStrikeAtOnce) {
  const Velocities together{-0.6, 0.4, 0.4, 0.4, 0.4};
  expect_first(swing(1, 1, ImpactLaw::newton_moreau, 0.6), together);
  expect_first(swing(1, 1, ImpactLaw::poisson, 0.6), together);
}

TEST(NewtonCradle, SendsOutAsManyAsCameInWhereContactsStrikeInTurn) {
  expect_first(swing(1, 1, ImpactLaw::sequential, 0.6), {0, 0, 0, 0, 1});
  expect_first(swing(1, 2, ImpactLaw::sequential, 0.6), {0, 0, 0, 1, 1});
}

// Of the balls that swing side by side none parts from the other by rounding: one impact each half swing.
TEST(NewtonCradle, HasOneImpactEachHalfSwing) {
  for (const ImpactLaw law : {ImpactLaw::newton_moreau, ImpactLaw::sequential}) {
    const std::vector<Told> events = swing(1, 1, law, 2.2);
    const auto impacts = std::count_if(events.begin(), events.end(),
                                       [](const Told& told) { return told.kind == ContactEventKind::impact; });
    EXPECT_EQ(impacts, 2) << describe(law);
    for (const Told& told : events) EXPECT_NEAR(told.energy_lost, 0, 1e-12);
  }
}

}  // namespace
}  // namespace torsor::newton_cradle_test
