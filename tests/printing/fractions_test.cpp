// SPDX-License-Identifier: GPL-3.0-or-later
// What cancels in fractions is cancelled, a radicand that is a denominator has the name of its root, and rolling that can be
// integrated is.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/cancelled_fractions.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "tests/printing/check_inline.hpp"

namespace torsor::fractions_test {
namespace {

using namespace literals;
using printing::cancelled;
using printing::Sum;

bool has(const std::string& text, const std::string& line) { return text.find(line) != std::string::npos; }

struct Letters {
  Scene scene{"letters", ""};
  Sum a = letter("a"), b = letter("b"), c = letter("c");

  Sum letter(const std::string& name) { return Sum::symbol(scene.parameter(name, "1", 1).as_symbol()); }
};

Sum over(const Sum& sum, const Sum& denominator, int power = 1) { return sum * printing::power(denominator, -2 * power); }
Sum minus(const Sum& sum) { return Number(-1) * sum; }
Sum plus(Sum a, const Sum& b) { return a += b; }

bool same(const Sum& a, const Sum& b) { return printing::compare(a, b) == 0; }

TEST(CancelledFractions, OfTheSameDenominatorComeTogether) {
  const Letters of;
  const Sum sum = plus(of.a, of.b), one(Number(1));
  EXPECT_TRUE(cancelled(plus(plus(over(of.a, sum), over(of.b, sum)), minus(one))).is_zero());
  EXPECT_TRUE(same(cancelled(plus(over(of.a, sum), over(of.b, sum))), one));
  // (a^2 - b^2)/(a + b) = a - b, and with another factor in front that is no part of the denominator.
  const Sum squares = plus(of.a * of.a, minus(of.b * of.b));
  EXPECT_TRUE(same(cancelled(over(squares, sum)), plus(of.a, minus(of.b))));
  EXPECT_TRUE(same(cancelled(over(of.c * squares, sum)), of.c * plus(of.a, minus(of.b))));
  // a (a + b)^2/(a + b)^3, divided twice; one denominator is left.
  EXPECT_TRUE(same(cancelled(over(of.a * sum * sum, sum, 3)), over(of.a, sum)));
  // The powers of a letter may be negative: (1/a + 1/b)/(a + b) = 1/(a b).
  const Sum inverses = plus(printing::power(of.a, -2), printing::power(of.b, -2));
  EXPECT_TRUE(same(cancelled(over(inverses, sum)), printing::power(of.a * of.b, -2)));
}

TEST(CancelledFractions, StayWhereNothingGetsShorter) {
  const Letters of;
  const Sum sum = plus(of.a, of.b);
  for (const Sum& kept : {over(of.c, sum), plus(over(of.a, sum), of.c), over(of.a * of.a, sum), printing::power(sum, -1),
                          plus(over(of.a, sum), over(of.b, plus(of.a, of.c)))}) {
    EXPECT_TRUE(same(cancelled(kept), kept));
  }
}

TEST(CancelledFractions, EndWhereADenominatorHasARootOfItsOwnLetters) {
  const Letters of;
  const Sum squares = plus(of.a * of.a, of.b * of.b), root = printing::power(squares, 1);
  const Sum frame = over(plus(squares, of.b * of.b), plus(plus(of.a, of.b), root));
  EXPECT_TRUE(same(cancelled(frame), frame));
  const Sum other = over(plus(root * squares, of.a * of.a * root), plus(of.a, root));
  EXPECT_TRUE(same(cancelled(other), other));
}

TEST(CancelledFractions, OfALongDenominatorToAHighPowerAreLeft) {
  Letters of;
  Sum sum = of.a;
  for (int k = 0; k < 40; ++k) sum = plus(sum, of.letter("x_" + std::to_string(k)));
  const Sum high = plus(over(of.a, sum, 8), over(of.b, sum));
  EXPECT_TRUE(same(cancelled(high), high));
}

/// A sun, a planet on an arm, and a ring on a spring: the coordinates that depend follow by 1/(r_s + r_p).
Scene epicyclic() {
  Scene scene("epicyclic", "");
  const Expression rs = scene.parameter("r_s", "m", 0.02_r), rp = scene.parameter("r_p", "m", 0.03_r), m = scene.parameter("m", "kg", 0.2_r);
  const Expression Is = scene.parameter("I_s", "kg m^2", 0.0001_r), Ia = scene.parameter("I_a", "kg m^2", 0.001_r);
  const Expression Ir = scene.parameter("I_r", "kg m^2", 0.002_r), k = scene.parameter("k", "N m/rad", 50);
  const Expression s = scene.coordinate("sun", "rad"), a = scene.coordinate("arm", "rad");
  const Expression p = scene.coordinate("planet", "rad"), r = scene.coordinate("ring", "rad");
  const FrameHandle sun = scene.revolute("sun", "ground", axis::z, s), arm = scene.revolute("arm", "ground", axis::z, a);
  const FrameHandle planet = scene.revolute("planet", arm, axis::z, p, {.origin = {rs + rp, 0, 0}});
  const FrameHandle ring = scene.revolute("ring", "ground", axis::z, r);
  scene.body("sun", sun, Inertia::general({.mass = m, .zz = Is}));
  scene.body("arm", arm, Inertia::general({.mass = m, .zz = Ia}));
  scene.body("ring", ring, Inertia::general({.mass = m, .zz = Ir}));
  scene.body("planet", planet, Inertia::disk(m, rp, 2));
  const PointHandle in = scene.point("in", arm, {rs, 0, 0}), out = scene.point("out", arm, {rs + 2 * rp, 0, 0});
  scene.no_slip("inner", {.body = planet, .contact = in, .direction = axis::y, .axes = arm, .on = sun});
  scene.no_slip("outer", {.body = planet, .contact = out, .direction = axis::y, .axes = arm, .on = ring});
  scene.spring("mount", r, k);
  return scene;
}

TEST(CancelledFractions, MakeTheReducedMassesOfAGearShort) {
  const std::string page = print_equations(epicyclic(), Format::text, {});
  // By hand: arm' = (r_s sun' + (r_s + 2 r_p) ring')/(2 (r_s + r_p)), so that I_a counts (r_s/(2 (r_s + r_p)))^2 times in M[1,1].
  EXPECT_TRUE(has(page, "M_r = [ 1/8 r_s^2 (3 m + 2 I_a/(r_s + r_p)^2) + I_s")) << page;
  EXPECT_TRUE(has(page, "F_r = [ 0       ]\n        [ -k ring ]")) << page;
}

TEST(IntegrableConditions, AreToldWithTheirIntegrals) {
  const std::string page = print_equations(epicyclic(), Format::text, {});
  EXPECT_TRUE(has(page, "constant = r_s (sun - arm) + r_p planet    (inner is integrable)")) << page;
  EXPECT_TRUE(has(page, "constant = r_p (2 arm + planet - 2 ring) + r_s (arm - ring)    (outer is integrable)")) << page;
}

/// Two wheels on one axle, which turns by psi: each alone is not integrable, nor does the axle not slide along itself.
Scene axle(bool one_turns_twice_as_fast) {
  Scene scene("axle", "");
  const Expression r = scene.parameter("r", "m", 0.3_r), b = scene.parameter("b", "m", 0.5_r), m = scene.parameter("m", "kg", 2);
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), psi = scene.coordinate("psi", "rad");
  const Expression left = scene.coordinate("left", "rad"), right = scene.coordinate("right", "rad");
  const FrameHandle body = scene.planar("body", "ground", {.x = x, .y = y, .angle = psi});
  scene.body("body", body, Inertia::box(m, r, b, r));
  for (const auto& [name, angle, side] : {std::tuple("left", left, 1), std::tuple("right", one_turns_twice_as_fast ? 2 * right : right, -1)}) {
    const FrameHandle wheel = scene.revolute(name, body, axis::y, angle, {.origin = {0, side * b, r}});
    scene.body(name, wheel, Inertia::disk(m, r, 1));
    const PointHandle contact = scene.point(std::string("under_") + name, body, {0, side * b, 0});
    scene.no_slip(std::string("rolls_") + name, {.body = wheel, .contact = contact, .direction = axis::x, .axes = body});
  }
  scene.no_slip("slides", {.body = body, .contact = scene.point("middle", body, {0, 0, 0}), .direction = axis::y, .axes = body});
  return scene;
}

TEST(IntegrableConditions, AreFoundInCombinationsBesideALawOfTime) {
  for (const bool swings : {false, true}) {
    Scene scene("drums", "");
    const Expression R = scene.parameter("R", "m", 0.3_r), b = scene.parameter("b", "m", 0.2_r), m = scene.parameter("m", "kg", 2);
    const Expression A = scene.parameter("A", "rad", 0.5_r), w = scene.parameter("omega", "rad/s", 3);
    const Expression x = scene.coordinate("x", "m"), psi = scene.coordinate("psi", "rad");
    const Expression one = scene.coordinate("one", "rad"), other = scene.coordinate("other", "rad");
    scene.drive(psi, swings ? A * sin(w * scene.time()) : w * scene.time());
    scene.initial(x, 0, b * (swings ? A * w : w));
    scene.body("cart", scene.prismatic("cart", "ground", axis::x, x), Inertia::point(m));
    for (const auto& [name, angle] : {std::pair("one", one), std::pair("other", other)}) {
      scene.body(name, scene.revolute(name, "ground", axis::y, angle), Inertia::disk(m, R, 1));
      scene.nonholonomic(std::string("belt_") + name, rate(x) - R * rate(angle) - b * rate(psi) * cos(psi));
    }
    const std::string page = print_equations(scene, Format::text, {});
    EXPECT_TRUE(has(page, "constant = one - other    (belt_one, belt_other are integrable together)")) << page;
  }
}

TEST(IntegrableConditions, AreFoundInCombinationsOfWheels) {
  const std::string page = print_equations(axle(false), Format::text, {});
  EXPECT_TRUE(has(page, "constant = r (left - right) + 2 b psi    (rolls_left, rolls_right are integrable together)")) << page;
  EXPECT_FALSE(has(page, "slides is integrable")) << page;
  EXPECT_FALSE(has(page, "rolls_left is integrable")) << page;
  const std::string other = print_equations(axle(true), Format::text, {});
  EXPECT_TRUE(has(other, "constant = r (left - 2 right) + 2 b psi    (rolls_left, rolls_right are integrable together)")) << other;
}

/// A damper between a bead on a rod and a point beside it: its rate has the square of the distance under it.
TEST(NamedRoots, AreNamesOfTheirRadicandsAsDenominatorsToo) {
  Scene scene("damped_bead", "");
  const Expression h = scene.parameter("height", "m", 1), c = scene.parameter("c", "N s/m", 1), k = scene.parameter("k", "N/m", 3);
  const Expression x = scene.coordinate("x", "m"), l = scene.parameter("length", "m", 2);
  const FrameHandle bead = scene.prismatic("bead", "ground", axis::x, x);
  scene.body("bead", bead, Inertia::point(scene.parameter("m", "kg", 1)));
  const PointHandle here = scene.point("here", bead, {0, 0, 0}), there = scene.point("there", "ground", {l, 0, h});
  scene.spring("spring", SpringBetween{.a = here, .b = there, .stiffness = k, .rest = l});
  scene.damper("damper", here, there, c);
  const std::string page = print_equations(scene, Format::text, {});
  EXPECT_TRUE(has(page, "/root_1^2")) << page;
  EXPECT_TRUE(has(page, "root_1 = sqrt(")) << page;
  EXPECT_FALSE(has(page, "/(")) << page;
  const test::InlineCheck check = test::check_inline(scene, 50, 5);
  ASSERT_TRUE(check.written_out);
  EXPECT_LT(check.worst, Real::parse("1e-46")) << check.worst_of;  // some 50 terms of size 10, rounded at 1e-50 each
}

/// A load whose rope is wound up: its length stands in T squared, and in the equations as a factor.
TEST(OrientedSquares, HaveTheSignThatTheirFactorHasElsewhere) {
  Scene scene("hoist", "");
  const Expression l = scene.parameter("l_0", "m", 3), v = scene.parameter("v", "m/s", 0.1_r), m = scene.parameter("m", "kg", 1);
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle rope = scene.revolute("rope", "ground", axis::y, theta);
  scene.body("load", scene.prismatic("load", rope, axis::z, -(l - v * scene.time())), Inertia::point(m));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const std::string page = print_equations(scene, Format::text, {});
  EXPECT_TRUE(has(page, "1/2 m (l_0 - v t)^2 theta'^2")) << page;
  EXPECT_FALSE(has(page, "(v t - l_0)")) << page;
}

}  // namespace
}  // namespace torsor::fractions_test
