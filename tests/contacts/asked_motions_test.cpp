// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that are asked for what cannot be.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/contacts/simple_systems.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"

namespace asked_motions_test {
namespace {

using namespace simple_systems;

constexpr double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

TEST(AskedMotions, OfImpossibleOptionsAreRefused) {
  const auto law = static_cast<ImpactLaw>(9);  // it gave no impulse, and the ball rested after 17 impacts
  for (const ContactOptions& wrong :
       {ContactOptions{.law = law}, ContactOptions{.touch = none}, ContactOptions{.touch = -1}, ContactOptions{.at_rest = none},
        ContactOptions{.at_rest = -1}, ContactOptions{.accumulation = none}, ContactOptions{.accumulation = -1}}) {
    std::array<double, 2> y{1, 0};
    const ContactResult result = integrate_contacts(ball(0.5), y, 0, 1, DormandPrince853{}, wrong);
    EXPECT_EQ(result.status, ContactStatus::invalid_options) << describe(result.status);
    EXPECT_EQ(y[0], 1);
  }
  for (const double end : {-1.0, none}) {
    std::array<double, 2> y{1, 0};
    EXPECT_EQ(integrate_contacts(ball(0.5), y, 0, end).status, ContactStatus::invalid_options);
  }
}

TEST(AskedMotions, OfStatesThatAreNoNumbersFailWithTheStatusOfTheirIntegration) {
  for (const std::array<double, 2>& start : {std::array{none, 0.0}, std::array{1.0, none}, std::array{infinite, 0.0}}) {
    std::array<double, 2> y = start;
    const ContactResult result = integrate_contacts(ball(0.5), y, 0, 1);
    EXPECT_EQ(result.status, ContactStatus::integration_failed);
    EXPECT_EQ(result.integration.status, IntegrationStatus::invalid_options);
  }
}

// What a piece of a motion knows of regimes is that of the state where it ended: once a body that was kicked in between was put
// back at rest where it stood.
TEST(AskedMotions, AreNotGoneOnWithFromAnotherState) {
  const auto resting = ball(0.5);
  const ContactMechanismOf<ByHand<1, 1, 1>> mechanism(resting);
  std::array<double, 2> y{0, 0};
  IgnoreSteps nobody;
  ContactRun<2, 1, DormandPrince853, IgnoreSteps> run(mechanism, y, DormandPrince853{}, {}, nobody);
  ASSERT_TRUE(run.start(0) && run.advance(0.2));
  y[1] = 5;
  EXPECT_FALSE(run.advance(0.5));
  EXPECT_EQ(run.result().status, ContactStatus::not_started);
  EXPECT_EQ(y[1], 5);
  ASSERT_TRUE(run.start(0.2) && run.advance(0.5));
  EXPECT_NEAR(y[1], 5 - g * 0.3, 1e-14);
  EXPECT_FALSE(run.advance(0.4));
  EXPECT_EQ(run.result().status, ContactStatus::invalid_options);
}

// Once a step from such a state had the status of one that was made.
TEST(AskedMotions, ByStepsAreRefusedWhereTheyAreNoNumbers) {
  const auto falling = ball(0.5);
  for (const std::array<double, 2>& start : {std::array{none, 0.0}, std::array{0.0, none}, std::array{infinite, 0.0}}) {
    std::array<double, 2> y = start;
    MoreauJean scheme(falling);
    EXPECT_FALSE(scheme.step(0, 0.1, y));
    EXPECT_EQ(scheme.status(), ContactStatus::integration_failed);
  }
  for (const double h : {0.0, -1.0, none, infinite}) {
    std::array<double, 2> y{1, 0};
    MoreauJean scheme(falling);
    EXPECT_FALSE(scheme.step(0, h, y));
    EXPECT_EQ(scheme.status(), ContactStatus::invalid_options) << h;
  }
  // A force that overflows along the way leaves the state as it was.
  auto torn = ball(0.5);
  torn.fill = [usual = torn.fill](double t, const auto& state, auto& r) {
    usual(t, state, r);
    r.F(0) = std::numeric_limits<double>::max();
  };
  std::array<double, 2> y{1, std::numeric_limits<double>::max()};
  MoreauJean scheme(torn);
  EXPECT_FALSE(scheme.step(0, 1, y));
  EXPECT_EQ(scheme.status(), ContactStatus::integration_failed);
  EXPECT_EQ(y[0], 1);
}

TEST(AskedMotions, WithoutALengthAreWhereTheyBegan) {
  std::array<double, 2> y{1, -1};
  EXPECT_TRUE(integrate_contacts(ball(0.5), y, 2, 2));
  EXPECT_EQ(step_contacts(ball(0.5), y, 2, 2, {.count = 10}), ContactStatus::reached_end);
  EXPECT_EQ(y, (std::array{1.0, -1.0}));
}

TEST(AskedMotions, ThatNoContactEndsNameNone) {
  std::array<double, 2> y{1, -1};
  const auto fallen = integrate_contacts(ball(0.5), y, 0, 0.1);
  ASSERT_TRUE(fallen);
  EXPECT_FALSE(fallen.contact);
  const auto falling = ball(0.5);
  MoreauJean scheme(falling);
  ASSERT_TRUE(scheme.step(0.1, 1e-3, y));
  EXPECT_FALSE(scheme.contact());
}

}  // namespace
}  // namespace asked_motions_test
