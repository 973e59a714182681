// SPDX-License-Identifier: GPL-3.0-or-later
// A driven coordinate stands by its name where its law is longer than a name.
#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/theorem_text.hpp"
#include "tests/printing/check_inline.hpp"

namespace torsor::driven_angles_test {
namespace {

using namespace literals;

bool has(const std::string& text, const std::string& line) { return text.find(line) != std::string::npos; }

/// A pendulum on an arm that a law turns, the angle of the pendulum being counted from the arm.
Scene driven_arm(bool steadily) {
  Scene scene("driven_arm", "");
  const Expression l = scene.parameter("l", "m", 1), r = scene.parameter("r", "m", 0.5_r), m = scene.parameter("m", "kg", 2);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r), w = scene.parameter("omega", "rad/s", 3);
  const Expression A = scene.parameter("A", "rad", 0.3_r), phi_0 = scene.parameter("phi_0", "rad", 0.1_r);
  const Expression phi = scene.coordinate("phi", "rad"), theta = scene.coordinate("theta", "rad"), t = scene.time();
  scene.drive(phi, steadily ? w * t : phi_0 + A * sin(w * t));
  const FrameHandle arm = scene.revolute("arm", "ground", axis::y, phi);
  const FrameHandle rod = scene.revolute("rod", arm, axis::y, theta, {.origin = {r, 0, 0}});
  scene.body("rod", rod, Inertia::point(m).at({0, 0, -l}));
  scene.gravity({0, 0, -g});
  return scene;
}

TEST(DrivenAngles, HaveTheirNamesInsideSines) {
  const std::string page = print_equations(driven_arm(false), Format::text, {});
  EXPECT_TRUE(has(page, "phi = phi_0 + A sin(omega t)\n")) << page;
  EXPECT_TRUE(has(page, "U = l m g cos(phi + theta) + r m g sin(phi)\n")) << page;
}

// Pages of theorems have no list of coordinates: the laws whose names they use follow.
TEST(DrivenAngles, AreListedWithTheoremsThatNameThem) {
  TheoremRequest energy;
  energy.kind = "energy";
  const std::string page = theorem_text(driven_arm(false), energy);
  EXPECT_TRUE(has(page, "\nLaws of time\n  phi = phi_0 + A sin(omega t)\n  phi' = omega A cos(omega t)\n")) << page;
  EXPECT_TRUE(has(page, "1/2 m (l^2 + r^2 - 2 l r sin(theta)) phi'^2")) << page;
  EXPECT_FALSE(has(theorem_text(driven_arm(true), energy), "Laws of time"));
}

TEST(DrivenAngles, OfOneTermAreWrittenOut) {
  const std::string page = print_equations(driven_arm(true), Format::text, {});
  EXPECT_FALSE(has(page, "cos(phi") || has(page, "sin(phi")) << page;
  EXPECT_TRUE(has(page, "omega t)")) << page;
}

TEST(DrivenAngles, AreDifferentiatedAsTheirLaws) {
  const test::InlineCheck check = test::check_inline(driven_arm(false), 50, 5);
  ASSERT_TRUE(check.written_out);
  EXPECT_LT(check.worst, Real::parse("1e-46")) << check.worst_of;  // some 50 terms of size 10, rounded at 1e-50 each
}

/// A pendulum on a rope that is hoisted by a law.
Scene hoist(bool steadily) {
  Scene scene("hoist", "");
  const Expression m = scene.parameter("m", "kg", 2), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression L_0 = scene.parameter("L_0", "m", 6), v = scene.parameter("v", "m/s", 0.3_r);
  const Expression w = scene.parameter("omega", "rad/s", 3);
  const Expression L = scene.coordinate("L", "m"), theta = scene.coordinate("theta", "rad"), t = scene.time();
  scene.drive(L, steadily ? L_0 - v * t : L_0 + v / w * sin(w * t) - v * t);
  const FrameHandle rope = scene.revolute("rope", "ground", axis::y, theta);
  const FrameHandle load = scene.prismatic("load", rope, axis::z, -L);
  scene.body("load", load, Inertia::point(m));
  scene.gravity({0, 0, -g});
  return scene;
}

TEST(DrivenLengths, HaveTheirNamesWhereverTheirLawsWouldStand) {
  const std::string page = print_equations(hoist(true), Format::text, {});
  EXPECT_TRUE(has(page, "L = L_0 - v t\n")) << page;
  EXPECT_TRUE(has(page, "T = 1/2 m L^2 theta'^2 + 1/2 m v^2\n")) << page;
  EXPECT_TRUE(has(page, "theta:  m L^2 theta'' - 2 m v L theta' = -m g L sin(theta)\n")) << page;
  EXPECT_TRUE(has(page, "C = [ -2 m v L ]")) << page;
}

TEST(DrivenLengths, OfSeveralTermsOfTimeHaveTheirNames) {
  const std::string page = print_equations(hoist(false), Format::text, {});
  EXPECT_TRUE(has(page, "U = m g L cos(theta)\n")) << page;
  EXPECT_TRUE(has(page, "T = 1/2 m L'^2 + 1/2 m L^2 theta'^2\n")) << page;
  EXPECT_TRUE(has(page, "dT/dt = m L' L'' + m L L' theta'^2 ")) << page;
}

/// A bead in a slot of a table that swings by a law, held by a spring.
Scene swinging_slot(bool swings) {
  Scene scene("slot", "");
  const Expression m = scene.parameter("m", "kg", 2), A = scene.parameter("A", "rad", 0.3_r);
  const Expression w = scene.parameter("omega", "rad/s", 3), b = scene.parameter("b", "rad/s^2", 0.2_r);
  const Expression k = scene.parameter("k", "N/m", 40), h = scene.parameter("h", "m", 1);
  const Expression psi = scene.coordinate("psi", "rad"), x = scene.coordinate("x", "m"), t = scene.time();
  scene.drive(psi, swings ? A * sin(w * t) : A + w * t + b * t * t / 2);
  const FrameHandle table = scene.revolute("table", "ground", axis::z, psi);
  const FrameHandle bead = scene.prismatic("bead", table, axis::x, x);
  scene.body("bead", bead, Inertia::point(m).at({0, h, 0}));
  scene.spring("spring", x, k);
  return scene;
}

TEST(DrivenRates, HaveTheirNames) {
  const std::string page = print_equations(swinging_slot(true), Format::text, {});
  EXPECT_TRUE(has(page, "  psi = A sin(omega t)\n  psi' = A omega cos(omega t)\n  psi'' = -A omega^2 sin(omega t)\n")) << page;
  EXPECT_TRUE(has(page, "x:  m x'' - m h psi'' - m x psi'^2 = -k x\n")) << page;
  EXPECT_FALSE(has(page, "cos(omega t)^2")) << page;
}

TEST(DrivenRates, OfPowersOfTimeHaveTheirNames) {
  const std::string page = print_equations(swinging_slot(false), Format::text, {});
  EXPECT_TRUE(has(page, "  psi = A + 1/2 b t^2 + omega t\n  psi' = omega + b t\n")) << page;
  EXPECT_FALSE(has(page, "psi'' =")) << page;  // b is shorter
  EXPECT_TRUE(has(page, "x:  m x'' - m x psi'^2 - m b h = -k x\n")) << page;
}

TEST(DrivenRates, AreDifferentiatedAsTheirLaws) {
  for (const bool swings : {true, false}) {
    const test::InlineCheck check = test::check_inline(swinging_slot(swings), 50, 5);
    ASSERT_TRUE(check.written_out);
    // Some 50 terms of size 10, rounded at 1e-50 each.
    EXPECT_LT(check.worst, Real::parse("1e-46")) << swings << ": " << check.worst_of;
  }
}

TEST(DrivenLengths, AreDifferentiatedAsTheirLaws) {
  for (const bool steadily : {true, false}) {
    const test::InlineCheck check = test::check_inline(hoist(steadily), 50, 5);
    ASSERT_TRUE(check.written_out);
    EXPECT_LT(check.worst, Real::parse("1e-45")) << check.worst_of;  // some 50 terms of size 100, rounded at 1e-50 each
  }
}

/// A pendulum whose point of suspension moves up and down by a law.
struct Lift {
  Scene scene{"lift", ""};
  Expression m = scene.parameter("m", "kg", 2), g = scene.parameter("g", "m/s^2", 9.81_r), l = scene.parameter("l", "m", 1);
  Expression a = scene.parameter("a", "m", 0.5_r), b = scene.parameter("b", "m", 0.2_r), w = scene.parameter("omega", "rad/s", 3);
  Expression t = scene.time(), h = scene.coordinate("h", "m"), theta = scene.coordinate("theta", "rad");

  Scene by(const Expression& law) && {
    scene.drive(h, law);
    const FrameHandle support = scene.prismatic("support", "ground", axis::z, h);
    const FrameHandle rod = scene.revolute("rod", support, axis::y, theta);
    scene.body("rod", rod, Inertia::point(m).at({0, 0, -l}));
    scene.gravity({0, 0, -g});
    return std::move(scene);
  }
};

constexpr int lift_laws = 6;

Scene lift(int which) {
  Lift at;
  Scene& scene = at.scene;
  const Expression t = at.t, a = at.a, b = at.b, w = at.w;
  switch (which) {
    case 0: {
      const Expression tau = scene.parameter("tau", "s", 2);
      return std::move(at).by(a + b * exp(-t / tau));
    }
    case 1: {
      const Expression v = scene.parameter("v", "m/s", 0.3_r), c = scene.parameter("c", "m/s^2", 0.4_r);
      const Expression j = scene.parameter("j", "m/s^3", 0.5_r);
      return std::move(at).by(v * t + c * t * t / 2 + j * t * t * t / 6);
    }
    case 2:
      return std::move(at).by(b + a * sin(w * t) * sin(w * t));
    case 3:
      return std::move(at).by(a * cos(w * t) + b * sin(w * t));
    case 4:
      return std::move(at).by(a * cos(w * t) + b * sin(2 * w * t));
    default:
      return std::move(at).by(a * sin(w * t + b / a));
  }
}

TEST(DrivenCoordinates, StandWhereverTheirLawsWould) {
  for (int which = 0; which < lift_laws; ++which) {
    const std::string page = print_equations(lift(which), Format::text, {});
    EXPECT_TRUE(has(page, "U = -m g h + m g l cos(theta)\n")) << page;
    if (which != 0 && which != 2) {  // their rates are products, whose squares have other factors
      EXPECT_TRUE(has(page, "T = 1/2 m h'^2 + m l sin(theta) h' theta' + 1/2 m l^2 theta'^2\n")) << page;
    }
    EXPECT_TRUE(has(page, "theta:  m l^2 theta'' + m l sin(theta) h'' = -m g l sin(theta)\n")) << page;
  }
}

TEST(DrivenCoordinates, AreDifferentiatedAsTheirLaws) {
  for (int which = 0; which < lift_laws; ++which) {
    const test::InlineCheck check = test::check_inline(lift(which), 50, 5);
    ASSERT_TRUE(check.written_out);
    EXPECT_LT(check.worst, Real::parse("1e-45")) << which << ": " << check.worst_of;  // some 50 terms of size 100
  }
}

TEST(DrivenCoordinates, AreNoReasonToDivide) {
  Lift lift;
  const Expression F = lift.scene.parameter("F", "N", 3), x = lift.scene.coordinate("x", "m");
  const FrameHandle slide = lift.scene.prismatic("slide", "ground", axis::x, x);
  lift.scene.body("slide", slide, Inertia::point(lift.m));
  const Expression angle = lift.w * lift.t + lift.b / lift.a;
  lift.scene.generalised_force("push", x, F * sin(angle));
  const std::string page = print_equations(std::move(lift).by(lift.a * sin(angle)), Format::text, {});
  EXPECT_TRUE(has(page, "x:  m x'' = F sin(omega t + b/a)\n") || has(page, "x:  m x'' = F sin(b/a + omega t)\n")) << page;
}

}  // namespace
}  // namespace torsor::driven_angles_test
