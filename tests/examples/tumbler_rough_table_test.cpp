// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generated/tumbler.hpp"
#include "generated/tumbler_rough_table.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/events/contact_regime.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace torsor::tumbler_rough_table_test {
namespace {

using namespace torsor::runtime;
using Assumed = tumbler::Mechanism<double>;
using Tumbler = MechanismWithContacts<tumbler_rough_table::Mechanism<double>>;
constexpr double end = 0.5;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

/// The state with the centre of the sphere in the place of the centre of mass, which is 2 cm below it.
StateVector<Assumed> of_the_sphere(const Tumbler::State& y) {
  constexpr double a = 0.02;
  const double psi = y[3], theta = y[4], psi_rate = y[9], theta_rate = y[10];
  StateVector<Assumed> other{};
  std::copy(y.begin(), y.end(), other.begin());
  other[0] += a * std::sin(psi) * std::sin(theta);
  other[1] -= a * std::cos(psi) * std::sin(theta);
  other[2] += a * std::cos(theta);
  other[6] += a * (std::cos(psi) * std::sin(theta) * psi_rate + std::sin(psi) * std::cos(theta) * theta_rate);
  other[7] += a * (std::sin(psi) * std::sin(theta) * psi_rate - std::cos(psi) * std::cos(theta) * theta_rate);
  other[8] -= a * std::sin(theta) * theta_rate;
  return other;
}

/// The page's motion, which assumes that it rolls: its state at the end, and the most friction that it needs until
/// then.
StateVector<Assumed> assumed_motion(double& needed) {
  const auto motion = equations_of_motion<Assumed>();
  auto y = motion.initial();
  needed = 0;
  const auto look = [&](double t, const auto& at) {
    Assumed::Accelerations unused{};
    Assumed::Multipliers reaction{};
    (void)motion.accelerations(unpack<Assumed>(t, at), unused, reaction);
    needed = std::max(needed, required_friction(reaction.N, tangential(reaction.X, reaction.Y)));
  };
  look(0, y);
  for (int k = 0; k < 200; ++k) {
    const auto result = integrate(motion, y, end * k / 200, end * (k + 1) / 200, precise);
    EXPECT_TRUE(result) << describe(result);
    look(end * (k + 1) / 200, y);
  }
  return y;
}

// With a little more friction than the page's motion needs, the contact that nothing is assumed of rolls as the page
// says; with less it slips, and the assumption has ended.
TEST(TumblerRoughTable, RollsWhereFrictionSufficesAndSlipsWhereItDoesNot) {
  double needed = 0;
  const auto rolled = assumed_motion(needed);
  EXPECT_GT(needed, 0.01);
  for (const double part : {1.01, 0.97}) {
    const Tumbler system({.f = part * needed});
    Tumbler::State y = system.initial();
    int slips = 0;
    const auto result =
        integrate_contacts(system, y, 0, end, precise, {}, [&](const ContactEvent& event) {
          slips += event.kind == ContactEventKind::slips ? 1 : 0;
          return true;
        });
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_LE(result.worst_residual, 1e-13);
    double apart = 0;
    const StateVector<Assumed> sphere = of_the_sphere(y);
    for (std::size_t i = 0; i < y.size(); ++i) apart = std::max(apart, std::abs(sphere[i] - rolled[i]));
    if (part > 1) {
      EXPECT_EQ(slips, 0);
      // Hundreds of steps within 1e-13 of rates up to some 10 rad/s.
      EXPECT_LE(apart, 1e-9);
    } else {
      EXPECT_GT(apart, 1e-4);
    }
  }
}

}  // namespace
}  // namespace torsor::tumbler_rough_table_test
