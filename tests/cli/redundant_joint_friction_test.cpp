// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of a joint in proportion to what it transmits, in loops that share their forces in more than one way; and
// whatever the joint's axis.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/forces/bearing_loads.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::redundant_joint_friction_test {
namespace {

using testing_programs::Outcome;
using testing_programs::run;
using testing_programs::table;

Expression metres(const char* value) { return Expression::quantity(value, "m"); }
Expression kilograms(const char* value) { return Expression::quantity(value, "kg"); }
const Rotation x_up = Rotation::about(1, -6);  // x of the frame along z of the link

void rub(Scene& scene, const char* frame) {
  scene.joint_friction("journal", frame, {.friction = Expression(Number::rational(1, 10)), .radius = metres("0.05")});
}

/// A door on a hinge, and on another one above it.
Scene door(JointType upper) {
  Scene scene("door");
  const Expression q = scene.coordinate("q", "rad");
  const FrameHandle leaf = scene.revolute("leaf", scene.ground(), axis::z, q);
  scene.body("leaf", leaf, Inertia::rod(kilograms("20"), metres("1"), 0));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.initial(q, 0, 1);
  const Triple high{0, 0, metres("2")};
  const FrameHandle above = scene.weld("above", scene.ground(), {high, x_up});
  scene.loop_joint("upper", {.type = upper, .a = above, .b = scene.weld("top", leaf, {high, x_up})});
  rub(scene, "leaf");
  return scene;
}
Scene door_on_two_hinges() { return door(JointType::revolute); }
Scene door_in_a_ball() { return door(JointType::spherical); }

/// A bar on three parallel cranks of one length: two would do.
Scene bar_on_three_cranks() {
  Scene scene("cranks");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle bar = scene.revolute("bar", first, axis::z, b, {{metres("1"), 0, 0}});
  scene.body("first", first, Inertia::rod(kilograms("1"), metres("1"), 0));
  scene.body("bar", bar, Inertia::rod(kilograms("2"), metres("3"), 0));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  scene.initial(a, 1);
  scene.initial(b, -1);
  for (const char* place : {"2", "3"}) {
    const std::string name = std::string("crank") + place;
    const Expression q = scene.coordinate("q" + std::string(place), "rad");
    const FrameHandle crank = scene.revolute(name, scene.ground(), axis::z, q, {.origin = {metres(place), 0, 0}});
    scene.body(name, crank, Inertia::rod(kilograms("1"), metres("1"), 0));
    scene.initial(q, 1);
    const PointHandle tip = scene.point("tip" + name, crank, {metres("1"), 0, 0});
    const PointHandle on = scene.point("on" + name, bar, {metres(place), 0, 0});
    scene.closure(name + "_x", on, tip, axis::x);
    scene.closure(name + "_y", on, tip, axis::y);
  }
  rub(scene, "first");
  return scene;
}

/// Crank, coupler and rocker, closed in their plane or by a pin in space: that shares nothing across the axes.
Scene four_bar(bool pin) {
  Scene scene("four_bar");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, b, {{metres("1"), 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {{metres("2"), 0, 0}});
  scene.body("crank", crank, Inertia::rod(kilograms("1"), metres("1"), 0));
  scene.body("coupler", coupler, Inertia::rod(kilograms("2"), metres("2"), 0));
  scene.body("rocker", rocker, Inertia::rod(kilograms("1.5"), metres("1.5"), 0));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  scene.initial(a, 1);
  scene.initial(b, Expression::quantity("-0.701107141659005", "rad"));
  scene.initial(c, Expression::quantity("1.264965395965706", "rad"));
  if (pin) {
    const FrameHandle tip = scene.weld("tip", coupler, {{metres("2"), 0, 0}, x_up});
    const FrameHandle end = scene.weld("end", rocker, {{metres("1.5"), 0, 0}, x_up});
    scene.loop_joint("pin", {.type = JointType::revolute, .a = tip, .b = end});
  } else {
    const PointHandle tip = scene.point("tip", coupler, {metres("2"), 0, 0});
    const PointHandle end = scene.point("end", rocker, {metres("1.5"), 0, 0});
    scene.closure("x", tip, end, axis::x);
    scene.closure("y", tip, end, axis::y);
  }
  rub(scene, "crank");
  return scene;
}
Scene in_its_plane() { return four_bar(false); }
Scene by_a_pin() { return four_bar(true); }

// Whatever the hinges share is right, so that friction in proportion to it, and the motion, would be anything.
TEST(RedundantJointFriction, IsRefusedWhereLoopsShareWhatTheJointTransmits) {
  const auto refused = [](Scene (*scene)(), const std::string& constraint) {
    for (const auto& command : {std::vector<std::string>{"simulate", "--to", "0.1", "--step", "0.1"},
                                std::vector<std::string>{"generate", "--kernels", "contacts", "--output", "/dev/null"}}) {
      const Outcome outcome = run(scene, command);
      EXPECT_EQ(outcome.code, 3) << outcome.out;
      EXPECT_NE(outcome.err.find("the friction 'journal' is in proportion to what its joint transmits, which is indeterminate, "
                                 "and the motion with it: constraint '" + constraint + "' repeats others; leave out what "
                                 "repeats, or give the bound of a dry_friction"),
                std::string::npos)
          << outcome.err;
    }
  };
  refused(door_on_two_hinges, "upper_y");  // upper_x is along the hinges, and loads no journal
  refused(door_in_a_ball, "upper_y");
  refused(bar_on_three_cranks, "crank3_y");
}

TEST(RedundantJointFriction, IsThatOfTheLoopWithoutWhatRepeatsWhereNothingIsShared) {
  const std::vector<std::string> command{"simulate", "--to", "0.5", "--step", "0.1"};
  const Outcome plane = run(in_its_plane, command), pin = run(by_a_pin, command);
  ASSERT_EQ(plane.code, 0) << plane.err;
  ASSERT_EQ(pin.code, 0) << pin.err;
  const auto one = table(plane.out), other = table(pin.out);
  EXPECT_GT(std::abs(one.end("journal_T")), 0.1);
  for (const char* column : {"a", "a'", "c", "journal_T"}) EXPECT_NEAR(one.end(column), other.end(column), 1e-10) << column;
}

// Directions across an axis that only run-time parameters say: of two that are known, one nearly opposite to e_z once cancelled.
TEST(DirectionsAcrossAnAxis, AreOrthonormalWhateverTheAxis) {
  Scene scene("axis");
  const Expression p = scene.run_time_parameter("p", "1", 1), q = scene.run_time_parameter("q", "1", 0),
                   r = scene.run_time_parameter("r", "1", 0);
  const Expression turn = scene.coordinate("turn", "rad");
  const FrameHandle rod = scene.revolute("rod", scene.ground(), {p, q, r}, turn);
  scene.body("rod", rod, Inertia::solid_sphere(kilograms("1"), metres("1")));
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program, {});
  const Link& link = model.links().back();
  const std::vector<Vector> across = across_axis(program, link);
  ASSERT_EQ(across.size(), 2U);
  std::vector<std::array<double, 3>> axes{{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 1, 0}};
  for (double small = 1; small > 1e-20; small /= 10) {
    for (const double z : {-1.0, 1.0}) {
      axes.push_back({small, 0, z});
      axes.push_back({-small, 2 * small, z});
      axes.push_back({1, -0.5, small * z});
    }
  }
  for (const auto& each : axes) {
    Evaluator<double> here(program, [&each](const SymbolPointer& symbol) { return symbol->name == "p" ? each[0] : symbol->name == "q" ? each[1] : each[2]; });
    const auto product = [&here](const Vector& a, const Vector& b) {
      double sum = 0;
      for (int i = 0; i < 3; ++i) sum += here(a[i]) * here(b[i]);
      return sum;
    };
    SCOPED_TRACE(testing::Message() << each[0] << ", " << each[1] << ", " << each[2]);
    // Some ten roundings of numbers up to 1: 1 + |n_z| is no less.
    for (const Vector& one : across) {
      EXPECT_NEAR(product(one, one), 1, 1e-15);
      EXPECT_NEAR(product(one, link.axis), 0, 1e-15);
    }
    EXPECT_NEAR(product(across[0], across[1]), 0, 1e-15);
  }
}

}  // namespace
}  // namespace torsor::redundant_joint_friction_test
