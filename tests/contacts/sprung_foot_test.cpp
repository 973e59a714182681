// SPDX-License-Identifier: GPL-3.0-or-later
// A foot on a stiff spring, let fall: it strikes the floor, stays on it while the spring is pressed, and lifts off as its force
// fades. Steps of an implicit method are much longer there than what the foot does.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"

namespace sprung_foot_test {
namespace {

using namespace simple_systems;

struct Leg {
  double stiffness, damping, foot, restitution;
};

/// q = (z, w): a mass of 1 kg at z, and its foot at z + w, 0.1 m above the point that strikes.
ByHand<2, 2, 1> sprung(const Leg& leg) {
  return {{ContactRule{.tangents = 0, .restitution = leg.restitution}}, [leg](double, const auto& y, auto& r) {
            r.M << 1 + leg.foot, leg.foot, leg.foot, leg.foot;
            r.F << -(1 + leg.foot) * g, -leg.foot * g - leg.stiffness * y[1] - leg.damping * y[3];
            r.gap[0] = y[0] + y[1] - 0.1;
            r.J << 1, 1;
            r.w(0) = y[2] + y[3];
            r.drift(0) = 0;
          }};
}

struct Motion {
  ContactResult result;
  std::array<double, 4> y{0.3, 0, 0, 0};
  std::vector<ContactEventKind> events;
};

struct Observed {
  Motion& motion;
  bool operator()(const ContactEvent& event) const {
    motion.events.push_back(event.kind);
    return true;
  }
};

template <class Method>
Motion moved(const Leg& leg, double tolerance) {
  Motion motion;
  motion.result = integrate_contacts(sprung(leg), motion.y, 0, 0.4,
                                     Method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance}, {},
                                     Observed{motion});
  return motion;
}

// z(0.4) by matrix exponentials of both phases, the lift-off at 0.211771695693 s.
TEST(SprungFoot, LiftsOffOnceAsItDoesInClosedForm) {
  const Leg leg{1e5, 20, 0.01, 0};
  for (const double tolerance : {1e-6, 1e-8, 1e-9, 1e-12}) {
    const Motion motion = moved<RadauIia5>(leg, tolerance);
    EXPECT_EQ(motion.result.status, ContactStatus::reached_end) << tolerance;
    EXPECT_EQ(motion.events, (std::vector{ContactEventKind::impact, ContactEventKind::opens})) << tolerance;
    EXPECT_NEAR(motion.y[0], 0.260431879300, 1e3 * tolerance + 1e-11) << tolerance;
  }
}

TEST(SprungFoot, MovesAlikeByMethodsForStiffAndForOtherEquations) {
  for (const Leg& leg : {Leg{1e5, 0, 0.01, 0}, Leg{1e3, 1, 0.1, 0.5}, Leg{1e5, 20, 0.1, 0}, Leg{1e5, 300, 0.01, 0},
                         Leg{1e5, 20, 0.01, 0.5}}) {
    const Motion expected = moved<DormandPrince853>(leg, 1e-12);
    ASSERT_EQ(expected.result.status, ContactStatus::reached_end);
    for (const double tolerance : {1e-7, 1e-10}) {
      const Motion motion = moved<RadauIia5>(leg, tolerance);
      EXPECT_EQ(motion.result.status, ContactStatus::reached_end) << leg.stiffness << " " << leg.damping << " " << tolerance;
      EXPECT_EQ(motion.events, expected.events) << leg.stiffness << " " << leg.damping << " " << tolerance;
      EXPECT_NEAR(motion.y[0], expected.y[0], 1e4 * tolerance) << leg.stiffness << " " << leg.damping << " " << tolerance;
    }
  }
}

// Steps of one length cannot be taken in shorter ones: impacts follow without a flight until forces draw the foot away beyond
// what is doubted of them.
TEST(SprungFoot, LiftsOffByStepsOfOneLength) {
  for (const double step : {2.5e-4, 4.5e-4}) {
    Motion motion;
    motion.result = integrate_contacts(sprung({1e5, 20, 0.01, 0}), motion.y, 0, 0.4,
                                       GaussCollocation<4, StageSolver::newton>{.step = step}, {}, Observed{motion});
    EXPECT_EQ(motion.result.status, ContactStatus::reached_end) << step;
    EXPECT_NEAR(motion.y[0], 0.260431879300, 1e-7) << step;
  }
}

}  // namespace
}  // namespace sprung_foot_test
