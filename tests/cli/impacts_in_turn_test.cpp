// SPDX-License-Identifier: GPL-3.0-or-later
// Two contacts of one body that strike in turn, ever faster, at speeds that hardly fade.
#include <array>
#include <string>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::impacts_in_turn_test {
namespace {

using namespace testing_programs;

Expression number(const char* text, const char* unit) { return Expression::quantity(text, unit); }

/// A dumbbell of two masses that is free in the plane y = 0, and its start.
struct Dumbbell {
  const char *mass, *reach;
  std::array<const char*, 3> place, speed;
};

FrameHandle free_dumbbell(Scene& scene, const std::string& name, const Dumbbell& of) {
  const Expression x = scene.coordinate("x" + name, "m"), z = scene.coordinate("z" + name, "m");
  const Expression a = scene.coordinate("a" + name, "rad");
  const FrameHandle level = scene.prismatic("p" + name, scene.ground(), axis::x, x);
  const FrameHandle frame = scene.revolute("b" + name, scene.prismatic("h" + name, level, axis::z, z), axis::y, a);
  scene.initial(x, number(of.place[0], "m"), number(of.speed[0], "m/s"));
  scene.initial(z, number(of.place[1], "m"), number(of.speed[1], "m/s"));
  scene.initial(a, number(of.place[2], "rad"), number(of.speed[2], "rad/s"));
  for (const int side : {1, -1}) {
    scene.body("m" + name + (side > 0 ? "b" : "a"), frame,
               Inertia::point(number(of.mass, "kg") / 2).at({side * number(of.reach, "m"), 0, 0}));
  }
  return frame;
}

/// A ball of the first body falls onto a slope while a ball of the second falls onto a plank of the first.
Scene dumbbells(bool swapped) {
  Scene scene("dumbbells");
  scene.gravity({0, 0, number("-9.81", "m/s^2")});
  const FrameHandle lower =
      free_dumbbell(scene, "0", {"0.5", "0.3", {"0.112", "2.0", "-0.344"}, {"-1.363", "0.847", "1.051"}});
  const FrameHandle upper = free_dumbbell(scene, "1", {"1", "0.1", {"1.481", "3.0", "0.724"}, {"-0.391", "0.353", "1.027"}});
  const FrameHandle ball = scene.weld("ball0", lower, {.origin = {number("0.3", "m"), 0, number("-0.4", "m")}});
  const FrameHandle other_ball = scene.weld("ball1", upper, {.origin = {number("-0.3", "m"), 0, number("-0.4", "m")}});
  const FrameHandle plank = scene.weld("plank", lower, {.origin = {0, 0, number("0.1", "m")}});
  const FrameHandle below = scene.weld("below", scene.ground(), {.origin = {0, 0, number("-0.5", "m")}});
  const FrameHandle slope = scene.weld("slope", below, {.rotation = Rotation::about(1, 1)});
  SurfaceLaw rough, smooth;
  rough.friction = number("1.5", "1");
  smooth.friction = number("0.1", "1");
  smooth.static_friction = number("0.2", "1");
  rough.restitution = smooth.restitution = number("0.3", "1");
  const shape::Sphere large{.frame = ball, .radius = number("0.25", "m")};
  const shape::Sphere small{.frame = other_ball, .radius = number("0.1", "m")};
  if (swapped) scene.contact("c1", small, shape::Plane{.frame = plank}, smooth);
  scene.contact("c0", large, shape::Plane{.frame = slope}, rough);
  if (!swapped) scene.contact("c1", small, shape::Plane{.frame = plank}, smooth);
  return scene;
}
Scene as_said() { return dumbbells(false); }
Scene the_other_way_round() { return dumbbells(true); }

// Each flight is 0.37 of the one before and each speed 0.85: no flight is resolved when the bodies still meet at 1.9 m/s. Both
// contacts are closed then. An impact map of its own, iterated to its limit at the last configuration (good to some 2e-4), has
// x0' = 1.9751, a0' = 2.9709 and a1' = 11.976 there.
TEST(ImpactsInTurn, EndTogetherWhicheverContactIsDeclaredFirst) {
  const char* end = "0.90288";
  const Outcome one = run(as_said, {"simulate", "--to", end, "--tolerance", "1e-11"});
  const Outcome other = run(the_other_way_round, {"simulate", "--to", end, "--tolerance", "1e-11"});
  for (const Outcome& each : {one, other}) {
    ASSERT_EQ(each.code, 0) << each.err;
    const MotionTable motion = table(each.out);
    EXPECT_NEAR(motion.end("x0'"), 1.9751, 5e-4);
    EXPECT_NEAR(motion.end("a0'"), 2.9709, 5e-4);
    EXPECT_NEAR(motion.end("a1'"), 11.976, 2e-3);
    // The end is told where it is, and no impact follows it.
    const std::size_t told = each.out.find("end of the bounces of c");
    ASSERT_NE(told, std::string::npos) << each.out;
    EXPECT_NEAR(std::stod(each.out.substr(each.out.find("t = ", told) + 4)), 0.9028719911, 1e-9) << each.out;
    EXPECT_EQ(each.out.find("Event: impact of", told), std::string::npos) << each.out;
  }
  for (const char* name : {"x0", "a0'", "x1'", "a1'"}) EXPECT_NEAR(table(one.out).end(name), table(other.out).end(name), 1e-6);
}

}  // namespace
}  // namespace torsor::impacts_in_turn_test
