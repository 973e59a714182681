// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::unknowns_report_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

Inertia box() { return Inertia::box(kilograms("1"), metres("0.2"), metres("0.3"), metres("0.4")); }

std::string components_of(const Scene& scene) {
  const Equations equations(scene);
  const std::vector<Connection> all = connections(equations);
  std::string text;
  for (const ReactionComponent& component : all.at(0).components) {
    text += (text.empty() ? "" : ", ") + component.name;
  }
  return text;
}

/// The ideal wrenches of the course's table, §6.2.3: what each joint of the tree can transmit.
TEST(Connection, TransmitsTheIdealWrenchOfItsJoint) {
  const auto scene_with = [](const auto& add) {
    Scene scene("joint");
    const Expression angle = scene.coordinate("q", "rad");
    const Expression slide = scene.coordinate("s", "m");
    const Triple angles{angle, scene.coordinate("q2", "rad"), scene.coordinate("q3", "rad")};
    scene.body("body", add(scene, angle, slide, angles), box());
    return components_of(scene);
  };
  const FrameHandle ground{0};
  using E = Expression;
  EXPECT_EQ(scene_with([&](Scene& s, E q, E, Triple) { return s.revolute("j", ground, axis::x, q); }), "X, Y, Z, M, N");
  EXPECT_EQ(scene_with([&](Scene& s, E, E x, Triple) { return s.prismatic("j", ground, axis::x, x); }),
            "Y, Z, L, M, N");
  const E pitch = Expression::quantity("0.01", "m");
  EXPECT_EQ(scene_with([&](Scene& s, E q, E, Triple) {
              return s.helical("j", ground, {.axis = axis::x, .angle = q, .pitch = pitch});
            }),
            "X - 0.01 L, Y, Z, M, N");
  // A factor that is no number is not made one.
  EXPECT_EQ(scene_with([&](Scene& s, E q, E, Triple) {
              return s.helical("j", ground, {.axis = axis::x, .angle = q, .pitch = s.run_time_parameter("p", "m", 1)});
            }),
            "X ~ L, Y, Z, M, N");
  EXPECT_EQ(scene_with([&](Scene& s, E q, E x, Triple) {
              return s.cylindrical("j", ground, {.axis = axis::x, .displacement = x, .angle = q});
            }),
            "Y, Z, M, N");
  EXPECT_EQ(scene_with([&](Scene& s, E q, E, Triple a) {
              return s.universal("j", ground,
                                 {.first = axis::x, .first_angle = q, .second = axis::y, .second_angle = a[1]});
            }),
            "X, Y, Z, N");
  EXPECT_EQ(scene_with([&](Scene& s, E, E, Triple a) {
              return s.spherical("j", ground, {.sequence = AngleSequence::euler, .angles = a});
            }),
            "X, Y, Z");
  EXPECT_EQ(scene_with([&](Scene& s, E, E, Triple) { return s.spherical("j", ground, s.attitude("turn")); }),
            "X, Y, Z");
  EXPECT_EQ(scene_with([&](Scene& s, E q, E x, Triple) {
              return s.planar("j", ground, {.x = x, .y = s.coordinate("y", "m"), .angle = q});
            }),
            "Z, L, M");
  EXPECT_EQ(scene_with([&](Scene& s, E, E x, Triple a) {
              return s.free("j", ground, {x, s.coordinate("y", "m"), s.coordinate("z", "m")},
                            {.sequence = AngleSequence::cardan, .angles = a});
            }),
            "");
  // A joint driven by a law of time transmits its motor's effort too.
  EXPECT_EQ(scene_with([&](Scene& s, E q, E, Triple) {
              s.drive(q, s.time() / Expression::quantity("1", "s"));
              return s.revolute("j", ground, axis::x, q);
            }),
            "X, Y, Z, L, M, N");
}

class RandomConnections : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomConnections, LeaveAsManyUnknownsAsEquations) {
  const Scene scene = random_mechanism(GetParam(), {.actions = false, .constraints = false});
  const Equations equations(scene);
  const auto joints = connections(equations);
  std::size_t unknowns = static_cast<std::size_t>(equations.model().unknown_count());
  for (const Connection& joint : joints) unknowns += joint.components.size();
  // Each body has its own joint here, and six equations.
  EXPECT_EQ(joints.size() + 1, equations.model().links().size());
  if (has_simple_joints(equations.model())) {
    EXPECT_EQ(unknowns, 6 * joints.size());
  } else {
    EXPECT_GE(unknowns, 6 * joints.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomConnections, ::testing::Range(700U, 715U));

Scene two_bars() {
  Scene scene("two_bars");
  const FrameHandle arm = scene.revolute("shoulder", scene.ground(), axis::z, scene.coordinate("q1", "rad"));
  const FrameHandle forearm =
      scene.revolute("elbow", arm, axis::z, scene.coordinate("q2", "rad"), {.origin = {metres("0.7"), 0, 0}});
  scene.body("arm", arm, box().at({metres("0.35"), 0, 0}));
  scene.body("forearm", forearm, box().at({metres("0.3"), 0, 0}));
  scene.point("E", forearm, {0, 0, 0});
  scene.point("O", scene.ground(), {0, 0, 0});
  scene.point("tip", forearm, {metres("0.6"), 0, 0});
  return scene;
}

TEST(IsolationReport, TellsWhichEquationGivesWhichUnknown) {
  const Equations equations(two_bars());
  EXPECT_EQ(isolation_report(equations, {"forearm"}, {Scene::point("E"), "elbow"}).text,
            "Newton-Euler for forearm at E along the axes of elbow\n"
            "  joint elbow: X, Y, Z, L, M\n"
            "  resultant, x: elbow X\n"
            "  resultant, y: elbow Y\n"
            "  resultant, z: elbow Z\n"
            "  moment, x: elbow L\n"
            "  moment, y: elbow M\n"
            "  moment, z: no unknown component, an equation of motion\n");
  // Away from the joint's axis the forces have moments, and along other axes they mix.
  const IsolationReport away = isolation_report(equations, {"forearm"}, {Scene::point("O"), "ground"});
  ASSERT_EQ(away.unknowns.size(), 5U);
  EXPECT_EQ(away.unknowns[0].name, "elbow X");
  EXPECT_EQ(away.unknowns[0].enters, (std::array<bool, 6>{true, true, false, false, false, true}));
  EXPECT_EQ(away.unknowns[2].enters, (std::array<bool, 6>{false, false, true, true, true, false}));
  // Both bars together: the elbow is inside.
  const IsolationReport both = isolation_report(equations, {"arm", "forearm"}, {Scene::point("O"), "ground"});
  EXPECT_EQ(both.unknowns.size(), 5U);
  EXPECT_EQ(both.unknowns[0].name, "shoulder X");
  EXPECT_NE(both.text.find("moment, z: no unknown component, an equation of motion"), std::string::npos);
  // The arm alone feels both joints.
  EXPECT_EQ(isolation_report(equations, {"arm"}, {Scene::point("O"), "ground"}).unknowns.size(), 10U);
}

TEST(IsolationReport, CountsTheMultipliersAcrossTheBoundary) {
  Scene scene = two_bars();
  scene.point("rail", scene.ground(), {metres("0.9"), 0, 0});
  scene.closure("guide", scene.point("rail"), scene.point("tip"), axis::y);
  scene.holonomic("gear",
                  Expression(scene.content().coordinates[0].q) + 2 * Expression(scene.content().coordinates[1].q));
  const Equations equations(scene);
  const IsolationReport report = isolation_report(equations, {"forearm"}, {Scene::point("tip"), "ground"});
  ASSERT_EQ(report.unknowns.size(), 6U);
  EXPECT_EQ(report.unknowns[5].name, "lambda_guide");
  EXPECT_EQ(report.unknowns[5].enters, (std::array<bool, 6>{false, true, false, false, false, false}));
  EXPECT_NE(report.text.find("constraint gear: a formula; its force is counted with the joints"), std::string::npos);
}

TEST(IsolationReport, LeavesOutWhatActsBetweenIsolatedBodies) {
  Scene scene = two_bars();
  scene.point("mark", "shoulder", {metres("0.2"), 0, 0});
  scene.closure("belt", scene.point("mark"), scene.point("tip"), axis::y);
  const Equations equations(scene);
  EXPECT_EQ(isolation_report(equations, {"arm", "forearm"}, {Scene::point("O"), "ground"}).unknowns.size(), 5U);
  EXPECT_EQ(isolation_report(equations, {"forearm"}, {Scene::point("O"), "ground"}).unknowns.size(), 6U);
}

// The force across the plane acts at the puck's centre, which both slides have moved: there it has no moment.
TEST(IsolationReport, CarriesForcesFromTheBodyWhereverItsJointStarts) {
  Scene scene("puck");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), q = scene.coordinate("q", "rad");
  const FrameHandle puck = scene.planar("puck", scene.ground(), {.x = x, .y = y, .angle = q});
  scene.body("puck", puck, box());
  scene.point("centre", puck, {0, 0, 0});
  scene.point("O", scene.ground(), {0, 0, 0});
  const Equations equations(scene);
  const IsolationReport at_centre = isolation_report(equations, {"puck"}, {Scene::point("centre"), "ground"});
  ASSERT_EQ(at_centre.unknowns.size(), 3U);
  EXPECT_EQ(at_centre.unknowns[0].name, "puck Z");
  EXPECT_EQ(at_centre.unknowns[0].enters, (std::array<bool, 6>{false, false, true, false, false, false}));
  const IsolationReport at_origin = isolation_report(equations, {"puck"}, {Scene::point("O"), "ground"});
  EXPECT_EQ(at_origin.unknowns[0].enters, (std::array<bool, 6>{false, false, true, true, true, false}));
}

TEST(UnknownsReport, CountsUnknownsAgainstEquations) {
  Scene scene = two_bars();
  scene.closure("guide", scene.point("O"), scene.point("tip"), axis::y);
  const Expression held = scene.released_coordinate("held", "m");
  const FrameHandle slide = scene.prismatic("pin", "elbow", axis::z, held);
  scene.body("hand", slide, box());
  EXPECT_EQ(
      unknowns_report(Equations(scene)),
      "Unknowns and equations of two_bars\n"
      "  unknown coordinates: 2 (q1, q2)\n"
      "  driven by a law of time: none\n"
      "  released, held at zero: 1 (held)\n"
      "  constraints: 1 (guide)\n"
      "  degrees of freedom: 1\n"
      "  joint shoulder on ground: X, Y, Z, L, M\n"
      "  joint elbow on shoulder: X, Y, Z, L, M\n"
      "  joint pin on elbow: X, Y, Z, L, M, N\n"
      "Newton-Euler\n"
      "  19 equations: 6 for each of 3 bodies and 1 of constraint\n"
      "  19 unknowns: 16 components in joints, 1 multiplier, 2 accelerations\n"
      "Lagrange\n"
      "  3 equations: 2 of motion and 1 of constraint, for 2 accelerations and 1 multiplier\n"
      "  1 equation more, of the released coordinates, for the reactions against them\n"
      "The choice\n"
      "  with 1 independent instead of 2 coordinates there is no multiplier, and what the constraints transmit stays "
      "unknown\n"
      "  each component in a joint comes from Newton-Euler for isolated bodies, or from one more released coordinate "
      "and its equation\n");
}

// A nut on its thread, guided by slide and hinge already: four of the thread's five conditions repeat them.
TEST(UnknownsReport, CountsConstraintsThatRepeatOthersOnce) {
  const std::string text = unknowns_report(Equations(nut_on_a_thread()));
  for (const char* line : {
           "  constraints: 5 (thread_x; thread_y; thread_z; thread_ry; thread_rz)\n",
           "  of these, constraints that repeat others: 4 (thread_y, thread_z, thread_ry, thread_rz)\n",
           "  degrees of freedom: 1\n",
           "  7 equations: 6 for each of 1 body and 1 of constraint\n",
           "  11 unknowns: 4 components in joints, 5 multipliers, 2 accelerations\n",
           "  4 unknowns indeterminate: constraints that repeat others share their forces in a way that no motion tells\n",
           "  3 equations: 2 of motion and 1 of constraint, for 2 accelerations and 1 multiplier\n",
           "  with 1 independent instead of 2 coordinates ",
       }) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

TEST(UnknownsReport, SaysWhenJointsShareACoordinate) {
  Scene scene("gears");
  const Expression q = scene.coordinate("q", "rad");
  scene.body("first", scene.revolute("first", scene.ground(), axis::z, q), box());
  scene.body("second", scene.revolute("second", scene.ground(), axis::z, -3 * q, {.origin = {metres("1"), 0, 0}}),
             box());
  const std::string text = unknowns_report(Equations(scene));
  EXPECT_NE(text.find("12 equations: 6 for each of 2 bodies and 0 of constraint"), std::string::npos) << text;
  EXPECT_NE(text.find("13 unknowns: 12 components in joints"), std::string::npos) << text;
  EXPECT_NE(text.find("1 equation more: joints tied by formulas of shared coordinates transmit power without loss"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace torsor::unknowns_report_test
