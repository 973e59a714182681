// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor::contact_laws_test {
namespace {

/// A disc that falls on a floor and rolls along it, with dry friction in what guides it.
Scene disc_on_a_floor() {
  Scene scene("disc_on_a_floor", "");
  const Expression r = scene.parameter("r", "m", Expression(Number::rational(1, 10)));
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression f = scene.parameter("f", "1", Expression(Number::rational(1, 5)));
  const Expression e = scene.parameter("e", "1", Expression(Number::rational(1, 2)));
  const Expression b = scene.parameter("b", "N", 3);
  const Expression x = scene.coordinate("x", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression a = scene.coordinate("a", "rad");
  scene.initial(z, 2 * r);
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  const FrameHandle disc = scene.revolute("disc", lift, axis::y, a);
  scene.body("disc", disc, Inertia::disk(m, r, 1));
  scene.contact("floor", shape::Sphere{.frame = disc, .radius = r}, shape::Plane{.frame = scene.ground()},
                {.friction = f, .restitution = e});
  scene.dry_friction("guide", x, {.bound = b});
  return scene;
}

void expect_lines(const std::string& page, std::initializer_list<const char*> lines) {
  for (const char* line : lines) EXPECT_NE(page.find(line), std::string::npos) << line << "\nis not in\n" << page;
}

TEST(ContactLaws, ArePrintedWithGapsSlipsForcesRegimesAndJumps) {
  expect_lines(print_equations(disc_on_a_floor(), Format::text),
               {"Contacts that open and close\n", "  g(floor) = -r + z\n", "  w_N(floor) = z'\n", "  f_T(floor) = f    (while it slides)\n",
                "  e_N(floor) = e    (restitution)\n", "  guide, dry friction alone:\n", "  w_T(guide) = x'\n",
                "  b_T(guide) = b    (while it slides)\n", "  Q_z = N_floor\n",
                "Signorini: 0 <= g, 0 <= N, N g = 0;", "Open: g > 0, N = 0, T = 0.", "Sticks: w_T = 0, |T| <= f_s N",
                "Slides: T = -f_T N w_T/|w_T|", "[[dT/dq_i']] = sum P dw/dq_i'", "0 <= w_N+ + e_N w_N-",
                "Carnot's loss: T- - T+ = -1/2 sum P (w+ + w-)"});
}

// The tangents of two balls are made of a direction that no formula shows, and their slips are past every limit.
TEST(ContactLaws, LeaveOutForcesWhoseSlipsAreTooLong) {
  Scene scene("two_balls", "");
  const Expression r = scene.parameter("r", "m", 1);
  std::vector<FrameHandle> balls;
  for (const std::string name : {"a", "b"}) {
    const Expression x = scene.coordinate("x_" + name, "m");
    const Expression y = scene.coordinate("y_" + name, "m");
    const Expression z = scene.coordinate("z_" + name, "m");
    scene.initial(z, name == "a" ? 3 * r : 0 * r);
    balls.push_back(scene.free("ball_" + name, scene.ground(), {x, y, z}, scene.attitude("turn_" + name)));
    scene.body("ball_" + name, balls.back(), Inertia::solid_sphere(Expression::quantity("1", "kg"), r));
  }
  scene.contact("balls", shape::Sphere{.frame = balls[0], .radius = r}, shape::Sphere{.frame = balls[1], .radius = r},
                {.friction = 1});
  const std::string page = print_equations(scene, Format::text);
  expect_lines(page, {"  w_N(balls) = ", "  w_T1(balls) is too long to be written out",
                      "  Too long to be written out: Q_x_a, Q_y_a, Q_z_a, Q_turn_a_omega_x, "});
  EXPECT_EQ(page.find("Q_x_a ="), std::string::npos);
}

// A point of 1 kg that comes to rest on a belt gains 1/2 u^2: P_T = u from w_T = -u to 0 takes 1/2 u^2, and P_T b = -u^2.
TEST(ContactLaws, CountWhatABeltGives) {
  const auto dropped = [](const Expression& speed) {
    Scene scene("dropped", "");
    const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
    const FrameHandle drop = scene.prismatic("drop", scene.prismatic("slide", scene.ground(), axis::x, x), axis::z, z);
    scene.body("drop", drop, Inertia::point(Expression::quantity("1", "kg")));
    scene.contact("belt", shape::Point{scene.point("P", drop, {0, 0, 0})}, shape::Plane{.frame = scene.ground(), .belt = {speed, 0}},
                  {.friction = 1});
    return scene;
  };
  const std::string moving = "T- - T+ = -1/2 sum P (w+ + w-) + sum P b, b what w is where all velocities are 0";
  const std::string runs = print_equations(dropped(Expression::quantity("2", "m/s")), Format::text);
  EXPECT_NE(runs.find(moving), std::string::npos) << runs;
  EXPECT_EQ(runs.find("P_N w_N- >= 0"), std::string::npos) << runs;
  const std::string rests = print_equations(dropped(0), Format::text);
  EXPECT_EQ(rests.find(moving), std::string::npos) << rests;
  EXPECT_NE(rests.find("P_N w_N- >= 0"), std::string::npos) << rests;
}

TEST(ContactLaws, ArePrintedInLatexToo) {
  expect_lines(print_equations(disc_on_a_floor(), Format::latex),
               {"N \\dot{w}_N = 0$", "$|T| \\le f_s N$", "\\left[\\!\\left[\\frac{\\partial T}{\\partial \\dot{q}_i}\\right]\\!\\right]",
                "-\\frac{1}{2} (1 - e_{N}) P_N w_N^- \\ge 0$", "g(\\mathrm{floor}) &= -r + z"});
}

TEST(ContactLaws, SayWhatResistsRolling) {
  Scene scene("soft", "");
  const Expression r = scene.parameter("r", "m", Expression(Number::rational(1, 10)));
  const Expression h = scene.parameter("h", "m", Expression(Number::rational(1, 1000)));
  const Expression x = scene.coordinate("x", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression a = scene.coordinate("a", "rad");
  scene.initial(z, 2 * r);
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle disc = scene.revolute("disc", scene.prismatic("lift", slide, axis::z, z), axis::y, a);
  scene.body("disc", disc, Inertia::disk(Expression::quantity("2", "kg"), r, 1));
  scene.contact("floor", shape::Sphere{.frame = disc, .radius = r}, shape::Plane{.frame = scene.ground()},
                {.friction = Expression(Number::rational(1, 5)), .rolling = h});
  expect_lines(print_equations(scene, Format::text),
               {"floor_rolling, w an angular velocity, pressed by floor:", "w_T(floor_rolling) = a'", "h_M(floor_rolling) = h    (a length)",
                "Q_a = -r T_floor + T_floor_rolling", "Resistance to rolling and spinning: |T| <= h_M N while w_T = 0"});
}

// g of the gap is not the scene's gravity g, nor its e the scene's: a letter that the scene has gets an index.
TEST(ContactLaws, LeaveTheLettersOfTheSceneAlone) {
  Scene scene("stone", "");
  const Expression g = scene.parameter("g", "m/s^2", 10), e_N = scene.parameter("e_N", "1", 0), e = scene.parameter("e", "1", e_N);
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle stone = scene.prismatic("stone", scene.ground(), axis::z, z);
  scene.body("stone", stone, Inertia::point(Expression::quantity("2", "kg")));
  scene.gravity({0, 0, -g});
  scene.stop(z, Expression(0), {}, {.restitution = e});
  expect_lines(print_equations(scene, Format::text),
               {"g_N is the gap and w its rate", "  g_N(z_lower) = z\n", "  restitution(z_lower) = e    (restitution)\n",
                "Signorini: 0 <= g_N, 0 <= N, N g_N = 0;", "0 <= w_N+ + restitution w_N-", "U = -2 g z"});
  expect_lines(print_equations(scene, Format::latex), {"$0 \\le g_{N}$, $0 \\le N$", "\\mathrm{restitution}\\, w_N^-"});
}

TEST(ContactLaws, AreLeftOutOfASceneWithoutContacts) {
  Scene scene("free", "");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("point", slide, Inertia::point(Expression::quantity("1", "kg")));
  EXPECT_EQ(print_equations(scene, Format::text).find("Signorini"), std::string::npos);
}

}  // namespace
}  // namespace torsor::contact_laws_test
