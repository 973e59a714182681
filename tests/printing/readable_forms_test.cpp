// SPDX-License-Identifier: GPL-3.0-or-later
// What a page does with unit quaternions, with square roots and with the contact of a disc.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/printing/lagrange_equations.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/printing/check_inline.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::readable_forms_test {
namespace {

using namespace testing_mechanisms;
using namespace literals;

std::string print(const Scene& scene, Format format = Format::text) { return print_equations(scene, format, {}); }

bool has(const std::string& text, const std::string& line) { return text.find(line) != std::string::npos; }

void expect_what_the_program_says(const Scene& scene) {
  const test::InlineCheck check = test::check_inline(scene, 50, 5);
  ASSERT_TRUE(check.written_out);
  // Some 400 terms of size 1e3 at most, rounded at 1e-50 each.
  EXPECT_LT(check.worst, Real::parse("1e-45")) << check.worst_of;
}

/// A free body by a unit quaternion, its centre of mass at `offset` along its own x.
Scene free_body(bool offset) {
  Scene scene("free_body");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression m = scene.parameter("m", "kg", 2), R = scene.parameter("R", "m", 0.5_r);
  const FrameHandle body = scene.free("body", scene.ground(), {x, y, z}, scene.attitude("e"));
  if (offset) {
    scene.body("body", body,
               Inertia::general({.mass = m, .xx = moment("3"), .yy = moment("4"), .zz = moment("5")}).at({R, 0, 0}));
  } else {
    scene.body("body", body, Inertia::solid_sphere(m, R));
  }
  return scene;
}

TEST(ReadableForms, OfAFreeBallByAQuaternionAreThoseOfTheTextbook) {
  const std::string page = print(free_body(false));
  EXPECT_TRUE(has(page, "  T = 1/2 m x'^2 + 1/2 m y'^2 + 1/2 m z'^2 + 1/5 m R^2 e_omega_x^2 + 1/5 m R^2 e_omega_y^2 + "
                        "1/5 m R^2 e_omega_z^2\n"))
      << page;
  for (const char* q : {"x", "y", "z"}) EXPECT_TRUE(has(page, std::string("  ") + q + ":  m " + q + "'' = 0\n")) << page;
  for (const char* w : {"e_omega_x", "e_omega_y", "e_omega_z"}) {
    EXPECT_TRUE(has(page, std::string("  ") + w + ":  2/5 m R^2 " + w + "' = 0\n")) << page;
  }
  expect_what_the_program_says(free_body(false));
}

TEST(ReadableForms, OfAFreeBodyHoldNoPowersOfItsQuaternionAboveTheSecond) {
  const std::string page = print(free_body(true));
  // V(G) = (x', y', z') + Ω ∧ OG: each component of OG in the ground's axes has a quaternion's two squares at most.
  EXPECT_TRUE(has(page, "m R (1 - 2 e_x^2 - 2 e_z^2) y' e_omega_z")) << page;
  EXPECT_FALSE(has(page, "^3")) << page;
  EXPECT_FALSE(has(page, "^4")) << page;
  expect_what_the_program_says(free_body(true));
}

/// Two bodies in a row, each turned by a quaternion of its own.
TEST(ReadableForms, OfTwoQuaternionsUseTheNormOfEach) {
  Scene scene("two");
  const Expression m = scene.parameter("m", "kg", 2), R = scene.parameter("R", "m", 0.5_r);
  const FrameHandle a = scene.spherical("a", scene.ground(), scene.attitude("e"));
  const FrameHandle b = scene.spherical("b", a, scene.attitude("f"));
  scene.body("a", a, Inertia::solid_sphere(m, R));
  scene.body("b", b, Inertia::solid_sphere(m, R));
  const printing::LagrangeEquations printed(scene, {});
  ASSERT_TRUE(printed.kinetic_energy().sum);
  const std::string t = printing::text(collected(*printed.kinetic_energy().sum));
  // T of b: 1/5 m R^2 |Ω_b|², Ω_b = ω_f + Rᵀ ω_e, whose square holds |ω_e|² without any quaternion.
  for (const char* w : {"e_omega_x", "e_omega_y", "e_omega_z"}) {
    EXPECT_TRUE(has(t, std::string("2/5 m R^2 ") + w + "^2")) << t;
  }
}

/// A mass on x whose force function is k x times one root.
std::string with_root(const auto& root) {
  Scene scene("root");
  const Expression x = scene.coordinate("x", "m");
  const Expression k = scene.parameter("k", "N/m", 1);
  scene.body("mass", scene.prismatic("mass", scene.ground(), axis::x, x), Inertia::point(kilograms("1")));
  const Expression length = root(scene, x);
  scene.force_function("u", k * x * length);
  const std::string page = print(scene);
  const std::size_t begin = page.find("  U = ") + 6;
  return page.substr(begin, page.find('\n', begin) - begin);
}

TEST(ReadableForms, TakeSquaresOfWhatIsKnownToBePositiveOutOfRoots) {
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.parameter("c", "m", 2);
              return sqrt(c * c);
            }),
            "k c x");
  EXPECT_EQ(with_root([](Scene& s, const Expression& x) {
              const Expression c = s.parameter("c", "1", 2);
              return sqrt(4 * c * c * x * x + 4 * c * c * metres("3") * metres("3"));
            }),
            "2 k c x sqrt(x^2 + 9)");
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.parameter("c", "m", 2), d = s.parameter("d", "m", 3 * c);
              return sqrt(c * c + 2 * c * d + d * d);
            }),
            "k (c + d) x");
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.parameter("c", "m", 2), d = s.parameter("d", "m", 3);
              return sqrt(c * c - 2 * c * d + d * d);
            }),
            "k |c - d| x");
  // What a run may set, what is negative, and what follows from either, may have any sign.
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.run_time_parameter("c", "m", 2);
              return sqrt(c * c);
            }),
            "k |c| x");
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.run_time_parameter("c", "m", 2), d = s.parameter("d", "m", 3 * c);
              return sqrt(d * d);
            }),
            "k |d| x");
  EXPECT_EQ(with_root([](Scene& s, const Expression&) {
              const Expression c = s.parameter("c", "m", -2);
              return sqrt(c * c);
            }),
            "k |c| x");
  EXPECT_EQ(with_root([](Scene& s, const Expression& x) {
              const Expression c = s.parameter("c", "m", 2);
              return sqrt(x * x - 2 * x * c + c * c);
            }),
            "k x |x - c|");
}

/// A disc on the ground after yaw, roll and pitch; steered: turned once more about its own z at the end of a rod.
Scene disc(bool steered) {
  Scene scene("disc");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression yaw = scene.coordinate("yaw", "rad"), roll = scene.coordinate("roll", "rad");
  const Expression pitch = scene.coordinate("pitch", "rad");
  const Expression m = scene.parameter("m", "kg", 2), r = scene.parameter("r", "m", 0.3_r);
  FrameHandle body = scene.free("body", scene.ground(), {x, y, z},
                                {.sequence = AngleSequence{{2, 0, 1}}, .angles = {yaw, roll, pitch}});
  scene.body("body", body, Inertia::disk(m, r, 1));
  if (steered) {
    body = scene.revolute("fork", body, axis::z, scene.coordinate("delta", "rad"), {{scene.parameter("w", "m", 1), 0, 0}});
    scene.body("wheel", body, Inertia::disk(m, r, 1));
  }
  const PointHandle touch =
      scene.disc_contact("C", {.frame = body, .axis = axis::y, .radius = r, .plane = scene.ground()});
  scene.point_in_plane("touch", touch, scene.ground());
  scene.no_slip("along", {.body = body, .contact = touch, .direction = axis::x, .axes = scene.ground()});
  scene.initial(z, r);
  return scene;
}

TEST(ReadableForms, OfTheHeightOfADiscHoldNoYaw) {
  const std::string page = print(disc(false));
  EXPECT_TRUE(has(page, "  z - r |cos(roll)| = 0    (touch, holonomic)\n")) << page;
  EXPECT_FALSE(has(page, "sqrt")) << page;
  EXPECT_TRUE(has(print(disc(false), Format::latex), "r \\left|\\cos\\left(\\mathrm{roll}\\right)\\right|"));
  expect_what_the_program_says(disc(false));
}

TEST(ReadableForms, OfADiscThatLeansInManyWaysNameTheProductOfNormalAndAxis) {
  const std::string page = print(disc(true));
  EXPECT_TRUE(has(page, "  z - w cos(roll) sin(pitch) - r sqrt(1 - n.k_C^2) = 0    (touch, holonomic)\n")) << page;
  EXPECT_TRUE(has(page, "  n.k_C = cos(roll) sin(pitch) sin(delta) + cos(delta) sin(roll)    "
                        "(normal of the plane times axis of the disc at C)\n"))
      << page;
  expect_what_the_program_says(disc(true));
}

TEST(ReadableForms, NameARootThatOccursTwice) {
  Scene scene("tied");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression l = scene.parameter("l", "m", 1), k = scene.parameter("k", "N/m", 3);
  const FrameHandle mass = scene.prismatic(
      "mass", scene.prismatic("b", scene.prismatic("a", scene.ground(), axis::x, x), axis::y, y), axis::z, z);
  scene.body("mass", mass, Inertia::point(scene.parameter("m", "kg", 1)));
  scene.spring("s", {.a = scene.point("A", scene.ground(), {0, 0, 0}),
                     .b = scene.point("B", mass, {l, 0, 0}),
                     .stiffness = k,
                     .rest = l});
  const std::string page = print(scene);
  EXPECT_TRUE(has(page, "\nRoots\n  root_1 = sqrt(x^2 + 2 l x + y^2 + z^2 + l^2)\n")) << page;
  EXPECT_TRUE(has(page, "  y:  m y'' = l k y/root_1 - k y\n")) << page;
  EXPECT_EQ(page.find("sqrt("), page.rfind("sqrt(")) << page;  // where it is told, and nowhere else
  const std::string latex = print(scene, Format::latex);
  EXPECT_TRUE(has(latex, "\\mathrm{root}_{1} &= \\sqrt{x^{2} + 2 l x + y^{2} + z^{2} + l^{2}}")) << latex;
}

}  // namespace
}  // namespace torsor::readable_forms_test
