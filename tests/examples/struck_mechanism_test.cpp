// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "generated/struck_mechanism.hpp"
#include "generated/struck_mechanism_two_rods.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::struck_mechanism_test {
namespace {

using namespace torsor::runtime;
using Rod = MechanismWithContacts<struck_mechanism::Mechanism<double>>;
using TwoRods = MechanismWithContacts<struck_mechanism_two_rods::Mechanism<double>>;

// An impact is one solve with numbers of size 1: some ten roundings.
constexpr double rounding = 1e-14;

template <class S>
struct Blow {
  typename S::State y;
  double impulse = 0, energy_lost = 0, last_impact = 0;
  std::array<double, S::nv> change{};  ///< of velocities

  Blow(const S& system, const typename S::State& start, double end) : y(start) {
    const auto log = [&](const ContactEvent& e) {
      if (e.kind != ContactEventKind::impact) return;
      impulse = e.impulses(0);
      energy_lost = e.energy_lost;
      for (std::size_t i = 0; i < S::nv; ++i) change[i] = e.state[S::nq + i] - e.before[S::nq + i];
    };
    const auto result = integrate_contacts(
        system, y, 0, end, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}, {}, log);
    EXPECT_TRUE(result) << describe(result.status);
    EXPECT_EQ(result.impacts, 1);
  }
};

// The ball stands a little off, so that the impact is an event of the motion, which gravity changes by g t only.
constexpr double gap = 1e-9;

// struck_pendulum.md: P, omega+, v_b+, hinge impulse, loss, each over 401.
TEST(StruckMechanism, ExchangesTheImpulsesOfTheSheet) {
  struct Case { double e, P, omega, ball, hinge, loss; };
  for (const Case& exact : {Case{0, 384, 360, 324, 48, 768}, Case{0.5, 576, 540, -316, 72, 576},
                            Case{1, 768, 720, -956, 96, 0}}) {
    const Rod rod({.d = 0.9, .e = exact.e});
    Rod::State y = rod.initial();
    y[1] -= gap;
    const Blow<Rod> blow(rod, y, gap);
    EXPECT_NEAR(blow.impulse, exact.P / 401, rounding);
    EXPECT_NEAR(blow.change[0], exact.omega / 401, rounding);
    EXPECT_NEAR(blow.change[1], exact.ball / 401 - 4, rounding);
    EXPECT_NEAR(blow.energy_lost, exact.loss / 401, rounding * 8);
    // The hinge's impulse on the rod along x: momentum of the rod less the ball's impulse. G is at L/2 = 0.6 m.
    EXPECT_NEAR(2 * 0.6 * blow.change[0] - blow.impulse, exact.hinge / 401, rounding);
  }
}

// At the centre of percussion, 2 L/3 below the hinge, the hinge feels nothing; above it the rod pushes back.
TEST(StruckMechanism, SparesTheHingeAtTheCentreOfPercussion) {
  for (const double d : {0.2, 0.8, 1.2}) {
    const Rod rod({.d = d, .e = 0.5});
    Rod::State y = rod.initial();
    const double before = y[1] -= gap;
    const Blow<Rod> blow(rod, y, gap);
    EXPECT_LT(before, -0.05);
    const double J = 0.96, hinge = 2 * 0.6 * blow.change[0] - blow.impulse;
    EXPECT_NEAR(blow.change[0], blow.impulse * d / J, rounding);
    EXPECT_NEAR(hinge, blow.impulse * (2 * 1.2 * d / (2 * J) - 1), rounding);
  }
}

// Afterwards the rod swings as far as the energy of the sheet says.
TEST(StruckMechanism, SwingsAsFarAsItsEnergyAllows) {
  const Rod rod({.d = 0.9, .e = 0});
  Rod::State y = rod.initial();
  double highest = 0;
  const auto watch = [&](const double&, const Rod::State& at) { highest = std::max(highest, at[0]); };
  const auto result =
      integrate_contacts(rod, y, 0, 0.3, DormandPrince853{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12}, {}, watch);
  ASSERT_TRUE(result) << describe(result.status);
  EXPECT_LT(highest, 0.2570781707378777308948292 + 1e-11);
}

// Two jointed rods: P, v_ball+, v_A+, w1, w2 and the loss. B is held by a loop constraint.
TEST(StruckMechanismTwoRods, MoveAsTheSheetSays) {
  struct Case { double e, P, ball, A, w1, w2, joint, loss; };
  for (const Case& exact : {Case{0, 2.0 / 11, 7.0 / 11, 7.0 / 11, -9.0 / 11, 3.0 / 11, -1.0 / 22, 1.0 / 11},
                            Case{0.5, 3.0 / 11, 5.0 / 11, 21.0 / 22, -27.0 / 22, 9.0 / 22, -3.0 / 44, 3.0 / 44},
                            Case{1, 4.0 / 11, 3.0 / 11, 14.0 / 11, -18.0 / 11, 6.0 / 11, -1.0 / 11, 0}}) {
    const TwoRods rods({.e = exact.e});
    TwoRods::State y = rods.initial();
    y[6] -= gap;
    const Blow<TwoRods> blow(rods, y, 2 * gap);
    const auto& v = blow.change;  // x1, z1, w1, x2, z2, w2, z
    EXPECT_NEAR(blow.impulse, exact.P, rounding);
    EXPECT_NEAR(v[2], exact.w1, rounding);
    EXPECT_NEAR(v[5], exact.w2, rounding);
    EXPECT_NEAR(v[1] - v[2] / 2, exact.A, rounding);
    EXPECT_NEAR(v[6] + 1, exact.ball, rounding);
    EXPECT_NEAR(v[4], exact.joint, rounding);  // all that BC, of mass 1, has
    EXPECT_NEAR(blow.energy_lost, exact.loss, rounding);
  }
}

}  // namespace
}  // namespace torsor::struck_mechanism_test
