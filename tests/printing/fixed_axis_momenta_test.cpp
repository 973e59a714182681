// SPDX-License-Identifier: GPL-3.0-or-later
// Momenta about fixed axes of bodies whose attitude is a unit quaternion: claimed, or denied with the reason.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/printing/print_equations.hpp"

namespace torsor::fixed_axis_momenta_test {
namespace {

using namespace literals;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) text.erase(at, part.size());
  return text;
}

/// The page without its line breaks inside formulas.
std::string page_of(const Scene& scene, Format format = Format::text) {
  return without(print_equations(scene, format, {}), "\n     ");
}

/// A symmetric top about a fixed point.
Scene top(bool heavy) {
  Scene scene("top");
  const Expression A = scene.parameter("A", "kg m^2", 1), C = scene.parameter("C", "kg m^2", 0.4_r);
  const FrameHandle top = scene.spherical("top_1", scene.ground(), scene.attitude("e"));
  const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 0.5_r);
  scene.body("top_1", top, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}).at({0, 0, heavy ? l : 0 * l}));
  if (heavy) scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

// p = A (R_zx ω_x + R_zy ω_y) + C R_zz ω_z with R_zx = 2 (x z - w y), R_zy = 2 (y z + w x), R_zz = 1 - 2 (x² + y²).
TEST(FixedAxisMomenta, OfAHeavyTopIsThatAboutTheVertical) {
  const std::string page = page_of(top(true));
  EXPECT_TRUE(has(page, "constant = -2 ((A + m l^2) e_w e_y - (A + m l^2) e_x e_z) e_omega_x "
                        "+ 2 ((A + m l^2) e_w e_x + (A + m l^2) e_y e_z) e_omega_y + C (1 - 2 e_x^2 - 2 e_y^2) e_omega_z"
                        "    (momentum about axis z of 'ground' through the origin of 'top_1', in N m s)"))
      << page;
  for (const char* axis : {"x", "y"}) {
    const std::string line = std::string("No momentum integral about axis ") + axis + " of 'ground' through the origin of 'top_1': ";
    EXPECT_TRUE(has(page, line + "U depends on it.")) << page;
  }
  EXPECT_TRUE(has(page_of(top(true), Format::latex), "top\\_1")) << page_of(top(true), Format::latex);
}

TEST(FixedAxisMomenta, OfATorqueFreeBodyAreThree) {
  const std::string page = page_of(top(false));
  for (const char* axis : {"x", "y", "z"}) {
    const std::string line = std::string("(momentum about axis ") + axis + " of 'ground' through the origin of 'top_1', in N m s)";
    EXPECT_TRUE(has(page, line)) << page;
  }
  EXPECT_FALSE(has(page, "No momentum integral about")) << page;
}

/// A free body whose centre of mass is off its origin turns about no axis through that origin, but about those of the ground.
Scene thrown(bool drag) {
  Scene scene("thrown");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression J = scene.parameter("J", "kg m^2", 2), m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 0.5_r);
  const FrameHandle body = scene.free("body", scene.ground(), {x, y, z}, scene.attitude("e"));
  scene.body("body", body, Inertia::general({.mass = m, .xx = J, .yy = 2 * J, .zz = 3 * J}).at({l, 0, 0}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  if (drag) scene.rotational_drag("drag", body, scene.parameter("c", "N m s", 1));
  return scene;
}

TEST(FixedAxisMomenta, OfABodyOffItsOriginAreAboutTheGround) {
  const std::string page = page_of(thrown(false));
  EXPECT_TRUE(has(page, "(momentum about axis z of 'ground', in N m s)")) << page;
  EXPECT_TRUE(has(page, "about axis x of 'ground' through the origin of 'body': T depends on it, U depends on it.")) << page;
  const std::string slowed = page_of(thrown(true));
  EXPECT_FALSE(has(slowed, "(momentum about")) << slowed;
  EXPECT_TRUE(has(slowed, "axis z of 'ground' through the origin of 'body': T depends on it, forces act along it.")) << slowed;
}

/// A top whose foot glides on ice, from a place of its own.
TEST(FixedAxisMomenta, OfATopThatGlidesAreAboutWhereItsLengthsBegin) {
  for (const bool aside : {false, true}) {
    Scene scene("gliding");
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), none = Expression::quantity("0", "m");
    const Expression A = scene.parameter("A", "kg m^2", 1), C = scene.parameter("C", "kg m^2", 0.4_r);
    const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 0.5_r);
    const Expression start = aside ? Expression::quantity("3", "m") : none;
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x, {.origin = {start, none, none}});
    const FrameHandle top = scene.spherical("top", scene.prismatic("foot", slide, axis::y, y), scene.attitude("e"));
    scene.body("top", top, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}).at({none, none, l}));
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
    const std::string page = page_of(scene);
    EXPECT_TRUE(has(page, aside ? "(momentum about an axis along z of 'ground' through where x and y are zero, in N m s)"
                                : "(momentum about axis z of 'ground', in N m s)"))
        << page;
    EXPECT_TRUE(has(page, "about axis x of 'ground' through the origin of 'top': T depends on it, U depends on it.")) << page;
  }
}

/// No kernel has them: the page says only how long they are.
TEST(FixedAxisMomenta, OfAChainAreToldWhereTheyAreTooLong) {
  Scene scene("chain");
  FrameHandle last = scene.ground();
  const Expression l = scene.parameter("l", "m", 0.5_r);
  for (int i = 0; i < 3; ++i) {
    const std::string name = "f" + std::to_string(i);
    last = scene.spherical(name, last, scene.attitude("e" + std::to_string(i)), {.origin = {0, 0, i == 0 ? 0 * l : -l}});
    const Expression m = scene.parameter("m" + std::to_string(i), "kg", 1), J = scene.parameter("J" + std::to_string(i), "kg m^2", 2);
    scene.body(name, last, Inertia::general({.mass = m, .xx = J, .yy = J, .zz = 2 * J}).at({0, 0, -l / 2}));
  }
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const std::string page = page_of(scene);
  EXPECT_TRUE(has(page, "about axis z of 'ground' through the origin of 'f0' is constant, and too long to be written out (")) << page;
}

}  // namespace
}  // namespace torsor::fixed_axis_momenta_test
