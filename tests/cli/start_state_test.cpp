// SPDX-License-Identifier: GPL-3.0-or-later
// Starts that do not stand: what is said of them, and motions that start elsewhere.
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::start_state_test {
namespace {

using namespace testing_programs;
using namespace torsor::literals;

/// A rod between two stops, which starts below the lower one.
Scene beyond_its_stop() {
  Scene scene("beyond_its_stop", "");
  const Expression turn = scene.coordinate("turn", "rad");
  const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, turn);
  scene.body("rod", rod, Inertia::rod(Expression::quantity("1", "kg"), Expression::quantity("1", "m"), 0));
  scene.stop(turn, 1, 2);
  return scene;
}

/// A slider-crank by two conditions, x along the slider, crank 0.2 m, rod 0.5 m.
Scene slider_crank(const Expression& theta, const Expression& phi, const Expression& x, const Triple& weight = {1, 0, 0}) {
  Scene scene("slider_crank", "");
  const Expression r = scene.parameter("r", "m", Expression::quantity("0.2", "m")), l = scene.parameter("l", "m", Expression::quantity("0.5", "m"));
  const Expression kg = Expression::quantity("1", "kg");
  const Expression a = scene.coordinate("theta", "rad"), b = scene.coordinate("phi", "rad"), s = scene.coordinate("x", "m");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const FrameHandle rod = scene.revolute("rod", crank, axis::z, b, {.origin = {r, 0, 0}});
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, s);
  scene.body("crank", crank, Inertia::rod(kg, r, 0).at({r / 2, 0, 0}));
  scene.body("rod", rod, Inertia::rod(kg, l, 0).at({l / 2, 0, 0}));
  scene.body("slider", slider, Inertia::point(2 * kg));
  const Expression g = Expression::quantity("9.81", "m/s^2");
  scene.gravity({weight[0] * g, weight[1] * g, weight[2] * g});
  const PointHandle end = scene.point("rod_end", rod, {l, 0, 0}), pin = scene.point("pin", slider, {0, 0, 0});
  scene.closure("close_x", end, pin, axis::x);
  scene.closure("close_y", end, pin, axis::y);
  scene.initial(a, theta);
  scene.initial(b, phi);
  scene.initial(s, x);
  return scene;
}

Expression metres(const char* number) { return Expression::quantity(number, "m"); }

Scene nearly_closed() { return slider_crank(0.1, -0.14, metres("0.7")); }

Scene far_from_closed() {
  Scene scene = slider_crank(0, 0, metres("0.7"));
  const Expression x(scene.content().coordinates[2].q);
  scene.holonomic("far", x - metres("5"));
  return scene;
}

/// Hangs from a ball joint, its end in the plane 0.6 m below; starts with its end 1 m below.
Scene ball_on_a_plane() {
  Scene scene("ball_on_a_plane", "");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle rod = scene.spherical("rod", scene.ground(), e);
  const Expression kg = Expression::quantity("1", "kg");
  scene.body("rod", rod, Inertia::general({.mass = kg, .xx = kg * metres("1") * metres("1"), .yy = kg * metres("1") * metres("1"),
                                           .zz = kg * metres("1") * metres("1")}));
  const FrameHandle plane = scene.weld("plane", scene.ground(), {.origin = {0, 0, metres("-0.6")}});
  scene.point_in_plane("slide", scene.point("end", rod, {0, 0, metres("-1")}), plane);
  scene.initial(e, {0.8, 0.1, 0, 0});
  return scene;
}

TEST(StartState, OfASceneThatBeginsBeyondAStopMayBeGivenElsewhere) {
  const Outcome own = run(beyond_its_stop, {"simulate", "--to", "0.1"});
  expect_failure_beginning(own, 3, "contact 'turn_lower' starts penetrating: its gap is -1 at t = 0");
  const Outcome inside = run(beyond_its_stop, {"simulate", "--to", "0.1", "--initial", "turn=1.5"});
  ASSERT_EQ(inside.code, 0) << inside.err;
  EXPECT_EQ(table(inside.out).at(0, "turn"), 1.5);
  const Outcome outside = run(beyond_its_stop, {"simulate", "--to", "0.1", "--initial", "turn=2.5"});
  expect_failure_beginning(outside, 3, "contact 'turn_upper' starts penetrating: its gap is -0.5 at t = 0");
  EXPECT_NE(outside.err.find("; the start is the one of --initial"), std::string::npos) << outside.err;
  EXPECT_EQ(run(beyond_its_stop, {"report", "--to", "0.1", "--initial", "turn=1.5"}).code, 0);
}

TEST(StartState, ThatIsGivenIsJudgedWhereTheOwnOneStandsToo) {
  const auto inside = [] {
    Scene scene = beyond_its_stop();
    scene.initial(Expression(scene.content().coordinates[0].q), Expression(1.5_r));
    return scene;
  };
  for (const char* command : {"simulate", "report"}) {
    EXPECT_EQ(run(inside, {command, "--to", "0.1"}).code, 0) << command;
    const Outcome outside = run(inside, {command, "--to", "0.1", "--initial", "turn=2.5"});
    expect_failure_beginning(outside, 3, "contact 'turn_upper' starts penetrating: its gap is -0.5 at t = 0");
  }
}

// The rod of 0.7 m closes the loop with the crank near 0.3 rad; with its own 0.5 m the crank goes back to 0.02 rad.
TEST(StartState, IsClosedWithTheParametersOfTheCommand) {
  const Outcome outcome = run(nearly_closed, {"simulate", "--to", "0.1", "--initial", "theta=0.3", "--run-time", "l=0.7"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  const double theta = motion.at(0, "theta"), phi = motion.at(0, "phi");
  EXPECT_NEAR(0.2 * std::sin(theta) + 0.7 * std::sin(theta + phi), 0, 1e-14);  // some roundings of terms below 1
  EXPECT_NEAR(0.2 * std::cos(theta) + 0.7 * std::cos(theta + phi), motion.at(0, "x"), 1e-14);
  EXPECT_GT(theta, 0.2);
}

// Equations that repeat others where the loop is closed look independent beside it, and one of them is all rounding there: a
// start in sixteen digits stays where it is, and moves as the whole loop does.
TEST(StartState, OfALoopThatMovesAgainstTheCountStays) {
  const auto heavy = [] {
    Scene scene = testing_mechanisms::bennett_in_digits();
    for (const char* name : {"first", "second", "third"}) {
      scene.body(name, name, Inertia::solid_sphere(Expression::quantity("1", "kg"), metres("0.2")).at({metres("0.5"), 0, 0}));
    }
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
    return scene;
  };
  const Outcome outcome = run(heavy, {"simulate", "--to", "1", "--step", "0.25", "--tolerance", "1e-11"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  EXPECT_NEAR(motion.at(0, "theta_1"), 0.7, 1e-14);
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    const double first = motion.at(row, "theta_1"), second = motion.at(row, "theta_2");
    EXPECT_NEAR(std::tan(first / 2) * std::tan(second / 2), std::sqrt(3.0), 1e-12) << row;
    EXPECT_NEAR(motion.at(row, "theta_3"), -first, 1e-13) << row;
    EXPECT_NEAR(motion.at(row, "mechanical_energy"), motion.at(0, "mechanical_energy"), 1e-8) << row;
  }
  EXPECT_GT(std::abs(motion.end("theta_1") - 0.7), 0.1);
}

/// A four-bar of 0.3, 0.8, 0.5 and 0.9 m whose plane is tilted about x, and its weight with it. Its last pin is spherical: one of the
/// three conditions holds in any case, and is rounding in double.
template <int twelfths>
Scene tilted_four_bar() {
  Scene scene("tilted_four_bar", "");
  const FrameHandle base = scene.weld("base", scene.ground(), {{0, 0, 0}, Rotation::about(0, twelfths)});
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle crank = scene.revolute("crank", base, axis::z, a);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, b, {.origin = {metres("0.3"), 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", base, axis::z, c, {.origin = {metres("0.9"), 0, 0}});
  const auto rod = [&](const char* name, const FrameHandle& frame, const Expression& length) {
    scene.body(name, frame, Inertia::rod(Expression::quantity("1", "kg"), length, 0).at({length / 2, 0, 0}));
  };
  rod("crank", crank, metres("0.3"));
  rod("coupler", coupler, metres("0.8"));
  rod("rocker", rocker, metres("0.5"));
  const FrameHandle end = scene.weld("end", coupler, {.origin = {metres("0.8"), 0, 0}});
  const FrameHandle rocker_end = scene.weld("rocker_end", rocker, {.origin = {metres("0.5"), 0, 0}});
  scene.loop_joint("pin", {.type = JointType::spherical, .a = end, .b = rocker_end});
  scene.initial(a, 1);
  scene.initial(b, Expression::quantity("-0.6860825234263741", "rad"));
  scene.initial(c, Expression::quantity("1.524788785804704", "rad"));
  const Expression g = Expression::quantity("-9.81", "m/s^2"), tilt = twelfths * pi() / 12;
  scene.gravity({0, g * cos(tilt), g * sin(tilt)});
  return scene;
}

TEST(StartState, OfAPlaneLoopIsKeptHoweverItsPlaneIsTilted) {
  const auto moved = [](Scene (*make)()) {
    const Outcome outcome = run(make, {"simulate", "--to", "0.4", "--step", "0.2"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return table(outcome.out);
  };
  const MotionTable level = moved(tilted_four_bar<0>);
  EXPECT_GT(std::abs(level.end("a") - 1), 0.1);
  for (const auto make : {tilted_four_bar<1>, tilted_four_bar<2>, tilted_four_bar<3>, tilted_four_bar<5>}) {
    const MotionTable tilted = moved(make);
    ASSERT_EQ(tilted.rows.size(), level.rows.size());
    for (std::size_t row = 0; row < level.rows.size(); ++row) {
      for (const char* name : {"a", "b", "c"}) EXPECT_NEAR(tilted.at(row, name), level.at(row, name), 1e-8) << row << " " << name;
    }
  }
}

// A stop is in the way of what closes the loop: nothing is proposed.
TEST(StartState, IsNotProposedWhereAContactIsInTheWay) {
  const auto blocked = [] {
    Scene scene = nearly_closed();
    scene.stop(Expression(scene.content().coordinates[2].q), metres("0.1"), metres("0.69"));
    return scene;
  };
  const Outcome outcome = run(blocked, {"equations"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err.find("a state nearby"), std::string::npos) << outcome.err;
}

// What the message proposes is a start that stands: crank and rod close the loop where r sin θ + l sin(θ + φ) = 0 and
// r cos θ + l cos(θ + φ) = x.
TEST(StartState, ThatLeavesALoopOpenIsToldWithTheNearestClosedOne) {
  const Outcome open = run(nearly_closed, {"equations"});
  expect_failure_beginning(open, 3, "inconsistent initial state: constraint 'close_x' has the value");
  double theta = 0, phi = 0, x = 0;
  const std::size_t at = open.err.find("a state nearby that fulfils all: ");
  ASSERT_NE(at, std::string::npos) << open.err;
  ASSERT_EQ(std::sscanf(open.err.c_str() + at, "a state nearby that fulfils all: initial(theta, %lf), initial(phi, %lf), initial(x, %lf)",
                        &theta, &phi, &x), 3) << open.err;
  EXPECT_NEAR(0.2 * std::sin(theta) + 0.5 * std::sin(theta + phi), 0, 1e-14);  // some roundings of terms below 1
  EXPECT_NEAR(0.2 * std::cos(theta) + 0.5 * std::cos(theta + phi), x, 1e-14);
  EXPECT_NEAR(theta, 0.1, 0.1);  // the loop was open by 1.4 mm along x, which turns the crank by that over 0.2 m sin(0.1)
  EXPECT_NEAR(phi, -0.14, 0.1);
}

// A crank that the scene starts at 3 rad/s keeps its speed: rod and slider, of which nothing is said, follow.
TEST(StartState, IsProposedWithWhatTheSceneGives) {
  const auto turning = [] {
    Scene scene = slider_crank(0, 0, metres("0.7"));
    const auto q = [&scene](std::size_t k) { return Expression(scene.content().coordinates[k].q); };
    scene.initial(q(0), 0, Expression::quantity("3", "rad/s"));
    return scene;
  };
  const Outcome open = run(turning, {"equations"});
  double rate = 0;
  const std::size_t at = open.err.find("a state nearby that fulfils all: ");
  ASSERT_NE(at, std::string::npos) << open.err;
  ASSERT_EQ(std::sscanf(open.err.c_str() + at, "a state nearby that fulfils all: initial(phi, 0, %lf)", &rate), 1) << open.err;
  EXPECT_NEAR(rate, -4.2, 1e-14);  // 0.2 m 3 + 0.5 m (3 + rate) = 0, a few roundings
  EXPECT_EQ(open.err.find("initial(theta"), std::string::npos) << open.err;
}

struct Started {
  MotionTable motion;
  std::string notes;
};

/// The crank whose loop is nearly closed, from the start that is given; its loop is closed there.
Started started(const char* initial) {
  const Outcome outcome = run(nearly_closed, {"simulate", "--to", "0.1", "--initial", initial});
  if (outcome.code != 0) throw std::runtime_error(outcome.err);
  Started start{table(outcome.out), outcome.err};
  const double theta = start.motion.at(0, "theta"), phi = start.motion.at(0, "phi");
  EXPECT_NEAR(0.2 * std::sin(theta) + 0.5 * std::sin(theta + phi), 0, 1e-14);  // some roundings of terms below 1
  EXPECT_NEAR(0.2 * std::cos(theta) + 0.5 * std::cos(theta + phi), start.motion.at(0, "x"), 1e-14);
  return start;
}

// A crank's angle and speed are given; rod and slider follow: r θ' cos θ + l (θ' + φ') cos(θ + φ) = 0.
TEST(StartState, KeepsWhatIsGivenWhereTheOthersCanFollow) {
  const auto [motion, notes] = started("theta=0.5,theta'=10");
  const double theta = motion.at(0, "theta"), phi = motion.at(0, "phi");
  EXPECT_EQ(theta, 0.5);
  EXPECT_EQ(motion.at(0, "theta'"), 10);
  EXPECT_NEAR(0.2 * 10 * std::cos(theta) + 0.5 * (10 + motion.at(0, "phi'")) * std::cos(theta + phi), 0, 1e-12);  // of terms of 10
  EXPECT_EQ(notes, "");
}

// Crank, rod and slider are given, and do not meet: with the crank at 0.5 rad the slider is at 0.6662 m. Both give way.
TEST(StartState, ChangesWhatIsGivenWhereItDoesNotFitTogether) {
  const auto [motion, notes] = started("theta=0.5,phi=-0.7,x=0.65");
  EXPECT_GT(motion.at(0, "theta"), 0.5);
  EXPECT_GT(motion.at(0, "x"), 0.65);
  EXPECT_LT(motion.at(0, "x"), 0.6662);
  EXPECT_NE(notes.find("the constraints do not allow what --initial gives: the motion starts at theta = 0.55"), std::string::npos)
      << notes;
}

TEST(StartState, ThatCannotBeClosedNamesTheConstraintThatStaysOpen) {
  const Outcome outcome = run(far_from_closed, {"simulate", "--to", "0.1", "--initial", "theta=0.1"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("cannot be closed near the start: constraint 'far' has the value -4.3 m there"), std::string::npos) << outcome.err;
}

TEST(StartState, OfAnAttitudeIsToldAsOne) {
  const Outcome outcome = run(ball_on_a_plane, {"equations"});
  std::array<double, 4> e{};
  const std::size_t at = outcome.err.find("fulfils all: ");
  ASSERT_NE(at, std::string::npos) << outcome.err;
  ASSERT_EQ(std::sscanf(outcome.err.c_str() + at, "fulfils all: initial(e, {%lf, %lf, %lf, %lf}, {0, 0, 0})", &e[0], &e[1], &e[2], &e[3]), 4)
      << outcome.err;
  EXPECT_NEAR(1 - 2 * (e[1] * e[1] + e[2] * e[2]), 0.6, 1e-14);  // the component of the rod along z
}

Scene with_friction() {
  Scene scene = slider_crank(0, 0, metres("0.7"));
  scene.dry_friction("slide", Expression(scene.content().coordinates[2].q), {.bound = Expression::quantity("5", "N")});
  return scene;
}

// Weight turns the crank, the slider cannot move there, and nothing tells the force of its friction.
TEST(StartState, AtRestAtADeadCentreWithFrictionIsNamed) {
  const auto pulled_aside = [] {
    Scene scene = slider_crank(0, 0, metres("0.7"), {0, 1, 0});
    scene.dry_friction("slide", Expression(scene.content().coordinates[2].q), {.bound = Expression::quantity("5", "N")});
    return scene;
  };
  const Outcome outcome = run(pulled_aside, {"simulate", "--to", "1"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("at t = 0 s the mechanism is at a dead centre of 'slide'"), std::string::npos) << outcome.err;
}

// Each swing loses the same part of its energy: the motion dies away towards the dead centre, where the slider, and its friction
// with it, does not move. It goes on to its end: no decision there takes a velocity away.
TEST(StartState, DiesAwayTowardsADeadCentreWithFriction) {
  const Outcome outcome = run(with_friction, {"simulate", "--to", "10", "--step", "1", "--initial", "theta'=3,phi'=-4.2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  double before = 1;
  for (const double time : {2.0, 4.0, 6.0, 8.0, 10.0}) {
    const double energy = motion.at(static_cast<std::size_t>(time), "kinetic_energy") +
                          motion.at(static_cast<std::size_t>(time), "potential_energy") + 19.1295;
    EXPECT_LT(energy, before / 10) << time;  // 1e-9 J at the end, where rounding of 19 J is below 1e-14
    EXPECT_GT(energy, 0) << time;
    before = energy;
  }
}

// A crank passes its dead centre, at which friction changes its direction: energy is what friction takes over the slider's path.
TEST(StartState, PassesADeadCentreWithFriction) {
  const Outcome outcome = run(with_friction, {"simulate", "--to", "0.25", "--step", "0.05", "--initial", "theta'=3,phi'=-4.2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  EXPECT_LT(motion.at(4, "theta'"), -2);  // at 0.2 s it is beyond, and goes on
  const double lost = motion.at(4, "mechanical_energy") - motion.at(5, "mechanical_energy");
  EXPECT_NEAR(lost, 5 * (motion.at(4, "x") - motion.at(5, "x")), 1e-9);  // ten steps of 1e-10 of some 20 J lose less
}

// The slider's acceleration vanishes there with the crank's angle, although its terms do not.
TEST(StartState, NearADeadCentreIsNamedByVerify) {
  const Outcome outcome = run([] { return slider_crank(0, 0, metres("0.7")); },
                              {"verify", "--scalar", "double", "--kernels", "forward_dynamics", "--states", "64"});
  ASSERT_EQ(outcome.code, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("near a dead centre of 'x': the constraints hardly let it move there"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("--exceptions FILE accepts what is known"), std::string::npos) << outcome.err;
}

TEST(StartState, NearAChangePointIsNamedByVerify) {
  const Outcome outcome = run([] { return testing_mechanisms::parallelogram(testing_mechanisms::Angle::absolute, 1); },
                              {"verify", "--scalar", "double", "--kernels", "forward_dynamics", "--states", "64"});
  ASSERT_EQ(outcome.code, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("near a change point: the other constraints leave"), std::string::npos) << outcome.out;
}

// Values that a command is given are looked at as the scene's own are.
TEST(StartState, RefusesAMassThatRunTimeMakesNegative) {
  const auto two_masses = [] {
    Scene scene("two_masses");
    const Expression m = scene.parameter("m", "kg", 1), n = scene.run_time_parameter("n", "1", 2);
    const Expression a = scene.run_time_parameter("a", "kg m^2", 1), turn = scene.coordinate("turn", "rad");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, turn);
    scene.body("arm", arm, Inertia::rod(m * n, Expression::quantity("1", "m"), 0));
    scene.reflected_inertia("motor", turn, a);
    return scene;
  };
  const std::string remedy = "; that is so with --run-time ", other = ": give another value";
  const auto refused = [&](const std::string& values, const std::string& what) {
    expect_failure(run(two_masses, {"simulate", "--run-time", values}), 2, what + other);
  };
  const std::string mass = ": a mass is never negative; subtract a hole from the body it is cut from, as in "
                           "Inertia::box(...) - Inertia::cylinder(...)" + remedy;
  refused("m=-1", "body 'arm' has the mass m*n = -2 kg" + mass + "m=-1");
  refused("n=-3,a=2", "body 'arm' has the mass m*n = -3 kg" + mass + "n=-3");
  refused("a=-0.5", "reflected inertia 'motor' is a = -0.5 and must not be negative: it is N^2 J of a rotor of inertia J behind "
                    "a gear of ratio N" + remedy + "a=-0.5");
  EXPECT_EQ(run(two_masses, {"simulate", "--to", "0.1", "--run-time", "m=-3,n=-8,a=0"}).code, 0);
}

// A trolley needs no mass of its own: its pendulum has one, and without that nothing holds the angle.
TEST(StartState, RefusesAMassOfZeroWithoutWhichNothingIsMoved) {
  const auto crane = [] {
    Scene scene("crane");
    const Expression M = scene.parameter("M", "kg", 4), m = scene.run_time_parameter("m", "kg", 1);
    const Expression l = scene.run_time_parameter("l", "m", 1), x = scene.coordinate("x", "m");
    const Expression theta = scene.coordinate("theta", "rad");
    const FrameHandle trolley = scene.prismatic("trolley", scene.ground(), axis::x, x);
    scene.body("trolley", trolley, Inertia::point(M));
    scene.body("load", scene.revolute("rod", trolley, axis::y, theta), Inertia::point(m).at({0, 0, -l}));
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
    scene.initial(theta, 1);
    return scene;
  };
  for (const std::string value : {"m=0", "l=0"}) {
    expect_failure(run(crane, {"simulate", "--run-time", "M=2," + value}), 2,
                   "the mass matrix is singular at every state: coordinate 'theta' can accelerate without moving any mass; it "
                   "moves body 'load': give masses or inertias, or remove a redundant coordinate; that is so with --run-time " +
                       value + ": give another value");
  }
  const Outcome light = run(crane, {"simulate", "--to", "0.1", "--run-time", "M=0"});
  EXPECT_EQ(light.code, 0) << light.err;
  EXPECT_EQ(light.out.find("It ends before"), std::string::npos) << light.out;
}

TEST(StartState, RefusesStopsThatRunTimeExchanges) {
  const auto stopped = [] {
    Scene scene("stopped");
    const Expression low = scene.parameter("low", "rad", -1), high = scene.run_time_parameter("high", "rad", 1);
    const Expression turn = scene.coordinate("turn", "rad");
    const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, turn);
    scene.body("rod", rod, Inertia::rod(Expression::quantity("1", "kg"), Expression::quantity("1", "m"), 0));
    scene.stop(turn, low, high);
    return scene;
  };
  expect_failure(run(stopped, {"simulate", "--run-time", "low=2"}), 2,
                 "the stop 'turn_lower' at low = 2 is not below 'turn_upper' at high = 1: give it a smaller place; that is so "
                 "with --run-time low=2: give another value");
  EXPECT_EQ(run(stopped, {"simulate", "--to", "0.1", "--run-time", "low=-2,high=3"}).code, 0);
}

// Components that are given with others of the scene would not stay what they are.
TEST(StartState, TakesWholeQuaternions) {
  const auto turned = [] {
    Scene scene("turned");
    const FrameHandle body = scene.spherical("body", scene.ground(), scene.attitude("e"));
    const Expression moment = Expression::quantity("1", "kg m^2");
    const Expression mass = Expression::quantity("1", "kg");
    scene.body("body", body, Inertia::general({.mass = mass, .xx = moment, .yy = moment, .zz = moment}));
    return scene;
  };
  expect_failure(run(turned, {"simulate", "--to", "1", "--initial", "e_w=0.5,e_x=0.5,e_z=0.5"}), 2,
                 "--initial gives some components of the attitude 'e' without e_y: give all four, which are normalised, or none");
  const Outcome whole = run(turned, {"simulate", "--to", "1", "--step", "1", "--initial", "e_w=2,e_x=0,e_y=0,e_z=0"});
  EXPECT_EQ(whole.err, "note: --initial gives the attitude 'e' a quaternion of norm 2, which is normalised\n");
  EXPECT_EQ(table(whole.out).at(0, "e_w"), 1);
  EXPECT_EQ(run(turned, {"simulate", "--to", "1", "--initial", "e_w=0.6,e_x=0.8,e_y=0,e_z=0"}).err, "");
}

}  // namespace
}  // namespace torsor::start_state_test
