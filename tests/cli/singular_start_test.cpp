// SPDX-License-Identifier: GPL-3.0-or-later
// A start at which the coordinates are singular is noticed, and the remedy named.
#include "torsor/generator/dynamics/equations/singular_start.hpp"

#include "tests/cli/scene_runner.hpp"

namespace torsor::singular_start_test {
namespace {

using namespace testing_programs;
using testing_mechanisms::moment;

/// A free body by three angles, which start at zero but for the second.
Scene free_body(const AngleSequence& sequence, const Expression& second) {
  Scene scene("body");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad"), theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  const FrameHandle body =
      scene.free("body", scene.ground(), {x, y, z}, {.sequence = sequence, .angles = {psi, theta, phi}});
  scene.body("body", body,
             Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = moment("3"), .yy = moment("4"),
                               .zz = moment("5")}));
  scene.initial(theta, second);
  return scene;
}
Scene euler_at_zero() { return free_body(AngleSequence::euler, 0); }

constexpr const char* remark =
    "at the initial state 'psi' and 'phi' can change without moving any mass and accelerations are not determined: the "
    "coordinates are singular there; give the orientation by attitude(...), take another sequence of angles, or start "
    "elsewhere";

TEST(SingularStart, OfEulersAnglesIsNoticed) {
  const std::vector<std::string> remarks = singular_start(euler_at_zero());
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0], remark);
  EXPECT_TRUE(singular_start(free_body(AngleSequence::euler, Expression(Number::rational(1, 100)))).empty());
  // Cardan's angles lock at a right angle.
  EXPECT_TRUE(singular_start(free_body(AngleSequence::cardan, 0)).empty());
  EXPECT_EQ(singular_start(free_body(AngleSequence::cardan, pi() / 2)).size(), 1U);
}

TEST(SingularStart, OfAnAttitudeIsNone) {
  EXPECT_TRUE(singular_start(testing_mechanisms::torque_free_body()).empty());
  EXPECT_TRUE(singular_start(pendulum()).empty());
}

/// Axes that are parallel at the start in a chain of joints of its own, with frames that carry nothing between them.
TEST(SingularStart, OfAnyChainOfJointsIsNoticed) {
  Scene scene("gimbal");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle outer = scene.revolute("outer", scene.ground(), axis::z, a);
  const FrameHandle inner = scene.revolute("inner", outer, axis::y, b);
  const FrameHandle rotor = scene.revolute("rotor", inner, axis::z, c);
  scene.body("rotor", rotor, Inertia::disk(Expression::quantity("1", "kg"), Expression::quantity("1", "m"), 2));
  const std::vector<std::string> remarks = singular_start(scene);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_TRUE(remarks[0].starts_with("at the initial state 'a' and 'c' can change without")) << remarks[0];
}

TEST(SingularStart, IsSaidByEveryCommandAndByTheErrorOfOneThatNeedsAccelerations) {
  const Outcome list = run(euler_at_zero, {"list"});
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(list.err, std::string("note: ") + remark + "\n");
  const Outcome reference = run(euler_at_zero, {"reference", "--digits", "10", "--times", "1"});
  EXPECT_EQ(reference.code, 3);
  EXPECT_NE(reference.err.find(remark), std::string::npos) << reference.err;
}

/// A disc that lies flat on the ground at the start.
TEST(SingularStart, OfADiscThatLiesFlatIsNamed) {
  const Outcome outcome = run(
      [] {
        Scene scene("flat");
        const Expression z = scene.coordinate("z", "m"), psi = scene.coordinate("psi", "rad");
        const Expression theta = scene.coordinate("theta", "rad"), phi = scene.coordinate("phi", "rad");
        const Expression r = Expression::quantity("1", "m");
        const FrameHandle disc = scene.spherical("disc", scene.prismatic("lift", scene.ground(), axis::z, z),
                                                 {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
        scene.body("disc", disc, Inertia::disk(Expression::quantity("1", "kg"), r, 2));
        scene.point_in_plane(
            "touch", scene.disc_contact("C", {.frame = disc, .axis = axis::z, .radius = r, .plane = scene.ground()}),
            scene.ground());
        return scene;
      },
      {"list"});
  expect_failure(outcome, 3,
                 "constraint 'touch' has no rate at t = 0: the disc of the point of contact 'C' lies flat there, and no point "
                 "of its rim is the lowest; correct initial(...), or give the orientation by attitude(...)");
}

}  // namespace
}  // namespace torsor::singular_start_test
