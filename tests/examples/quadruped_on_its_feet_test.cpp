// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/quadruped_on_its_feet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace torsor::quadruped_on_its_feet_test {
namespace {

using namespace torsor::runtime;
using Robot = quadruped_on_its_feet::Mechanism<double>;
constexpr int first_joint = 7, first_rate = 6;
constexpr double g = 9.81, mass = 6 + 4 * (0.5 + 0.8 + 0.2 + 0.06);

struct Hold {
  Robot::Inputs operator()(const Robot::State& state) const {
    constexpr std::array crouch{0.0, 0.7, -1.4};
    Robot::Inputs torques{};
    for (int j = 0; j < Robot::input_count; ++j) {
      torques[j] = 60 * (crouch[static_cast<std::size_t>(j % 3)] - state.q[first_joint + j]) - 2 * state.v[first_rate + j];
    }
    return torques;
  }
};
using OnItsFeet = MechanismWithContacts<Robot, Hold>;

struct Landing {
  struct Told { ContactEventKind kind; double time, energy_lost; };
  std::vector<Told> events{};
  double deepest = 0;
  const OnItsFeet& robot;
  void operator()(const ContactEvent& event) { events.push_back({event.kind, event.time, event.energy_lost}); }
  void operator()(double t, const OnItsFeet::State& y) {
    ContactReading reading(ContactMechanismOf<OnItsFeet>(robot).sizes(), Robot::contact_row_count);
    if (robot.read(t, y, reading) != Evaluation::ok) deepest = INFINITY;
    for (const double gap : reading.gap) deepest = std::max(deepest, -gap);
  }
};

// It falls as one body, for its motors are at rest in the crouch, and then stands: at rest M a + h = E u + Jᵀ r with
// a = 0, which is 18 equations, and reactions inside the cones carry the weight.
TEST(QuadrupedOnItsFeet, LandsAndStands) {
  const OnItsFeet robot;
  const ContactMechanismOf<OnItsFeet> mechanism(robot);
  Landing landing{.robot = robot};
  OnItsFeet::State y = robot.initial();
  constexpr DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};
  ContactRun<OnItsFeet::nq + OnItsFeet::nv, OnItsFeet::contacts, DormandPrince853, Landing> run(mechanism, y, method, {},
                                                                                            landing);
  ASSERT_TRUE(run.start(0) && run.advance(8)) << describe(run.result().status) << " at " << run.result().time;
  EXPECT_LE(run.result().worst_residual, 1e-13);
  EXPECT_LE(landing.deepest, 1e-14);
  // The feet land at one time; their slips end one by one, or together where errors of the integration part them.
  ASSERT_TRUE(landing.events.size() >= 2 && landing.events.size() <= 5) << landing.events.size();
  EXPECT_EQ(landing.events[0].kind, ContactEventKind::impact);
  for (std::size_t i = 1; i < landing.events.size(); ++i) EXPECT_EQ(landing.events[i].kind, ContactEventKind::slip_ends);
  const double height = 0.45 - 2 * 0.2 * std::cos(0.7) - 0.02;
  EXPECT_NEAR(landing.events[0].time, std::sqrt(2 * height / g), 1e-10);
  EXPECT_GT(landing.events[0].energy_lost, 0);
  // More than the energy of the fall cannot be lost.
  EXPECT_LT(landing.events[0].energy_lost, mass * (g * height + 0.5 * 0.5 * 0.5));

  ASSERT_EQ(run.motion().solve(8, y), Evaluation::ok);
  const ContactVector& r = run.motion().reactions();
  const auto state = unpack<Robot>(8.0, y);
  double carried = 0;
  for (int foot = 0; foot < 4; ++foot) {
    EXPECT_GT(r(3 * foot), 0);
    EXPECT_LT(std::hypot(r(3 * foot + 1), r(3 * foot + 2)), 0.6 * r(3 * foot));
    EXPECT_EQ(run.motion().states[static_cast<std::size_t>(foot)].regime, ContactRegime::sticks);
    carried += r(3 * foot);
  }
  EXPECT_NEAR(carried, mass * g, 1e-4);
  Robot::GeneralizedForces bias{};
  Robot::Contacts contacts;
  Robot::bias(robot.precomputed(), state, bias);
  Robot::contacts(robot.precomputed(), state, contacts);
  const Robot::Inputs torques = Hold{}(state);
  constexpr std::size_t rows = Robot::contact_row_count;
  for (std::size_t i = 0; i < OnItsFeet::nv; ++i) {
    double left = bias[static_cast<int>(i)];
    if (i >= first_rate) left -= torques[static_cast<int>(i) - first_rate];
    for (std::size_t k = 0; k < rows; ++k) left -= contacts.jacobian[i * rows + k] * r(static_cast<int>(k));
    EXPECT_NEAR(left, 0, 1e-4) << i;  // what eight seconds leave of its swaying
  }
}

template <class Method>
ContactResult land(OnItsFeet::State& y, double tolerance) {
  const OnItsFeet robot;
  y = robot.initial();
  return integrate_contacts(robot, y, 0, 2, Method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
}

// Its motors are stiff beside the sway of the trunk: an implicit method of the same motion asks for less.
TEST(QuadrupedOnItsFeet, LandsAlikeByAMethodForStiffMotors) {
  OnItsFeet::State exact, stiff;
  const ContactResult of_exact = land<DormandPrince853>(exact, 1e-9), of_stiff = land<RadauIia5>(stiff, 1e-4);
  ASSERT_TRUE(of_exact && of_stiff) << describe(of_stiff.status) << " at " << of_stiff.time;
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(stiff[i], exact[i], 1e-4) << i;  // its tolerance
  // Steps of the other are bound by the motors, whatever its tolerance.
  EXPECT_LT(of_stiff.integration.statistics.calls, of_exact.integration.statistics.calls);
}

}  // namespace
}  // namespace torsor::quadruped_on_its_feet_test
