// SPDX-License-Identifier: GPL-3.0-or-later
// Friction on a constraint assumes that the surface presses and that the slip goes on: `simulate` says where it does not.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::friction_regime_test {
namespace {

using testing_programs::Outcome;
using testing_programs::run;
using testing_programs::table;

/// A block of 2 kg on a floor, lifted by k t and pushed back by `brake`, with friction along its slip, or along x as given.
Scene block(const char* lift, const char* brake, bool along_slip) {
  Scene scene("block");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle carriage = scene.prismatic("carriage", scene.ground(), axis::x, x);
  const FrameHandle body = scene.prismatic("block", carriage, axis::z, z);
  scene.body("block", body, Inertia::point(scene.run_time_parameter("m", "kg", 2)));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const Expression lifts = Expression::quantity(lift, "N/s") * scene.time();
  const PointHandle point = scene.point("P", body, {0, 0, 0});
  const Expression push = Expression::quantity(brake, "N");
  scene.force("pull", {.body = body, .point = point, .components = {push, 0, lifts}, .axes = scene.ground()});
  const ConstraintHandle floor = scene.holonomic("floor", z);
  const Expression slip = along_slip ? rate(x) : Expression(1);
  scene.sliding_friction("rub", floor,
                         {.coefficient = Expression(Number::rational(1, 10)),
                          .body = body,
                          .point = point,
                          .direction = {slip, 0, 0},
                          .axes = scene.ground()});
  scene.initial(x, 0, 4);
  return scene;
}
Scene pressed() { return block("0", "0", true); }
Scene lifted() { return block("10", "0", true); }
Scene turned() { return block("0", "-20", false); }

/// With m = 0.57 nothing presses: what is left of N is the rounding of 9.81 m, -9e-16 N.
Scene unloaded() {
  Scene scene = block("0", "0", true);
  const Expression up = Expression::quantity("5.5917", "N");
  scene.force("up", {.body = "block", .point = scene.point("P"), .components = {0, 0, up}, .axes = "ground"});
  return scene;
}

TEST(FrictionRegime, TakesNoRoundingForAPull) {
  const Outcome motion = run(unloaded, {"simulate", "--run-time", "m=0.57", "--to", "1", "-o", "-"});
  ASSERT_EQ(motion.code, 0) << motion.err;
  EXPECT_EQ(motion.err.find("friction"), std::string::npos) << motion.err;
}

TEST(FrictionRegime, SaysNothingWhereFrictionBrakes) {
  const Outcome motion = run(pressed, {"simulate", "--to", "2", "-o", "-"});
  ASSERT_EQ(motion.code, 0) << motion.err;
  EXPECT_EQ(motion.err.find("friction"), std::string::npos) << motion.err;
}

TEST(FrictionRegime, SaysWhereASurfacePulls) {
  const Outcome motion = run(lifted, {"simulate", "--to", "3", "-o", "-"});
  ASSERT_EQ(motion.code, 0) << motion.err;
  // 10 t = 2 * 9.81: the first row of a multiple of 0.01 s after it
  EXPECT_NE(motion.err.find("at t = 1.97 s the normal force of the constraint 'floor' is -0.08 N: it pulls, which no "
                            "surface does; for a surface that only presses"),
            std::string::npos)
      << motion.err;
  bool noted = false;
  for (const std::string& note : table(motion.out).notes) noted = noted || note.find("it pulls") != std::string::npos;
  EXPECT_TRUE(noted) << "in the file as well";
}

TEST(FrictionRegime, SaysWhereASlipTurnsAgainstTheDirectionGiven) {
  // v = 4 - (20 + 1.962)/2 t
  const Outcome motion = run(turned, {"simulate", "--to", "1", "-o", "-"});
  ASSERT_EQ(motion.code, 0) << motion.err;
  EXPECT_NE(motion.err.find("at t = 0.37 s the slip at the constraint 'floor' is against the direction that its friction "
                            "assumes"),
            std::string::npos)
      << motion.err;
}

}  // namespace
}  // namespace torsor::friction_regime_test
