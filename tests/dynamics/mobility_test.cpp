// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/mobility.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "torsor/generator/dynamics/structure/joint_space.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::mobility_test {
namespace {

using namespace testing_mechanisms;

struct Expected {
  int bodies, joints, loops, parameters, rank, mobility, redundancy;
};

void expect(const MobilityCount& count, const Expected& expected) {
  EXPECT_EQ(count.bodies, expected.bodies);
  EXPECT_EQ(count.joints, expected.joints);
  EXPECT_EQ(count.loops, expected.loops);
  EXPECT_EQ(count.parameters, expected.parameters);
  EXPECT_EQ(count.equations, 6 * expected.loops);
  EXPECT_EQ(count.rank, expected.rank);
  EXPECT_EQ(count.mobility, expected.mobility);
  EXPECT_EQ(count.redundancy, expected.redundancy);
}

std::vector<std::string> components(const Mobility& mobility, const std::string& joint) {
  for (const IndeterminateReaction& each : mobility.indeterminate) {
    if (each.joint == joint) return each.components;
  }
  return {};
}

using Names = std::vector<std::string>;

// Three of six equations say again that the mechanism is plane.
TEST(Mobility, OfThePlaneFourBarIsOneWithThreeRedundantEquations) {
  const Scene scene = four_links({.crank = 1, .coupler = 3, .rocker = 2, .ground = 3}, {0.5, 0.4, 1.9});
  const Mobility mobility = analyse_mobility(scene);
  EXPECT_TRUE(mobility.moved_to_close);
  EXPECT_FALSE(mobility.singular);
  expect(mobility.given, {4, 4, 1, 4, 3, 1, 3});
  expect(mobility.generic, {4, 4, 1, 4, 3, 1, 3});
  EXPECT_EQ(mobility.given.internal, 0);
  for (const char* joint : {"crank", "coupler", "rocker"}) {
    EXPECT_EQ(components(mobility, joint), (Names{"F_z", "M_x", "M_y"})) << joint;
  }
  EXPECT_EQ(components(mobility, "knee"), (Names{"F_x", "M_y", "M_z"}));  // its axis x lies along z
  EXPECT_EQ(mobility.redundant, (Names{"loop 1: Omega_x", "loop 1: Omega_y", "loop 1: V_z"}));
}

// Three carts on one rail, each welded to each other: they move as one. In each loop one cart is passed with the rail
// and one against it, and no sense can be left out: with all of them forward nothing would move.
TEST(Mobility, OfCartsWeldedToEachOtherIsThatOfOneCart) {
  Scene scene("train");
  std::vector<FrameHandle> carts;
  for (const char* name : {"a", "b", "c"}) {
    carts.push_back(scene.prismatic(name, scene.ground(), axis::x, scene.coordinate("x_" + std::string(name), "m")));
    scene.body(name, carts.back(), Inertia::point(Expression::quantity("1", "kg")));
  }
  scene.loop_joint("ab", {.type = JointType::weld, .a = carts[0], .b = carts[1]});
  scene.loop_joint("ac", {.type = JointType::weld, .a = carts[0], .b = carts[2]});
  scene.loop_joint("bc", {.type = JointType::weld, .a = carts[1], .b = carts[2]});
  const Mobility mobility = analyse_mobility(scene);
  expect(mobility.given, {4, 6, 3, 3, 2, 1, 16});
}

// A door on two balls, off the ground's origin: what equilibrium leaves open is the force from ball to ball, and no moment
// at either of them.
TEST(Mobility, OfADoorOnTwoBallsLeavesOneForceOpen) {
  Scene scene("door");
  const FrameHandle door = scene.spherical("low", scene.ground(), scene.attitude("e"), {{metres("1"), 0, 0}, {}});
  const FrameHandle top = scene.weld("top", door, {{0, metres("2"), 0}, {}});
  const FrameHandle frame = scene.weld("frame", scene.ground(), {{metres("1"), metres("2"), 0}, {}});
  scene.loop_joint("high", {.type = JointType::spherical, .a = frame, .b = top});
  const Mobility mobility = analyse_mobility(scene);
  expect(mobility.given, {2, 2, 1, 6, 5, 1, 1});
  for (const char* joint : {"low", "high"}) EXPECT_EQ(components(mobility, joint), (Names{"F_y"})) << joint;
}

// A rod that its attitude turns from x to y ends where a second ball holds it: nothing is moved to close the loop.
TEST(Mobility, TakesAnAttitudeAsTheSceneStarts) {
  Scene scene("rod");
  const AttitudeHandle e = scene.attitude("e");
  scene.initial(e, {1, 0, 0, 1});  // a quarter turn about z
  const FrameHandle rod = scene.spherical("rod", scene.ground(), e);
  const FrameHandle end = scene.weld("end", rod, {{metres("1"), 0, 0}, {}});
  const FrameHandle wall = scene.weld("wall", scene.ground(), {{0, metres("1"), 0}, {}});
  scene.loop_joint("ball", {.type = JointType::spherical, .a = wall, .b = end});
  const Mobility mobility = analyse_mobility(scene);
  EXPECT_FALSE(mobility.moved_to_close);
  expect(mobility.given, {2, 2, 1, 6, 5, 1, 1});
}

// All links on one line: a parallelogram may leave that position as one, or crossed.
TEST(Mobility, OfAFlatParallelogramIsSingular) {
  const Mobility mobility =
      analyse_mobility(four_links({.crank = 1, .coupler = 2, .rocker = 1, .ground = 2}, {0, 0, 0}));
  EXPECT_FALSE(mobility.moved_to_close);
  EXPECT_TRUE(mobility.singular);
  expect(mobility.given, {4, 4, 1, 4, 2, 2, 4});
  expect(mobility.generic, {4, 4, 1, 4, 3, 1, 3});
}

// 1 + 2 = 3: the links reach just so far, and what turns infinitesimally cannot turn further.
TEST(Mobility, OfLinksThatOnlyJustReachIsInfinitesimal) {
  const Mobility mobility =
      analyse_mobility(four_links({.crank = 1, .coupler = 1, .rocker = 1, .ground = 3}, {0, 0, pi()}));
  expect(mobility.given, {4, 4, 1, 4, 2, 2, 4});
  EXPECT_TRUE(mobility.immobile);
}

TEST(Mobility, OfBennettsLinkageIsOneAgainstTheCount) {
  const Mobility mobility = analyse_mobility(bennett());
  EXPECT_FALSE(mobility.moved_to_close);
  EXPECT_FALSE(mobility.singular);
  expect(mobility.generic, {4, 4, 1, 4, 3, 1, 3});
}

TEST(Mobility, OfSarrusLinkageIsOneAlthoughSixRevoluteJointsLeaveNoneByCounting) {
  const Mobility mobility = analyse_mobility(sarrus());
  EXPECT_FALSE(mobility.moved_to_close);
  EXPECT_FALSE(mobility.singular);
  expect(mobility.generic, {6, 6, 1, 6, 5, 1, 1});
  // The two directions of turning, x and y, leave out z: the couple M_z runs around the loop.
  EXPECT_EQ(mobility.redundant, (Names{"loop 1: Omega_z"}));
  EXPECT_EQ(components(mobility, "hinge"), (Names{"M_z"}));
}

TEST(Mobility, OfTheIsostaticSliderCrankLeavesNothingUndetermined) {
  const Mobility mobility = analyse_mobility(isostatic_slider_crank());
  EXPECT_TRUE(mobility.moved_to_close);
  expect(mobility.given, {4, 4, 1, 7, 6, 1, 0});
  EXPECT_FALSE(mobility.singular);
  EXPECT_TRUE(mobility.indeterminate.empty());
  EXPECT_TRUE(mobility.redundant.empty());
}

TEST(Mobility, OfTheAbsorberIsThreeOfWhichOneIsDriven) {
  const Scene scene = absorber();
  const Mobility mobility = analyse_mobility(scene);
  expect(mobility.generic, {4, 3, 0, 3, 0, 3, 0});
  const SceneFreedoms freedoms = scene_freedoms(scene);
  EXPECT_EQ(freedoms.coordinates, 2);
  EXPECT_EQ(freedoms.driven, 1);
}

// With input and output named, the pendulum alone is internal.
TEST(Mobility, IsUsefulWhereTheNamedJointsAre) {
  MobilityOptions options;
  options.inputs_outputs = {"support", "rotor"};
  const Mobility mobility = analyse_mobility(absorber(), options);
  EXPECT_EQ(mobility.generic.useful, 2);
  EXPECT_EQ(mobility.generic.internal, 1);
  ASSERT_EQ(mobility.internal.size(), 1U);
  EXPECT_EQ(mobility.internal[0].bodies, (Names{"pendulum"}));
  EXPECT_EQ(mobility.internal[0].text, "turns about y");
  EXPECT_EQ(mobility.internal_freedoms, (Names{"pendulum: turn about y"}));
  options.inputs_outputs = {"wheel"};
  EXPECT_THROW(analyse_mobility(absorber(), options), UsageError);
}

// An arm of two: blocked at the ground, the upper body turns alone, and both turn together about the lower joint.
TEST(Mobility, TellsMotionsOfOneBodyFromThoseOfSeveral) {
  Scene scene("arm");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), d = scene.coordinate("d", "rad");
  const FrameHandle base = scene.revolute("base", scene.ground(), axis::z, a);
  const FrameHandle lower = scene.revolute("lower", base, axis::x, b, {{0, 0, metres("1")}, {}});
  scene.revolute("upper", lower, axis::x, d, {{0, 0, metres("1")}, {}});
  const Mobility mobility = analyse_mobility(scene);
  EXPECT_EQ(mobility.given.internal, 2);
  ASSERT_EQ(mobility.internal.size(), 2U);
  EXPECT_EQ(mobility.internal[0].bodies, (Names{"upper"}));
  EXPECT_EQ(mobility.internal[0].text, "turns about x");
  EXPECT_EQ(mobility.internal[1].bodies, (Names{"lower", "upper"}));
  EXPECT_EQ(mobility.internal[1].text, "move together");
}

// The same number by another derivation: rank of the constraints' Jacobian, which is derived from the closures as functions
// of the coordinates, instead of twists around loops.
TEST(Mobility, IsWhatTheConstraintsOfTheSceneLeave) {
  for (const Scene& scene :
       {four_links({.crank = 1, .coupler = 2, .rocker = 1, .ground = 2}, {0, 0, 0}), bennett(), bennett_in_digits(),
        sarrus()}) {
    const SceneFreedoms freedoms = scene_freedoms(scene, {}, constraint_rank(scene).rank_at_start);
    EXPECT_EQ(freedoms.freedoms(), analyse_mobility(scene).given.mobility) << scene.name();
  }
}

TEST(Mobility, RefusesLoopsThatCannotBeClosed) {
  const Scene scene = four_links({.crank = 1, .coupler = 1, .rocker = 1, .ground = 9}, {0.5, 0.4, 1.9});
  EXPECT_THROW(analyse_mobility(scene), SceneError);
}

TEST(DirectionText, ShowsWhatDecimalsOfAFileLeaveOfAZeroAsZero) {
  const auto text = [](double x, double y, double z) {
    return direction_text({Real::from_double(x), Real::from_double(y), Real::from_double(z)});
  };
  EXPECT_EQ(text(2.2e-18, 1, 0), "y");
  EXPECT_EQ(text(-8.5e-17, 0.6, 0.8), "(0, 0.6, 0.8)");
  EXPECT_EQ(text(-8.5e-17, -0.6, 0.8), "(0, 0.6, -0.8)");
  EXPECT_EQ(text(0.001, -1, 0), "(0.001, -1, 0)");
}

}  // namespace
}  // namespace torsor::mobility_test
