// SPDX-License-Identifier: GPL-3.0-or-later
// Squares of springs stay whole, coefficients have one form, and parameters that nothing takes are named.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/printing/check_inline.hpp"

namespace torsor::stretches_test {
namespace {

using namespace literals;

/// A pendulum whose length a law changes, and two carts on springs: between each other and the pendulum, to the ground, and with a
/// quotient as stiffness. Elongations share x, so that the terms of the squares run into each other.
Scene springs() {
  Scene scene("springs", "");
  const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 1), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression eps = scene.parameter("eps", "1", 0.1_r), w = scene.parameter("omega", "rad/s", 3), k = scene.parameter("k", "N/m", 10);
  const Expression a = scene.parameter("a", "m", 0.2_r), x_0 = scene.parameter("x_0", "m", 1);
  const Expression spare = scene.parameter("spare", "m", 3), twice = scene.parameter("twice", "m", 2 * spare);
  const Expression theta = scene.coordinate("theta", "rad"), x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::y, theta);
  scene.body("bob", scene.prismatic("bob", arm, axis::z, -l * (1 + eps * cos(w * scene.time()))), Inertia::point(m));
  scene.body("cart", scene.prismatic("cart", scene.ground(), axis::x, x), Inertia::point(0.001_r * m));
  scene.body("other", scene.prismatic("other", scene.ground(), axis::x, y), Inertia::point(0.002_r * m));
  scene.gravity({0, 0, -g});
  scene.spring("between", x - y - a + l * sin(theta), k);
  scene.spring("to_the_bob", x - l * (1 + eps * cos(theta)), k);
  scene.spring("to_the_ground", x, a * k / l, x_0);
  (void)twice;
  return scene;
}

bool has(const std::string& text, const std::string& line) { return text.find(line) != std::string::npos; }

TEST(Stretches, StayWholeInTheForceFunctionAndInTheEquations) {
  const std::string page = print_equations(springs(), Format::text, {});
  EXPECT_TRUE(has(page, "U = -1/2 k (x - y - a + l sin(theta))^2 - 1/2 k (x - l - l eps cos(theta))^2")) << page;
  EXPECT_TRUE(has(page, "1/2 k a (x - x_0)^2/l")) << page;
  EXPECT_TRUE(has(page, "y:  0.002 m y'' = k (x - y - a + l sin(theta))\n")) << page;
  EXPECT_TRUE(has(page, "x:  0.001 m x'' = -k (x - y - a + l sin(theta)) - k (x - l - l eps cos(theta)) - k a (x - x_0)/l\n")) << page;
}

TEST(Stretches, AreWhatTheProgramSays) {
  const test::InlineCheck check = test::check_inline(springs(), 50, 5);
  ASSERT_TRUE(check.written_out);
  // Some 50 terms of size 10 at most, rounded at 1e-50 each.
  EXPECT_LT(check.worst, Real::parse("1e-46")) << check.worst_of;
}

TEST(ReadableForms, OfOneCoefficientAreOne) {
  const std::string page = print_equations(springs(), Format::text, {});
  EXPECT_TRUE(has(page, "T = 1/2 m l^2 (1 + eps cos(omega t))^2 theta'^2 + 0.0005 m x'^2 + 0.001 m y'^2")) << page;
  EXPECT_TRUE(has(page, "(1 + eps cos(omega t)) theta'\n")) << page;
  EXPECT_FALSE(has(page, "eps cos(omega t) + 1")) << page;
  EXPECT_TRUE(has(page, "C = [ -2 m l^2 eps omega sin(omega t) (1 + eps cos(omega t))")) << page;
}

TEST(UnusedParameters, AreNamed) {
  EXPECT_TRUE(has(print_equations(springs(), Format::text, {}), "  In no equation: spare, twice.\n"));
  EXPECT_TRUE(has(print_equations(springs(), Format::latex, {}), "In no equation: $\\mathrm{spare}$, $\\mathrm{twice}$.\\par\n"));
}

// What a used parameter is computed from is used, and what falls out of all equations is not.
TEST(UnusedParameters, CountWhatOthersAreComputedFrom) {
  Scene scene("rotor", "");
  const Expression edge = scene.parameter("edge", "m", 1), density = scene.parameter("density", "kg/m^2", 2);
  const Expression C = scene.parameter("C", "kg m^2", density * pow(edge, 4)), A = scene.parameter("A", "kg m^2", 2);
  scene.body("rotor", scene.revolute("rotor", scene.ground(), axis::z, scene.coordinate("phi", "rad")),
             Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = A, .yy = A, .zz = C}));
  EXPECT_TRUE(has(print_equations(scene, Format::text, {}), "  In no equation: A.\n"));
}

TEST(UnusedParameters, AreNoneWhereAContactTakesThem) {
  Scene scene("stone", "");
  const Expression e = scene.parameter("e", "1", 0.5_r), low = scene.parameter("low", "m", -1), z = scene.coordinate("z", "m");
  scene.body("stone", scene.prismatic("stone", scene.ground(), axis::z, z), Inertia::point(Expression::quantity("2", "kg")));
  scene.stop(z, low, {}, {.restitution = e});
  EXPECT_FALSE(has(print_equations(scene, Format::text, {}), "In no equation"));
}

}  // namespace
}  // namespace torsor::stretches_test
