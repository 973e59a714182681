// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of closed loops that repeat each other in a way that changes along the motion.
#include "torsor/generator/dynamics/equations/row_choice.hpp"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "tests/dynamics/constrained_motion.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bricard.hpp"

namespace torsor::row_choice_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using Indices = std::vector<std::size_t>;

/// Three directions in a plane, the second of which turns: along the first, or against it, it adds nothing to it.
std::vector<RowsHere> turning_row() {
  std::vector<RowsHere> configurations;
  for (int k = 0; k < 63; ++k) configurations.push_back({{1, 0}, {std::cos(0.1 * k + 0.5), std::sin(0.1 * k + 0.5)}, {0, 1}});
  return configurations;
}

TEST(RowChoice, KeepsRowsThatCountEverywhere) {
  const RowChoice choice = choose_rows(turning_row(), {0, 1});
  EXPECT_EQ(choice.kept, (Indices{0, 2}));
  EXPECT_NEAR(choice.least_share, std::sqrt(0.5), 1e-14);  // C = (cos, sin), of length 1
}

TEST(RowChoice, ChangesNothingWhereTheRowsGivenDo) {
  std::vector<RowsHere> configurations = turning_row();
  for (RowsHere& rows : configurations) rows[1] = {2 * rows[1][0], 3 + rows[1][1]};
  EXPECT_EQ(choose_rows(configurations, {0, 1}).kept, (Indices{0, 1}));
}

// Two planes, each with three rows, as two loops of one scene: each is seen to by itself.
TEST(RowChoice, LooksAtEachLoopByItself) {
  std::vector<RowsHere> two;
  for (const RowsHere& rows : turning_row()) {
    RowsHere both(6, std::vector<double>(4, 0.0));
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 2; ++i) both[j][i] = both[5 - j][2 + i] = rows[j][i];
    }
    two.push_back(std::move(both));
  }
  const RowChoice choice = choose_rows(two, {0, 1, 3, 4});
  EXPECT_EQ(choice.kept, (Indices{0, 2, 3, 5}));
  EXPECT_GT(choice.least_share, 0.7);
}

// At θ = 0 one row after another is a combination of four others, and the six have rank five as everywhere.
TEST(RowChoice, FindsTheAccelerationsOfBricardsLinkageWhereARowStopsCounting) {
  const WorkingDigits precision(60);
  SixLinks aslant = threefold_links();
  aslant.gravity = {quantity("3", "m/s^2"), quantity("2", "m/s^2"), quantity("-9", "m/s^2")};
  const Equations equations(ring_of_six(aslant));
  const ConstraintRank& rank = equations.redundancy();
  ASSERT_EQ(rank.dropped.size(), 1U);
  EXPECT_EQ(equations.constraints()[rank.dropped.front()].name, "close_rx");
  EXPECT_GT(rank.least_share, 0.2);
  EXPECT_FALSE(rank.loses_rank());
  const std::vector<std::string> sentences = notes(rank, equations.scene());
  EXPECT_EQ(sentences.front(), "Constraints that repeat others are left out, their multipliers are 0: close_rx.");

  const ConstrainedMotion motion(equations);
  const Real phi = -Real(2) * Real::pi() / Real(3), fast(-8), none(0);
  const ConstrainedMotion::State state{{none, phi, none, phi, none, phi}, {fast, none, fast, none, fast, none}, {}};
  Evaluator<Real> here = motion.at(state);
  const std::vector<Real> a = here(equations.forward().accelerations);
  for (const ConstraintRow& row : equations.constraints()) {
    EXPECT_LT(abs(here(row.value)).to_double(), 1e-45) << row.name;
    Real sum = here(row.gamma);
    for (std::size_t i = 0; i < 6; ++i) sum += here(row.jacobian[i]) * a[i];
    EXPECT_LT(abs(sum).to_double(), 1e-45) << row.name;
  }
  // The one motion that is left turns the three at 0 alike, and the others not: what is not forces of constraints has no power.
  Evaluator<Real> moved = motion.at(state, a, std::vector<Real>(6, none));
  Real power(0), size(0);
  for (std::size_t i = 0; i < 6; i += 2) {
    const Real force = moved(equations.inverse_dynamics()[i]);
    power += force;
    size += abs(force);
  }
  EXPECT_LT(abs(power).to_double(), 1e-45);
  EXPECT_GT(size.to_double(), 1);
}

/// A plate on four feet on a plane; one of them moves along by a law, and passes another after half a second.
Scene four_feet(const std::vector<std::string>& order) {
  Scene scene("feet");
  std::array<Expression, 3> place, angle;
  for (std::size_t i = 0; i < 3; ++i) place[i] = scene.coordinate("x" + std::to_string(i), "m");
  for (std::size_t i = 0; i < 3; ++i) angle[i] = scene.coordinate("a" + std::to_string(i), "rad");
  const FrameHandle plate = scene.free("plate", scene.ground(), {place[0], place[1], place[2]},
                                       {.sequence = AngleSequence{{0, 1, 2}}, .angles = {angle[0], angle[1], angle[2]}});
  scene.body("plate", plate, Inertia::box(quantity("2", "kg"), metres("1"), metres("1"), metres("0.1")));
  const Expression u = scene.coordinate("u", "m");
  scene.drive(u, quantity("1", "m/s") * scene.time() - metres("0.5"));
  const FrameHandle slider = scene.prismatic("slider", plate, axis::x, u);
  const std::map<std::string, PointHandle> feet{{"A", scene.point("A", plate, {0, 0, 0})},
                                                {"B", scene.point("B", plate, {metres("1"), metres("1"), 0})},
                                                {"C", scene.point("C", slider, {0, 0, 0})},
                                                {"D", scene.point("D", plate, {0, metres("1"), 0})}};
  for (const std::string& name : order) scene.point_in_plane("on_" + name, feet.at(name), scene.ground());
  scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
  return scene;
}

// What repeats others may change with the time as well.
TEST(RowChoice, LooksAtLaterTimes) {
  const std::vector<std::vector<std::string>> orders{{"A", "B", "C", "D"}, {"A", "C", "B", "D"}, {"D", "B", "C", "A"}};
  for (const std::vector<std::string>& order : orders) {
    const Scene scene = four_feet(order);
    const ConstraintRank rank = constraint_rank(scene);
    ASSERT_EQ(rank.dropped.size(), 1U);
    const std::string dropped = scene.content().constraints[rank.dropped.front()].name;
    EXPECT_TRUE(dropped == "on_A" || dropped == "on_C") << dropped;
    EXPECT_FALSE(rank.loses_rank());
  }
}

// Of a trihedral linkage each row that counts at all is implied somewhere.
TEST(RowChoice, TellsOfALinkageWhereNoChoiceHolds) {
  const Scene scene = trihedral_linkage();
  const ConstraintRank rank = constraint_rank(scene);
  EXPECT_EQ(rank.dropped.size(), 1U);
  EXPECT_TRUE(rank.loses_rank()) << rank.least_share;
  EXPECT_EQ(notes(rank, scene).at(1),
            "Those kept lose rank at places of the motion where one left out counts; these are no change points, and accelerations "
            "lose digits near them.");
}

}  // namespace
}  // namespace torsor::row_choice_test
