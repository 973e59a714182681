// SPDX-License-Identifier: GPL-3.0-or-later
// A constraint is left out because it repeats others: that must hold whatever values parameters get later.
#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::run_time_redundancy_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using Indices = std::vector<std::size_t>;

/// x = 2 y twice, the second time as k x = 4 y with k = 2.
Scene geared(bool run_time) {
  Scene scene("geared");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression k = run_time ? scene.run_time_parameter("k", "1", 2) : scene.parameter("k", "1", 2);
  const Expression m = scene.run_time_parameter("m", "kg", 3);
  const FrameHandle cart = scene.prismatic("cart", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y);
  scene.body("cart", cart, Inertia::point(m));
  scene.holonomic("first", x - 2 * y);
  scene.holonomic("second", k * x - 4 * y);
  return scene;
}

constexpr const char* refused =
    "constraint 'second' repeats others only at the values that the run-time parameters 'k' have in the scene: at "
    "others "
    "it counts, and would not be enforced; make them constant, or leave the constraint out";

TEST(RunTimeParameters, ThatMakeADroppedConstraintCountAreRefused) {
  EXPECT_EQ(constraint_rank(geared(false)).dropped, (Indices{1}));
  EXPECT_EQ(error_of<SceneError>([&] { constraint_rank(geared(true)); }), refused);
  EXPECT_EQ(error_of<SceneError>([&] { validate(geared(true)); }), refused);
}

TEST(RunTimeParameters, CountAsTheyAreAskedForWhenKernelsAreGenerated) {
  ModelOptions all, one, other;
  all.all_run_time = true;
  one.run_time = {"k"};
  other.run_time = {"m"};
  EXPECT_EQ(error_of<SceneError>([&] { Equations(geared(false), all).redundancy(); }), refused);
  EXPECT_EQ(error_of<SceneError>([&] { Equations(geared(false), one).redundancy(); }), refused);
  EXPECT_EQ(Equations(geared(false), other).redundancy().dropped, (Indices{1}));
}

/// A bar on three parallel cranks: it moves only because they have one length, whose value does not matter.
Scene three_cranks(const Expression& l, const Expression& third, Scene scene) {
  const auto angle = [&scene](const std::string& name, int start) {
    const Expression q = scene.coordinate(name, "rad");
    scene.initial(q, start);
    return q;
  };
  const Expression a = angle("a", 1), b = angle("b", 1), c = angle("c", 1), bar_angle = angle("bar_angle", -1);
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle second = scene.revolute("second", scene.ground(), axis::z, b, {{metres("1"), 0, 0}, {}});
  const FrameHandle last = scene.revolute("last", scene.ground(), axis::z, c, {{metres("2"), 0, 0}, {}});
  const FrameHandle bar = scene.revolute("bar", first, axis::z, bar_angle, {{l, 0, 0}, {}});
  for (const auto& [name, frame] : std::vector<std::pair<std::string, FrameHandle>>{
           {"first", first}, {"second", second}, {"last", last}, {"bar", bar}}) {
    scene.body(name, frame, Inertia::rod(kilograms("1"), metres("1"), 0));
  }
  const PointHandle at_one = scene.point("at_one", bar, {metres("1"), 0, 0});
  const PointHandle at_two = scene.point("at_two", bar, {metres("2"), 0, 0});
  const PointHandle tip = scene.point("tip", second, {l, 0, 0}), end = scene.point("end", last, {third, 0, 0});
  scene.closure("second_x", at_one, tip, axis::x);
  scene.closure("second_y", at_one, tip, axis::y);
  scene.closure("last_x", at_two, end, axis::x);
  scene.closure("last_y", at_two, end, axis::y);
  return scene;
}

TEST(RunTimeParameters, MayChangeALoopThatStaysRedundant) {
  Scene scene("cranks");
  const Expression l = scene.run_time_parameter("l", "m", 2);
  const Scene alike = three_cranks(l, l, scene);
  EXPECT_EQ(constraint_rank(alike).dropped.size(), 1U);
  EXPECT_EQ(error_of([&] { validate(alike); }), "no error");
}

TEST(RunTimeParameters, ThatBreakARedundantLoopAreRefused) {
  Scene scene("cranks");
  const Expression l = scene.run_time_parameter("l", "m", 2);
  const Expression third = scene.run_time_parameter("third", "m", 2);
  const std::string text = error_of<SceneError>([&] { constraint_rank(three_cranks(l, third, scene)); });
  EXPECT_TRUE(text.starts_with("constraint 'last_")) << text;
  EXPECT_NE(text.find("the run-time parameters 'l', 'third' have in the scene"), std::string::npos) << text;
}

}  // namespace
}  // namespace torsor::run_time_redundancy_test
