// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/structure/reduced_graph.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/joint_screws.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::reduced_graph_test {
namespace {

using namespace testing_mechanisms;

Real rational(long numerator, long denominator) { return Real(Number::rational(numerator, denominator), 50); }

/// Twists of a joint of the table whose axes a are turned in some way and whose point is somewhere.
RealRows twists_of(JointType type, const RealRotation& turned, const RealVector& point) {
  PlacedJoint<RealVector, Real> joint;
  for (int i = 0; i < 3; ++i) joint.a[static_cast<std::size_t>(i)] = column(turned, i);
  joint.b = joint.a;
  joint.point = point;
  joint.pitch = rational(1, 10);
  RealRows rows;
  for (const JointFreedom& freedom : freedoms(type)) {
    const auto [angular, linear] = twist_of(freedom, joint);
    rows.push_back({angular[0], angular[1], angular[2], linear[0], linear[1], linear[2]});
  }
  return rows;
}

class TwistSpace : public ::testing::Test {
 protected:
  RealRows at(JointType type) const { return twists_of(type, turned, point); }
  RealRows at(JointType type, const RealVector& other) const { return twists_of(type, turned, other); }
  RealVector from_point(long x, long y, long z) const {  // along the joints' axes
    using torsor::operator+;  // other tests that are compiled together have one for the same arrays
    return point + turned * RealVector{rational(x, 4), rational(y, 4), rational(z, 4)};
  }

  WorkingDigits precision{50};
  RealRotation turned = rotation_by({rational(1, 3), rational(-2, 5), rational(1, 2)});
  RealVector point{rational(1, 3), rational(-1, 2), rational(2, 7)};
};

TEST_F(TwistSpace, OfEveryJointIsRecognisedWhereverItIs) {
  for (int k = 0; k < 12; ++k) {
    const auto type = static_cast<JointType>(k);
    const TwistClass found = recognise_twists(at(type));
    EXPECT_EQ(found.freedoms, freedom_count(type));
    ASSERT_TRUE(found.type) << to_string(type);
    EXPECT_EQ(*found.type, type) << to_string(type) << " taken for " << to_string(*found.type);
  }
}

// The direction is that of the table, and the point is the centre, or lies on the axis or on the line of contact.
TEST_F(TwistSpace, LiesWhereItsJointWasPlaced) {
  for (const JointType type : {JointType::revolute, JointType::prismatic, JointType::helical, JointType::cylindrical,
                               JointType::universal, JointType::spherical, JointType::planar, JointType::line_contact,
                               JointType::sphere_in_cylinder, JointType::point_contact}) {
    SCOPED_TRACE(std::string(to_string(type)));
    const TwistClass found = recognise_twists(at(type));
    const bool across = type == JointType::universal || type == JointType::planar || type == JointType::line_contact ||
                        type == JointType::point_contact;
    ASSERT_EQ(found.direction.has_value(), type != JointType::spherical);
    if (found.direction) {
      EXPECT_TRUE(is_small(norm(cross(*found.direction, column(turned, across ? 2 : 0)))));
    }
    const bool nowhere = type == JointType::prismatic || type == JointType::planar || type == JointType::line_contact;
    ASSERT_EQ(found.point.has_value(), !nowhere);
    if (nowhere) continue;
    using torsor::operator-;
    const RealVector off = *found.point - point;
    const bool centre =
        type == JointType::universal || type == JointType::spherical || type == JointType::sphere_in_cylinder;
    EXPECT_TRUE(is_small(centre ? norm(off) : norm(cross(off, *found.direction))));
  }
}

TEST_F(TwistSpace, IsReciprocalToItsIdealWrenches) {
  for (int k = 0; k < 12; ++k) {
    const RealRows twists = at(static_cast<JointType>(k));
    const RealRows wrenches = reciprocal_to(twists);
    EXPECT_EQ(twists.size() + wrenches.size(), 6U);
    for (const RealRow& t : twists) {
      for (const RealRow& w : wrenches) {
        Real power;
        for (std::size_t i = 0; i < 3; ++i) power += w[i] * t[i + 3] + w[i + 3] * t[i];
        EXPECT_LE(abs(power), rational(1, 1000000) * rational(1, 1000000));
      }
    }
  }
}

// Joints of the course's list (§3.5.4 and §3.5.5) and other known ones, in parallel: what both allow.
TEST_F(TwistSpace, OfParallelJointsIsWhatBothAllow) {
  const auto parallel = [this](JointType one, JointType other, const RealVector& there) {
    return recognise_twists(intersection_of(at(one), at(other, there))).type;
  };
  EXPECT_EQ(parallel(JointType::cylindrical, JointType::cylindrical, from_point(0, 3, 0)), JointType::prismatic);
  EXPECT_EQ(parallel(JointType::revolute, JointType::revolute, from_point(0, 3, 0)), JointType::weld);
  EXPECT_EQ(parallel(JointType::revolute, JointType::revolute, from_point(5, 0, 0)), JointType::revolute);
  EXPECT_EQ(parallel(JointType::spherical, JointType::spherical, from_point(2, 0, 0)), JointType::revolute);
  EXPECT_EQ(parallel(JointType::spherical, JointType::point_contact, point), JointType::spherical);
  EXPECT_EQ(parallel(JointType::spherical, JointType::sphere_in_cylinder, from_point(3, 0, 0)), JointType::revolute);
  EXPECT_EQ(parallel(JointType::point_contact, JointType::point_contact, from_point(1, 0, 0)), JointType::line_contact);
  EXPECT_EQ(parallel(JointType::sphere_in_cylinder, JointType::sphere_in_cylinder, from_point(3, 0, 0)),
            JointType::cylindrical);
  // A third point off the line of the two others: a plane rests on three points.
  const RealRows line =
      intersection_of(at(JointType::point_contact), at(JointType::point_contact, from_point(1, 0, 0)));
  EXPECT_EQ(recognise_twists(intersection_of(line, at(JointType::point_contact, from_point(0, 1, 0)))).type,
            JointType::planar);
}

TEST_F(TwistSpace, OfJointsInSeriesIsTheirSum) {
  const auto series = [this](JointType one, JointType other, const RealVector& there) {
    return recognise_twists(span_of(at(one), at(other, there)));
  };
  EXPECT_EQ(series(JointType::spherical, JointType::planar, from_point(1, 2, 0)).type, JointType::point_contact);
  EXPECT_EQ(series(JointType::revolute, JointType::prismatic, from_point(0, 3, 1)).type, JointType::cylindrical);
  EXPECT_EQ(series(JointType::spherical, JointType::prismatic, point).type, JointType::sphere_in_cylinder);
  EXPECT_EQ(series(JointType::cylindrical, JointType::planar, point).type, JointType::line_contact);
  // Two parallel axes: a turn, and a translation across it that no joint of the table has with it.
  const TwistClass two = series(JointType::revolute, JointType::revolute, from_point(0, 3, 0));
  EXPECT_EQ(two.freedoms, 2);
  EXPECT_FALSE(two.type);
  EXPECT_EQ(two.text(), "2 freedoms, no joint of the table");
}

// Two hinges about one axis in series turn as one, and the body between them turns alone; beside a ball on that axis
// the two of them leave a hinge, and three equations say what others say: 3 + 1 freedoms span 3 of 6 dimensions.
TEST_F(TwistSpace, OfMergedJointsSaysWhatDisappears) {
  const auto edge = [this](const char* name, int a, int b, JointType type) {
    const RealRows twists = at(type);
    return TwistEdge{name, a, b, false, {twists, std::vector<std::string>(twists.size())}};
  };
  const ReducedGraph reduced =
      reduce({"ground", "sleeve", "shaft"}, {edge("first", 0, 1, JointType::revolute), edge("second", 1, 2, JointType::revolute),
                                             edge("ball", 2, 0, JointType::spherical)});
  ASSERT_EQ(reduced.steps.size(), 2U);
  EXPECT_EQ(reduced.steps[0].internal, 1);
  EXPECT_EQ(reduced.steps[0].redundant, 0);
  EXPECT_EQ(reduced.steps[1].internal, 0);
  EXPECT_EQ(reduced.steps[1].redundant, 3);
  ASSERT_EQ(reduced.joints.size(), 1U);
  EXPECT_EQ(reduced.joints[0].allows.type, JointType::revolute);
  EXPECT_EQ(reduced.count.mobility, 1);
  EXPECT_EQ(reduced.count.redundancy, 0);
}

// The coupler has two joints in series; crank and rocker keep theirs with the ground.
TEST(ReducedGraph, KeepsTheJointsWithTheOutside) {
  const Mobility mobility =
      analyse_mobility(four_links({.crank = 1, .coupler = 3, .rocker = 2, .ground = 3}, {0.5, 0.4, 1.9}));
  const ReducedGraph reduced = reduced_graph(mobility);
  EXPECT_EQ(reduced.bodies, (std::vector<std::string>{"ground", "crank", "rocker"}));
  ASSERT_EQ(reduced.joints.size(), 3U);
  EXPECT_EQ(reduced.joints[1].edge.name, "coupler-knee");
  EXPECT_EQ(reduced.joints[1].allows.freedoms, 2);
  EXPECT_EQ(reduced.count.mobility, mobility.given.mobility);
  ASSERT_EQ(reduced.steps.size(), 1U);
  EXPECT_EQ(reduced.steps[0].internal, 0);
}

TEST(ReducedGraph, LeavesAnOpenChainAsItIs) {
  const ReducedGraph reduced = reduced_graph(analyse_mobility(absorber()));
  EXPECT_TRUE(reduced.steps.empty());
  EXPECT_EQ(reduced.joints.size(), 3U);
}

// Every merger accounts for what it drops: mobility by internal freedoms, redundancy by equations.
TEST(ReducedGraph, AccountsForWhatItDrops) {
  for (const Scene& scene : {four_links({.crank = 1, .coupler = 3, .rocker = 2, .ground = 3}, {0.5, 0.4, 1.9}),
                             // flat at the start, where the rank is another one
                             four_links({.crank = 1, .coupler = 2, .rocker = 1, .ground = 2}, {0, 0, 0}),
                             bennett(), sarrus(), isostatic_slider_crank()}) {
    const Mobility mobility = analyse_mobility(scene);
    const ReducedGraph reduced = reduced_graph(mobility);
    int internal = 0, redundant = 0;
    for (const ReductionStep& step : reduced.steps) internal += step.internal, redundant += step.redundant;
    EXPECT_EQ(reduced.count.mobility, mobility.generic.mobility - internal) << scene.name();
    EXPECT_EQ(reduced.count.redundancy, mobility.generic.redundancy - redundant) << scene.name();
    EXPECT_EQ(reduced.count.useful, mobility.generic.useful) << scene.name();
  }
}

}  // namespace
}  // namespace torsor::reduced_graph_test
