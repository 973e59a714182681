// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "tests/cli/motion_table.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::simulate_joint_friction_test {
namespace {

using testing_programs::Outcome;
using testing_programs::run;
using testing_programs::MotionTable;
using testing_programs::table;

constexpr double g = 9.81;

/// A bead on a rod that rises by atan(3/4), pushed by a horizontal force F.
Scene bead_on_a_rod() {
  Scene scene("bead_on_a_rod", "");
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression f = scene.run_time_parameter("f", "1", Expression(Number::rational(1, 4)));
  const Expression F = scene.run_time_parameter("F", "N", 10);
  const Expression s = scene.coordinate("s", "m");
  scene.initial(s, 0, 3);
  const Triple along{Expression(Number::rational(4, 5)), 0, Expression(Number::rational(3, 5))};
  const FrameHandle bead = scene.prismatic("bead", scene.ground(), along, s);
  scene.body("bead", bead, Inertia::point(m));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.force("push", {.body = bead, .point = scene.point("P", bead, {0, 0, 0}), .components = {F, 0, 0}, .axes = scene.ground()});
  scene.joint_friction("rub", bead, {.friction = f});
  return scene;
}

/// A trolley on a level rail, from which a point hangs by a rod; the rail rubs in proportion to what it carries, and the
/// hinge by the radius of its journal.
Scene trolley() {
  Scene scene("trolley", "");
  const Expression x = scene.coordinate("x", "m"), a = scene.coordinate("a", "rad");
  scene.initial(x, 0, 2);
  scene.initial(a, 1, Expression(Number::rational(1, 2)));
  const FrameHandle car = scene.prismatic("car", scene.ground(), axis::x, x);
  const FrameHandle rod = scene.revolute("rod", car, -axis::y, a);
  scene.body("car", car, Inertia::point(Expression::quantity("3", "kg")));
  scene.body("rod", rod, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, Expression::quantity("-1", "m")}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.joint_friction("rail", car, {.friction = Expression(Number::rational(1, 5))});
  scene.joint_friction("hinge", rod, {.friction = Expression(Number::rational(1, 10)), .radius = Expression::quantity("0.2", "m")});
  return scene;
}

/// A rod that falls along a vertical guide onto a smooth wedge of 45°, which it pushes aside over a smooth rail; 4 N press the
/// rod against its guide.
Scene rod_on_a_wedge() {
  Scene scene("rod_on_a_wedge", "");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle wedge = scene.prismatic("wedge", scene.ground(), axis::x, x);
  const FrameHandle rod = scene.prismatic("rod", scene.ground(), axis::z, z);
  scene.body("wedge", wedge, Inertia::point(Expression::quantity("3", "kg")));
  scene.body("rod", rod, Inertia::point(Expression::quantity("2", "kg")));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const FrameHandle face = scene.weld("face", wedge, {.rotation = Rotation::about(1, 3)});
  const PointHandle tip = scene.point("P", rod, {0, 0, 0});
  scene.contact("tip", shape::Point{tip}, shape::Plane{.frame = face});
  scene.force("push", {.body = rod, .point = tip, .components = {Expression::quantity("4", "N"), 0, 0}, .axes = scene.ground()});
  scene.joint_friction("guide", rod, {.friction = Expression(Number::rational(3, 10))});
  return scene;
}

/// A crank of 1 m whose pin moves a slider on a level rail, by a slot across (4/5, 3/5): what presses the rail comes by the
/// loop too.
Scene crank_and_slot() {
  Scene scene("crank_and_slot", "");
  const Expression a = scene.coordinate("a", "rad"), x = scene.coordinate("x", "m");
  const Expression metre = Expression::quantity("1", "m"), kg = Expression::quantity("1", "kg");
  scene.initial(a, 0, 3);
  scene.initial(x, metre, Expression::quantity("2.25", "m/s"));
  const FrameHandle crank = scene.revolute("crank", scene.ground(), -axis::y, a);
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, x);
  scene.body("crank", crank, Inertia::point(kg).at({metre, 0, 0}));
  scene.body("slider", slider, Inertia::point(2 * kg));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const PointHandle pin = scene.point("pin", crank, {metre, 0, 0}), slot = scene.point("slot", slider, {0, 0, 0});
  scene.closure("slot", pin, slot, {Expression(Number::rational(4, 5)), 0, Expression(Number::rational(3, 5))});
  scene.joint_friction("rail", slider, {.friction = Expression(Number::rational(1, 5))});
  return scene;
}

// Along the rod m s'' = 4/5 F - 3/5 m g - f |R|, R = 4/5 m g + 3/5 F across it; it stays if the rest is within f |R|.
TEST(JointFriction, StopsABeadOnAnInclinedRodUnderAHorizontalForce) {
  for (const auto& [f, F] : {std::pair(0.25, 10.0), std::pair(0.25, 0.0), std::pair(0.8, 0.0), std::pair(0.25, -40.0)}) {
    const Outcome outcome = run(bead_on_a_rod, {"simulate", "--to", "1", "--step", "0.05", "--run-time",
                                                "f=" + std::to_string(f) + ",F=" + std::to_string(F)});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const MotionTable motion = table(outcome.out);
    const double m = 2, drive = 0.8 * F - 0.6 * m * g, R = std::abs(0.8 * m * g + 0.6 * F);
    const double up = (drive - f * R) / m, stop = -3 / up;
    const double down = std::abs(drive) <= f * R ? 0 : (drive + f * R) / m;
    ASSERT_LT(up, 0);
    for (std::size_t k = 0; k < motion.rows.size(); ++k) {
      const double t = motion.at(k, "time"), after = t - stop;
      const bool rises = t < stop;
      const double s = rises ? 3 * t + up * t * t / 2 : -9 / (2 * up) + down * after * after / 2;
      // The motion is a polynomial: what is left are roundings of numbers up to 5 in some hundred steps.
      EXPECT_NEAR(motion.at(k, "s"), s, 1e-12);
      const double T = rises ? -f * R : down == 0 ? -drive : f * R;
      EXPECT_NEAR(motion.at(k, "rub_T"), T, 1e-11);
    }
  }
}

// Newton's laws for the trolley with its load and for the load alone, with the accelerations that the forces of the table
// give.
TEST(JointFriction, OfARailAndAHingeTogetherFulfilsNewtonsLaws) {
  const Outcome outcome = run(trolley, {"simulate", "--to", "0.2", "--step", "0.02"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  double hinge = 0;
  for (std::size_t k = 0; k < motion.rows.size(); ++k) {
    const double a = motion.at(k, "a"), w = motion.at(k, "a'"), T = motion.at(k, "rail_T"), L = motion.at(k, "hinge_T");
    ASSERT_GT(motion.at(k, "x'"), 0.1);
    ASSERT_GT(std::abs(w), 0.01);
    // 4 x'' + cos a a'' = T + sin a w^2; cos a x'' + a'' = L - g sin a.
    const double c = std::cos(a), s = std::sin(a), right = T + s * w * w, turn = L - g * s;
    const double x2 = (right - c * turn) / (4 - c * c), a2 = turn - c * x2;
    const double R = 4 * g + s * a2 + c * w * w;  // vertical, of the rail
    EXPECT_NEAR(T, -0.2 * std::abs(R), 1e-11);
    const double H = std::hypot(x2 + c * a2 - s * w * w, g + s * a2 + c * w * w);  // of the hinge on the load
    EXPECT_NEAR(L, -0.02 * H * (w > 0 ? 1 : -1), 1e-11);
    hinge = std::max(hinge, std::abs(L));
  }
  EXPECT_GT(hinge, 0.05);
}

// With the normal force N on the rod along (1, 1)/√2: 3 x'' = -N/√2, 2 z'' = -2 g + N/√2 + f (N/√2 + 4), z'' = x''.
TEST(JointFriction, IsPressedByContactsToo) {
  const Outcome outcome = run(rod_on_a_wedge, {"simulate", "--to", "0.2", "--step", "0.05"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  const double side = (2 * g - 0.3 * 4) / (1 + 0.3 + 2.0 / 3);  // N/√2
  for (std::size_t k = 1; k < motion.rows.size(); ++k) {
    EXPECT_NEAR(motion.at(k, "tip_N"), side * std::sqrt(2.0), 1e-11);
    EXPECT_NEAR(motion.at(k, "guide_T"), 0.3 * (side + 4), 1e-11);
    EXPECT_NEAR(motion.at(k, "x"), -side / 6 * std::pow(motion.at(k, "time"), 2), 1e-12);
  }
}

// P is the force of the pin on the slider along (4/5, 3/5), and its opposite on the crank, x = cos a + 3/4 sin a:
// 2 x'' = 4/5 P + T, a'' = -g cos a - 4/5 p P with p = dx/da, R = 2 g - 3/5 P.
TEST(JointFriction, IsPressedByConstraintsToo) {
  const Outcome outcome = run(crank_and_slot, {"simulate", "--to", "0.15", "--step", "0.01"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MotionTable motion = table(outcome.out);
  double most = 0;
  for (std::size_t k = 0; k < motion.rows.size(); ++k) {
    const double a = motion.at(k, "a"), w = motion.at(k, "a'"), T = motion.at(k, "rail_T");
    const double c = std::cos(a), s = std::sin(a), p = 0.75 * c - s, q = -(c + 0.75 * s) * w * w;
    EXPECT_NEAR(motion.at(k, "x"), c + 0.75 * s, 1e-13);
    ASSERT_GT(motion.at(k, "x'"), 0.1);
    const double P = (2 * (q - p * g * c) - T) / (0.8 + 1.6 * p * p);
    EXPECT_NEAR(T, -0.2 * std::abs(2 * g - 0.6 * P), 1e-11);
    most = std::max(most, std::abs(P));
  }
  EXPECT_GT(most, 5);
}

TEST(JointFriction, IsCheckedAgainstNewtonsTheorem) {
  for (Scene (*scene)() : {rod_on_a_wedge, crank_and_slot}) EXPECT_EQ(run(scene, {"check"}).code, 0);
  const Outcome outcome = run(trolley, {"check"});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("what joints with friction transmit against Newton's theorem"), std::string::npos) << outcome.out;
}

TEST(JointFriction, IsPrintedWithWhatPressesIt) {
  const Outcome outcome = run(bead_on_a_rod, {"equations"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* line : {"  rub, friction of a joint, pressed by what it transmits across its axis:\n", "  w_T(rub) = s'\n",
                           "  f_T(rub) = f    (while it slides)\n", "Friction of joints: |T| <= f_s |R| while w_T = 0"}) {
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "\nis not in\n" << outcome.out;
  }
}

// In a plane mechanism one component is left; a journal has two.
TEST(JointFriction, HandsOverTheReactionsThatPressIt) {
  const Equations equations(trolley());
  const Kernel kernel = make_kernel("contacts", equations);
  const ConstantTable& bearings = kernel.structures[0].tables.back();
  EXPECT_EQ(bearings.name, "contact_bearings");
  EXPECT_EQ(std::get<ConstantTable::Indices>(bearings.value), (ConstantTable::Indices{1, 2}));
}

void expect_error(void (*change)(Scene&), const std::string& message) {
  try {
    Scene scene = trolley();
    change(scene);
    validate(scene);
    static_cast<void>(make_kernel("contacts", Equations(scene)));
    ADD_FAILURE() << "accepted; expected: " << message;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(JointFriction, ThatNoJointCanHaveIsRefused) {
  expect_error([](Scene& s) { s.joint_friction("bad", "rod", {.friction = 1}); },
               "the friction 'bad' acts in the revolute joint of 'rod': give the radius of its journal");
  expect_error([](Scene& s) { s.joint_friction("bad", "car", {.friction = 1, .radius = Expression::quantity("1", "m")}); },
               "the friction 'bad' acts in the prismatic joint of 'car', which has no journal: leave the radius out");
  expect_error([](Scene& s) { s.joint_friction("bad", "ground", {.friction = 1}); }, "which is neither prismatic nor revolute");
  expect_error([](Scene& s) { s.joint_friction("bad", "car", {.friction = Expression::quantity("1", "N")}); },
               "the coefficient of the friction 'bad'");
  expect_error([](Scene& s) { s.joint_friction("bad", "car", {.friction = -1}); }, "contact 'bad' has the friction");
  expect_error([](Scene& s) {
    const Expression z = s.coordinate("z", "m");
    s.body("lone", s.prismatic("lone", s.ground(), axis::z, z), Inertia::point(Expression::quantity("1", "kg")));
    s.joint_friction("bad", "lone", {.friction = 1});
  }, "the friction 'bad' is in proportion to what its joint transmits across its axis, and it transmits nothing");
}

}  // namespace
}  // namespace torsor::simulate_joint_friction_test
