// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::simulate_contacts_test {
namespace {

using testing_programs::Outcome;
using testing_programs::run;
using testing_programs::MotionTable;
using testing_programs::table;

/// A ball dropped on a floor from 1 m.
Scene dropped() {
  Scene scene("dropped", "");
  const Expression e = scene.run_time_parameter("e", "1", Expression(Number::rational(1, 2)));
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(Expression::quantity("2", "kg")));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.initial(z, Expression::quantity("1", "m"));
  scene.contact("floor", shape::Sphere{.frame = ball, .radius = Expression::quantity("0", "m")},
                shape::Plane{.frame = scene.ground()}, {.restitution = e});
  return scene;
}

/// Its radius is given at run time.
Scene sized() {
  Scene scene("sized", "");
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(Expression::quantity("1", "kg")));
  const Expression r = scene.run_time_parameter("r", "m", Expression(Number::rational(1, 10)));
  scene.contact("floor", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = "ground"}, {});
  scene.initial(z, 1);
  return scene;
}

/// A parallelogram as a loop, whose crank falls onto a stop, with dry friction in its first joint.
Scene stopped_loop() {
  Scene scene("stopped_loop", "");
  const Expression a = scene.coordinate("a", "rad");
  const Expression b = scene.coordinate("b", "rad");
  const Expression c = scene.coordinate("c", "rad");
  scene.initial(a, Expression(Number::rational(6, 5)));
  scene.initial(b, Expression(Number::rational(-6, 5)));
  scene.initial(c, Expression(Number::rational(6, 5)));
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::y, a);
  const Expression l = Expression::quantity("1", "m");
  const FrameHandle at_tip = scene.weld("tip", crank, {.origin = {0, 0, l}});
  const FrameHandle coupler = scene.revolute("coupler", at_tip, axis::y, b);
  const FrameHandle base = scene.weld("base", scene.ground(), {.origin = {2 * l, 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", base, axis::y, c);
  scene.body("crank", crank, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, l}));
  scene.body("coupler", coupler, Inertia::point(Expression::quantity("1", "kg")).at({l, 0, 0}));
  scene.body("rocker", rocker, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, l}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const PointHandle p = scene.point("P", coupler, {2 * l, 0, 0});
  const PointHandle q = scene.point("Q", rocker, {0, 0, l});
  scene.closure("close_x", p, q, axis::x);
  scene.closure("close_z", p, q, axis::z);
  scene.stop(a, std::nullopt, Expression(Number::rational(7, 5)), {.restitution = Expression(Number::rational(1, 4))});
  scene.dry_friction("bearing", a, {.bound = Expression::quantity("0.5", "N m")});
  return scene;
}

// The ball strikes the floor as the motion starts: no constraint takes its velocity, an impact does.
TEST(SimulateContacts, TellAnImpactAtTheStartAsOne) {
  const Outcome outcome = run(dropped, {"simulate", "--to", "0.1", "--initial", "z=0,z'=-1"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(table(outcome.out).at(0, "z'"), 0.5);
  EXPECT_EQ(outcome.err.find("constraints"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("event: impact of floor at t = 0 s, energy lost 0.75 J"), std::string::npos) << outcome.err;
  // What loops take is told all the same.
  const Outcome loop = run(stopped_loop, {"simulate", "--to", "0.01", "--initial", "a=1.4,b=-1.4,c=1.4,a'=1,b'=0,c'=1"});
  const std::string told = "the constraints do not allow what --initial gives: the motion starts at ";
  EXPECT_NE(loop.err.find(told), std::string::npos) << loop.err;
  EXPECT_NE(loop.err.find("b' = "), std::string::npos) << loop.err;
  EXPECT_EQ(loop.err.find("a' = -"), std::string::npos) << loop.err;
}

TEST(SimulateContacts, SayWhereTheirToleranceIsCoarseBesideTheMotion) {
  const Outcome small = run(dropped, {"simulate", "--to", "0.001", "--step", "0.001", "--initial", "z=1e-6"});
  EXPECT_NE(small.err.find("coordinates in m stay below 1.0e-06"), std::string::npos) << small.err;
  EXPECT_EQ(run(dropped, {"simulate", "--to", "0.1", "--step", "0.1"}).err.find("stay below"), std::string::npos);
}

// contact_zeno_billiard_grazing.md (1): the bounces end at sqrt(2 h/g) (1 + e)/(1 - e), then it rests with N = m g.
TEST(SimulateContacts, BouncesTillItRests) {
  const Outcome outcome = run(dropped, {"simulate", "--to", "1.5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  EXPECT_EQ(motion.rows.size(), 151U);
  EXPECT_NEAR(motion.end("z"), 0, 1e-15);
  EXPECT_NEAR(motion.end("z'"), 0, 1e-15);
  EXPECT_NEAR(motion.end("floor_N"), 2 * 9.81, 1e-12);
  EXPECT_EQ(motion.at(0, "floor_N"), 0);
  EXPECT_EQ(motion.at(0, "floor_gap"), 1);
  for (const auto& row : motion.rows) EXPECT_GE(row.at(motion.column.at("floor_gap")), -1e-15);
  // First impact at sqrt(2/g), then the end.
  int impacts = 0;
  double last = 0;
  for (const std::string& note : motion.notes) {
    const std::size_t at = note.find(" at t = ");
    if (!note.starts_with("# Event: ") || at == std::string::npos) continue;
    last = std::stod(note.substr(at + 8));
    if (impacts++ == 0) {
      EXPECT_NEAR(last, 0.451523640985730904, 1e-9);
      EXPECT_NE(note.find(", energy lost 14.715 J; then all are open"), std::string::npos) << note;
    }
  }
  EXPECT_GT(impacts, 5);
  EXPECT_NEAR(last, 1.354570922957192713, 1e-8);
}

// The loop stays closed to rounding although nothing but its rates is integrated.
TEST(SimulateContacts, KeepsALoopClosedBetweenAndAtImpacts) {
  const Outcome outcome = run(stopped_loop, {"simulate", "--to", "0.8", "--step", "0.05"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  for (std::size_t k = 0; k < motion.rows.size(); ++k) {
    EXPECT_NEAR(motion.at(k, "a") + motion.at(k, "b"), 0, 1e-14);
    EXPECT_NEAR(motion.at(k, "c"), motion.at(k, "a"), 1e-14);
    EXPECT_LE(motion.at(k, "a"), 1.4 + 1e-14);
    const std::size_t before = k == 0 ? 0 : k - 1;
    EXPECT_LE(motion.at(k, "mechanical_energy"), motion.at(before, "mechanical_energy") + 1e-9);
  }
  EXPECT_NEAR(motion.end("a"), 1.4, 1e-14);
  // Three weights, each at 1 m sin(1.4), press on the stop; what of it dry friction carries is its own affair.
  EXPECT_NEAR(motion.end("a_upper_N") - motion.end("bearing_T"), 3 * 9.81 * std::sin(1.4), 1e-9);
}

/// A solid sphere that rolls over a floor which resists by h N.
Scene rolling_ball() {
  Scene scene("rolling_ball", "");
  const Expression R = Expression::quantity("0.1", "m");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), a = scene.coordinate("a", "rad");
  scene.initial(x, 0, 1);
  scene.initial(z, R);
  scene.initial(a, 0, 10);
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle ball = scene.revolute("ball", scene.prismatic("lift", slide, axis::z, z), axis::y, a);
  scene.body("ball", ball, Inertia::solid_sphere(Expression::quantity("1", "kg"), R));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.contact("floor", shape::Sphere{.frame = ball, .radius = R}, shape::Plane{.frame = scene.ground()},
                {.friction = Expression(Number::rational(1, 2)), .rolling = Expression::quantity("0.01", "m")});
  return scene;
}

// It slows down by 5/7 h g/R, and rests after v^2/2 over that.
TEST(SimulateContacts, BringsABallThatRollsToRest) {
  const Outcome outcome = run(rolling_ball, {"simulate", "--to", "2", "--step", "0.1"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  const double slows = 5.0 / 7 * 0.01 * 9.81 / 0.1;
  EXPECT_NEAR(motion.at(10, "x'"), 1 - slows, 1e-9);
  EXPECT_NEAR(motion.at(10, "floor_rolling_T"), -0.01 * 9.81, 1e-9);
  EXPECT_NEAR(motion.end("x"), 1 / (2 * slows), 1e-8);
  EXPECT_NEAR(motion.end("x'"), 0, 1e-12);
}

/// A rod of length 2 and mass 1 that slides on its foot x, leaning by θ from the floor.
Scene sliding_rod() {
  Scene scene("sliding_rod", "");
  const Expression f = scene.run_time_parameter("f", "1", 2);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), turn = scene.coordinate("turn", "rad");
  scene.initial(x, 0, Expression::quantity("-1", "m/s"));
  scene.initial(turn, Expression(Number::rational(-11, 10)), Expression::quantity("0", "rad/s"));
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  const FrameHandle rod = scene.revolute("rod", lift, axis::y, turn);
  const Expression l = Expression::quantity("1", "m");
  scene.body("rod", rod, Inertia::rod(Expression::quantity("1", "kg"), 2 * l, 0).at({l, 0, 0}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.contact("foot", shape::Point{.point = scene.point("tip", rod, {})}, shape::Plane{.frame = scene.ground()}, {.friction = f});
  return scene;
}

TEST(SimulateContacts, TellsTheStateInWhichNoRegimesExist) {
  // (1 + 3 c^2 - 3 f s c) N = g - ... has no N >= 0 where the left is negative: f > 1.333 at 1.1 rad.
  const Outcome none = run(sliding_rod, {"simulate"});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.err.find("no regimes fulfil the laws of contact"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find("contact 'foot'; regimes until then: foot slides; regimes found: none; state: x = 0, z = 0, turn = -1.1, x' = -1, "),
            std::string::npos) << none.err;
  EXPECT_EQ(run(sliding_rod, {"simulate", "--run-time", "f=1.3", "--to", "0.001"}).code, 0);
}

// On its way to no regimes the foot stops at once, by an impulse (Génot & Brogliato 1999), and the rod falls from there.
TEST(SimulateContacts, EndsASlipByAnImpulseWhereThatIsAskedFor) {
  const Outcome goes_on = run(sliding_rod, {"simulate", "--impact-without-collision", "--to", "0.01"});
  EXPECT_EQ(goes_on.code, 0) << goes_on.err;
  EXPECT_NE(goes_on.err.find("impact"), std::string::npos) << goes_on.err;
  EXPECT_GT(table(goes_on.out).end("x'"), -0.5);
}

/// Three balls of equal masses in a row, of which the first strikes the second, which touches the third.
Scene cradle() {
  Scene scene("cradle", "");
  const Expression r = Expression::quantity("0.1", "m");
  std::vector<FrameHandle> balls;
  for (int i = 0; i < 3; ++i) {
    const std::string name = "b" + std::to_string(i);
    const Expression x = scene.coordinate("x" + std::to_string(i), "m");
    balls.push_back(scene.prismatic(name, scene.ground(), axis::x, x, {.origin = {2 * i * r, 0, 0}}));
    scene.body(name, balls.back(), Inertia::point(Expression::quantity("1", "kg")));
    scene.initial(x, 0, Expression::quantity(i == 0 ? "1" : "0", "m/s"));
  }
  for (int i = 0; i < 2; ++i) {
    scene.contact("k" + std::to_string(i), shape::Sphere{.frame = balls[static_cast<std::size_t>(i)], .radius = r},
                  shape::Sphere{.frame = balls[static_cast<std::size_t>(i) + 1], .radius = r}, {.restitution = 1});
  }
  return scene;
}

// One after the other the last ball leaves alone; Moreau's law, for all contacts at once, has v+ = (-1/3, 2/3, 2/3).
TEST(SimulateContacts, TakesTheLawOfImpactThatIsAskedFor) {
  const MotionTable together = table(run(cradle, {"simulate", "--to", "0.1"}).out);
  EXPECT_NEAR(together.end("x0'"), -1.0 / 3, 1e-12);
  EXPECT_NEAR(together.end("x1'"), 2.0 / 3, 1e-12);
  EXPECT_NEAR(together.end("x2'"), 2.0 / 3, 1e-12);
  const MotionTable in_turn = table(run(cradle, {"simulate", "--to", "0.1", "--impact-law", "sequential"}).out);
  EXPECT_NEAR(in_turn.end("x0'"), 0, 1e-12);
  EXPECT_NEAR(in_turn.end("x1'"), 0, 1e-12);
  EXPECT_NEAR(in_turn.end("x2'"), 1, 1e-12);
  const Outcome unknown = run(cradle, {"simulate", "--impact-law", "poison"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("unknown law 'poison' in --impact-law: did you mean 'poisson'? use newton_moreau"), std::string::npos)
      << unknown.err;
}

TEST(SimulateContacts, NamesTheContactThatEndsIt) {
  // With the scene's own parameters the start is judged before; with others by the motion.
  const Outcome before = run(dropped, {"simulate", "--initial", "z=-0.5"});
  EXPECT_EQ(before.code, 3);
  EXPECT_NE(before.err.find("contact 'floor' starts penetrating"), std::string::npos) << before.err;
  const Outcome below = run(dropped, {"simulate", "--initial", "z=-0.5", "--run-time", "e=0.5"});
  EXPECT_EQ(below.code, 1);
  EXPECT_NE(below.err.find("starts below its surface"), std::string::npos) << below.err;
  EXPECT_NE(below.err.find("contact 'floor' at t = 0 s"), std::string::npos) << below.err;
  const std::string picture = testing::TempDir() + "below.svg";
  const Outcome drawn = run(dropped, {"simulate", "--initial", "z=-0.5", "--run-time", "e=0.5", "--plot", picture, "z"});
  EXPECT_EQ(drawn.code, 1);
  EXPECT_NE(drawn.err.find("starts below its surface"), std::string::npos) << drawn.err;
  const Outcome lively = run(dropped, {"simulate", "--run-time", "e=1.5"});
  EXPECT_EQ(lively.code, 2);
  EXPECT_NE(lively.err.find("contact 'floor' has the restitution e = 1.5: it must lie between 0 and 1; that is so with "
                            "--run-time e=1.5: give another value"),
            std::string::npos)
      << lively.err;
  const Outcome hollow = run(sized, {"simulate", "--run-time", "r=-0.1"});
  EXPECT_EQ(hollow.code, 2);
  EXPECT_NE(hollow.err.find("has the radius r = -0.1: give the size of what touches the plane"), std::string::npos) << hollow.err;
  EXPECT_EQ(run(dropped, {"simulate", "--no-projection"}).code, 2);
  const Outcome fixed = run(dropped, {"simulate", "--method", "gauss"});
  EXPECT_EQ(fixed.code, 2);
  EXPECT_NE(fixed.err.find("--method gauss is for motions without contacts"), std::string::npos) << fixed.err;
}

// Closed form: it falls 1 m and rises to 1/4 m, so that it passes 1/5 m three times before its second impact.
TEST(SimulateContacts, WritesRowsWhereAFormulaPassesZero) {
  constexpr double g = 9.81;
  const double strikes = std::sqrt(2 / g), up = g * strikes / 2;
  const auto rises = [&](double z, double sign) { return strikes + (up + sign * std::sqrt(up * up - 2 * g * z)) / g; };
  const Outcome outcome = run(dropped, {"simulate", "--to", "0.8", "--step", "0.4", "--events", "low: z = 0.2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = table(outcome.out).rows;
  const std::vector<double> times{0, 0.4, std::sqrt(1.6 / g), rises(0.2, -1), rises(0.2, 1), 0.8};
  ASSERT_EQ(rows.size(), times.size()) << outcome.out;
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(rows[i][0], times[i], 1e-9);
    if (i >= 2 && i <= 4) {
      EXPECT_NEAR(rows[i][1], 0.2, 1e-9);
    }
  }
  const std::size_t low = outcome.out.find("# Event: low at t = 0.40");
  const std::size_t impact = outcome.out.find("# Event: impact of floor at t = 0.45");
  EXPECT_LT(low, impact) << outcome.out;
  EXPECT_LT(impact, outcome.out.find("# Event: low at t = 0.57")) << outcome.out;
}

TEST(SimulateContacts, EndsWhereItIsTold) {
  for (const char* method : {"dp853", "radau"}) {
    const Outcome outcome = run(dropped, {"simulate", "--to", "5", "--until", "z' = 0.3", "--method", method});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    // The impact takes the velocity from below zero past that of the formula.
    const auto rows = table(outcome.out).rows;
    EXPECT_NEAR(rows.back()[0], std::sqrt(2 / 9.81), 1e-8) << outcome.out;
    EXPECT_NE(outcome.err.find("event: z' = 0.3 at t = 0.45"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("the motion ends"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace torsor::simulate_contacts_test
