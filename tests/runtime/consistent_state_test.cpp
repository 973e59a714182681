// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/constraints/consistent_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "torsor/runtime/batch/motion_ensemble.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "tests/runtime/closed_loops.hpp"

namespace consistent_state_test {
namespace {

using namespace torsor::runtime;
using Pendulum = mechanisms::CartesianPendulum<double>;
using FourBar = mechanisms::CrankLoop<mechanisms::FourBar>;
using ThreeCranks = mechanisms::CrankLoop<mechanisms::ThreeEqualCranksSmallSwing>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The other crank and the coupler of the four-bar for an angle of the first crank, by the cosine rule.
std::array<double, 3> four_bar(double theta) {
  const double x = 0.3 * std::sin(theta), y = -0.3 * std::cos(theta), dx = 1 - x, dy = -y;
  const double d = std::sqrt(dx * dx + dy * dy);
  const double psi = std::atan2(dy, dx) - std::acos((0.81 + d * d - 0.64) / (2 * 0.9 * d));
  return {theta, std::atan2(x + 0.9 * std::cos(psi) - 1, -y - 0.9 * std::sin(psi)), psi};
}

TEST(ConsistentState, FindsTheRestFromOneFixedCrank) {
  StateWishes<FourBar> wishes;
  wishes.position_fixed[0] = wishes.velocity_fixed[0] = true;
  const auto near = four_bar(1.0);
  StateVector<FourBar> y{1.3, near[1], near[2], 2.0, 0.0, 0.0};
  const auto found = find_consistent_state<FourBar>(FourBar::precompute({}), 0.0, y, wishes);
  ASSERT_TRUE(found) << describe(found);
  const auto exact = four_bar(1.3), up = four_bar(1.3 + 1e-5), down = four_bar(1.3 - 1e-5);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(y[i], exact[i], 16 * epsilon);
    EXPECT_NEAR(y[3 + i], 2.0 * (up[i] - down[i]) / 2e-5, 1e-9);  // rounding of the difference quotient, and its h²
  }
  EXPECT_EQ(y[0], 1.3);
  EXPECT_EQ(y[3], 2.0);
  EXPECT_EQ(found.free_positions, 0);
  EXPECT_EQ(found.free_velocities, 0);
}

TEST(ConsistentState, ClosesTheLoopWhateverTheSpeed) {
  // Turning at 1e6 rad/s and open by 1e-11: positions are found as exactly as at rest.
  StateWishes<FourBar> wishes;
  wishes.position_fixed[0] = wishes.velocity_fixed[0] = true;
  const auto exact = four_bar(1.3);
  StateVector<FourBar> y{1.3, exact[1] + 1e-11, exact[2], 1e6, 0.0, 0.0};
  const auto found = find_consistent_state<FourBar>(FourBar::precompute({}), 0.0, y, wishes);
  ASSERT_TRUE(found) << describe(found);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(y[i], exact[i], 16 * epsilon);
  EXPECT_EQ(y[3], 1e6);
}

TEST(ConsistentState, SaysWhichFixedValuesConflictAndByHowMuch) {
  // Both cranks fixed so that their ends are d apart, the coupler is 0.9: at best it points from one to the other.
  StateWishes<FourBar> wishes;
  wishes.position_fixed[0] = wishes.position_fixed[1] = true;
  const StateVector<FourBar> start{1.0, 0.2, 0.1, 0.0, 0.0, 0.0};
  StateVector<FourBar> y = start;
  const auto found = find_consistent_state<FourBar>(FourBar::precompute({}), 0.0, y, wishes);
  EXPECT_EQ(found.status, ConsistencyStatus::positions_conflict);
  EXPECT_EQ(y, start);
  const double dx = 1 + 0.8 * std::sin(0.2) - 0.3 * std::sin(1.0), dy = -0.8 * std::cos(0.2) + 0.3 * std::cos(1.0);
  // What is left is d - 0.9 e(ψ), so that ψ is known from it. Nothing is nearer than the distance allows; and the sum of
  // squares, each row over its size Σ |A_ij| there, is least: no other ψ has less.
  const double left = std::hypot(found.left[0], found.left[1]), nearest = std::abs(std::hypot(dx, dy) - 0.9);
  EXPECT_GE(left, nearest - 16 * epsilon);
  const double psi = std::atan2(found.left[1] + dy, found.left[0] + dx);
  EXPECT_NEAR(std::hypot(found.left[1] + dy, found.left[0] + dx), 0.9, 16 * epsilon);
  const double row_x = 0.3 * std::cos(1.0) + 0.8 * std::cos(0.2) + 0.9 * std::abs(std::sin(psi));
  const double row_y = 0.3 * std::sin(1.0) + 0.8 * std::sin(0.2) + 0.9 * std::abs(std::cos(psi));
  EXPECT_LE(left, nearest * std::max(row_x / row_y, row_y / row_x) * (1 + 1e-9));
  EXPECT_EQ(found.position_involved, (std::array<bool, 3>{true, true, false}));
  EXPECT_NE(describe(found).find("let go of a fixed position among 0, 1"), std::string::npos) << describe(found);
}

TEST(ConsistentState, SaysWhichFixedVelocitiesConflict) {
  StateWishes<Pendulum> wishes;
  wishes.velocity_fixed = {true, true};
  StateVector<Pendulum> y{0.6, -0.8, 1.0, 1.0};
  const auto found = find_consistent_state<Pendulum>(Pendulum::precompute({}), 0.0, y, wishes);
  EXPECT_EQ(found.status, ConsistencyStatus::velocities_conflict);
  EXPECT_EQ(found.constraint, 0);
  EXPECT_NEAR(found.left[0], 0.6 - 0.8, 4 * epsilon);
  EXPECT_EQ(found.velocity_involved, (std::array<bool, 2>{true, true}));
  wishes.velocity_fixed[1] = false;
  ASSERT_TRUE(find_consistent_state<Pendulum>(Pendulum::precompute({}), 0.0, y, wishes));
  EXPECT_EQ(y[2], 1.0);
  EXPECT_NEAR(y[3], 0.75, 4 * epsilon);
}

TEST(ConsistentState, IsTheNearestByTheWeights) {
  // From (2, 1) to the unit circle with weights 1 and 3: (x - 2, 9 (y - 1)) is along the gradient (x, y).
  StateWishes<Pendulum> wishes;
  wishes.position_weight = {1.0, 3.0};
  StateVector<Pendulum> y{2.0, 1.0, 0.0, 0.0};
  const auto found = find_consistent_state<Pendulum>(Pendulum::precompute({}), 0.0, y, wishes);
  ASSERT_TRUE(found) << describe(found);
  EXPECT_NEAR(y[0] * y[0] + y[1] * y[1], 1.0, 4 * epsilon);
  // Found to the square root of rounding: the sum of squares is least there.
  EXPECT_NEAR((y[0] - 2) * y[1] - 9 * (y[1] - 1) * y[0], 0.0, 1e-6);
  EXPECT_EQ(found.free_positions, 1);
  EXPECT_EQ(found.free_velocities, 1);
}

// At (0.6, -0.8) velocities along (0.6, -0.8) are taken away: from (1, 0) with weights 1 and 3, least Σ (w δv)², the
// change is -0.6 (0.6, -0.8/9)/(0.36 + 0.64/9).
TEST(ConsistentState, HasTheNearestVelocitiesByTheWeights) {
  StateWishes<Pendulum> wishes;
  wishes.velocity_weight = {1.0, 3.0};
  StateVector<Pendulum> y{0.6, -0.8, 1.0, 0.0};
  ASSERT_TRUE(find_consistent_state<Pendulum>(Pendulum::precompute({}), 0.0, y, wishes));
  const double share = -0.6 / (0.36 + 0.64 / 9);
  EXPECT_NEAR(y[2], 1.0 + share * 0.6, 16 * epsilon);
  EXPECT_NEAR(y[3], -share * 0.8 / 9, 16 * epsilon);
}

TEST(ConsistentState, CountsRedundantConstraintsOnce) {
  StateWishes<ThreeCranks> wishes;
  wishes.position_fixed[1] = true;
  StateVector<ThreeCranks> y{0.9, 1.0, 1.2, 0.05, 0.3, 0.0, 0.0, 0.0};
  const auto found = find_consistent_state<ThreeCranks>(ThreeCranks::precompute({}), 0.0, y, wishes);
  ASSERT_TRUE(found) << describe(found);
  EXPECT_EQ(found.free_positions, 0);
  EXPECT_EQ(found.free_velocities, 1);
  // Closed to rounding; 1/cos of an angle of 1 rad magnifies by two.
  for (const std::size_t k : {0U, 1U, 2U}) EXPECT_NEAR(y[k], 1.0, 16 * epsilon);
  EXPECT_NEAR(y[3], 0.0, 16 * epsilon);
}

TEST(ConsistentState, ReportsWhatIsNoNumber) {
  StateVector<Pendulum> y{std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0, 0.0};
  EXPECT_EQ(find_consistent_state<Pendulum>(Pendulum::precompute({}), 0.0, y).status, ConsistencyStatus::not_finite);
}

/// Eight angles: the last turns twice as fast as the first, which with the second makes up 1 rad.
struct GearAndLink : mechanisms::ContractOf<double, 8, 2> {
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c = {};
    c.value = {2.0 * s.q[0] - s.q[7], s.q[0] + s.q[1] - 1.0};
    c.rate = {2.0 * s.v[0] - s.v[7], s.v[0] + s.v[1]};
    c.jacobian[0] = 2.0;
    c.jacobian[1] = c.jacobian[3] = 1.0;
    c.jacobian[14] = -1.0;
  }
};

// From zero the gear holds as it is, and any step whose parts have its ratio leaves it so: it is a constraint all the same.
TEST(ConsistentState, KnowsAGearOfAnyRatioForAConstraintOfPositions) {
  StateVector<GearAndLink> y{};
  const auto found = find_consistent_state<GearAndLink>(GearAndLink::precompute({}), 0.0, y);
  ASSERT_TRUE(found) << describe(found);
  EXPECT_EQ(found.free_positions, 6);
  EXPECT_NEAR(y[0], 1.0 / 6.0, 4 * epsilon);  // nearest to zero: a + 4 a = 1 - a
  EXPECT_NEAR(y[1], 5.0 / 6.0, 4 * epsilon);
  EXPECT_NEAR(y[7], 1.0 / 3.0, 4 * epsilon);
}

// A start off the circle is put on it along the ray from the centre, as one of other parameters may have to be: the motion is that
// from there, to some roundings of the start that grow by less than ten within 0.2 s.
TEST(ConsistentState, IsWhereMembersOfAnEnsembleStart) {
  const auto members = [](std::uint64_t index) {
    Member<Pendulum> member;
    if (index == 1) member.state.q[0] = -1.5;
    return member;
  };
  const auto ensemble =
      motion_ensemble<Pendulum>({.count = 2, .times = {0.0, 0.2}}, members, RungeKutta4{.step = 0.01});
  const auto motion = [&ensemble](std::uint64_t index) {
    std::vector<double> record(ensemble.head().numbers);
    ensemble(index, record);
    return member_motion<Pendulum>(std::span<const double>(record));
  };
  const auto closed = motion(0), open = motion(1);
  ASSERT_EQ(open.states.size(), 2U);
  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(open.states[time][i], closed.states[time][i], 1e-14) << time << i;
  }
}

}  // namespace
}  // namespace consistent_state_test
