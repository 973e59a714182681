// SPDX-License-Identifier: GPL-3.0-or-later
// That the laws of contact allow several motions is told where it is so, of impulses as of regimes.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::several_motions_test {
namespace {

using namespace testing_programs;

Expression number(const char* text, const char* unit) { return Expression::quantity(text, unit); }

/// A disc that rolls at 2 m/s against an edge 0.1 m above the floor, round by 0.05 m.
Scene rolling_disc() {
  Scene scene("disc");
  scene.gravity({0, 0, number("-9.81", "m/s^2")});
  const Expression f = scene.run_time_parameter("f", "1", number("3", "1"));
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), a = scene.coordinate("a", "rad");
  const FrameHandle level = scene.prismatic("level", scene.ground(), axis::x, x);
  const FrameHandle disc = scene.revolute("disc", scene.prismatic("lift", level, axis::z, z), axis::y, a);
  scene.body("disc", disc, Inertia::disk(number("2", "kg"), number("0.5", "m"), 1));
  const FrameHandle edge = scene.weld("edge", scene.ground(), {.origin = {number("0.5", "m"), 0, number("0.1", "m")}});
  const shape::Sphere rim{.frame = disc, .radius = number("0.5", "m")};
  scene.contact("floor", rim, shape::Plane{.frame = scene.ground()}, {.friction = f});
  scene.contact("edge", rim, shape::Sphere{.frame = edge, .radius = number("0.05", "m")}, {.friction = f});
  scene.initial(x, number("0", "m"), number("2", "m/s"));
  scene.initial(z, number("0.5", "m"));
  scene.initial(a, number("0", "rad"), number("4", "rad/s"));
  return scene;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The two points of contact see the centre under cos φ = 0.4/0.55. Their forces may hold each other along the chord where f is at
// least cot(φ/2) = 2.517, and the disc may stop dead. That it turns about the edge is possible with any f above one.
TEST(SeveralMotions, AreToldOfImpulsesThatWedgeOrDoNot) {
  const std::string other = "; other impulses are possible: floor is open, edge sticks";
  const std::string remark = "in one decision several motions fulfil the laws of contact: one was taken";
  for (const char* law : {"newton_moreau", "poisson"}) {
    const Outcome wedged = run(rolling_disc, {"simulate", "--to", "0.1", "--impact-law", law, "--run-time", "f=2.52"});
    ASSERT_EQ(wedged.code, 0) << wedged.err;
    EXPECT_TRUE(has(wedged.out, other + "\n")) << wedged.out;
    EXPECT_TRUE(has(wedged.out, remark)) << wedged.out;
    EXPECT_NEAR(table(wedged.out).end("x'"), 0, 1e-12);
    const Outcome rolls = run(rolling_disc, {"simulate", "--to", "0.1", "--impact-law", law, "--run-time", "f=2.51"});
    ASSERT_EQ(rolls.code, 0) << rolls.err;
    EXPECT_FALSE(has(rolls.out, "possible")) << rolls.out;
    EXPECT_FALSE(has(rolls.out, "several motions")) << rolls.out;
  }
}

}  // namespace
}  // namespace torsor::several_motions_test
