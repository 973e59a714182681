// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/verification/random_state.hpp"
#include "tests/dynamics/simple_scenes.hpp"

namespace torsor::check_test {
namespace {

using namespace testing_mechanisms;

const CheckResult& named(const std::vector<CheckResult>& results, const std::string& name) {
  const auto place = std::find_if(results.begin(), results.end(), [&](const CheckResult& r) { return r.name == name; });
  if (place == results.end()) throw std::out_of_range("no check " + name);
  return *place;
}

TEST(Check, PassesAtItsBoundAndFailsBeyondAndForNaN) {
  EXPECT_TRUE((CheckResult{"", "", 1e-45, 1e-45}.passed()));
  EXPECT_FALSE((CheckResult{"", "", 2e-45, 1e-45}.passed()));
  EXPECT_FALSE((CheckResult{"", "", std::numeric_limits<double>::quiet_NaN(), 1e-45}.passed()));
}

TEST(Check, PassesAGoodSceneAtEveryPrecision) {
  for (const int digits : {30, 80}) {
    for (const CheckResult& result : check_scene(pendulum(), {.digits = digits, .states = 3})) {
      EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst;
      if (result.name == "derivations") {
        EXPECT_LT(result.worst, std::pow(10.0, 5 - digits));
        EXPECT_LE(result.bound, std::pow(10.0, 6 - digits));
      }
    }
  }
}

// A sphere's contact with a plane: that z'' = 0 is nothing but rounding, and is measured against the rolling beside it.
TEST(Check, MeasuresWhatVanishesIdenticallyAgainstItsNeighbours) {
  Scene scene("ball");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.free("ball", scene.ground(), {x, y, z}, scene.attitude("e"));
  scene.initial(z, metres("0.5"));
  const PointHandle contact = scene.sphere_contact("contact", ball, metres("0.5"), scene.ground());
  const Expression moment = Expression::quantity("1", "kg m^2");
  scene.body(
      "ball", ball,
      Inertia::general({.mass = kilograms("2"), .xx = moment, .yy = moment, .zz = moment}).at({0, 0, metres("0.1")}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.point_in_plane("floor", contact, scene.ground());
  scene.rolling("rolling", {.body = ball, .on = scene.ground(), .contact = contact, .tangents = scene.ground()});
  for (const CheckResult& result : check_scene(scene, {.digits = 30, .states = 3})) {
    EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst;
  }
}

TEST(Check, ComparesEveryKernelInDoubleAndRepeatsItself) {
  const std::vector<CheckResult> first = check_scene(pendulum(), {.digits = 30, .states = 2});
  const std::vector<CheckResult> second = check_scene(pendulum(), {.digits = 30, .states = 2});
  for (const char* kernel :
       {"mass_matrix", "bias", "inverse_dynamics", "forward_dynamics", "energy", "linearisation"}) {
    EXPECT_EQ(named(first, "double." + std::string(kernel)).worst,
              named(second, "double." + std::string(kernel)).worst);
  }
}

/// At the first random state a spring is stretched by 1e-9 m only, the difference of two lengths of a metre: the
/// roundings of these are no fault of the kernels.
TEST(Check, MeasuresDoublesAgainstTheTermsThatCancel) {
  const auto scale = [](const Expression& rest) {
    Scene scene("scale");
    const Expression x = scene.coordinate("x", "m");
    const FrameHandle pan = scene.prismatic("pan", scene.ground(), axis::x, x);
    scene.body("pan", pan, Inertia::point(kilograms("1")));
    scene.spring("spring", x, Expression::quantity("1", "N/m"), rest);
    return scene;
  };
  const Scene any = scale(Expression::quantity("1", "m"));
  const double x = RandomState(any, 1).value(any.content().coordinates[0].q);
  ASSERT_GT(std::abs(x), 0.01);
  const Expression rest = Expression(x) * Expression::quantity("1", "m") + Expression::quantity("1e-9", "m");
  const std::vector<CheckResult> results = check_scene(scale(rest), {.digits = 30, .states = 1});
  EXPECT_LT(named(results, "double.bias").worst, 1e-15);
  EXPECT_GT(named(results, "double.bias").worst, 0.0);
}

/// The powers of the three components cancel: what is left of them is rounding, and no failure of the energy theorem.
TEST(Check, PassesABodyThatNothingWorksOn) {
  Scene scene("free");
  const FrameHandle body = scene.spherical("body", scene.ground(), scene.attitude("e"));
  const auto moment = [](const char* value) { return Expression::quantity(value, "kg m^2"); };
  scene.body("body", body,
             Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("2"), .zz = moment("2.5")}));
  const std::vector<CheckResult> results = check_scene(scene, {.digits = 30, .states = 3});
  EXPECT_TRUE(named(results, "energy_theorem").passed()) << named(results, "energy_theorem").worst;
}

/// A reaction that pushes along the wrong direction is caught by the gradient of its constraint.
TEST(Check, FailsWhereAReactionDoesNotEnforceItsConstraint) {
  Scene scene("block");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle block = scene.prismatic("block", slide, axis::y, y);
  scene.body("block", block, Inertia::point(kilograms("1")));
  scene.point("P", block, {0, 0, 0});
  scene.reaction(scene.holonomic("floor", y + x / 100), "N",
                 {.body = block, .contact = scene.point("P"), .direction = axis::y, .axes = scene.ground()});
  const std::vector<CheckResult> results = check_scene(scene, {.digits = 30, .states = 2});
  EXPECT_FALSE(named(results, "reactions").passed());
  EXPECT_GT(named(results, "reactions").worst, 1e-3);
}

/// A mass below zero makes the mass matrix indefinite.
TEST(Check, CountsTheStatesWhereTheMassMatrixIsNotPositive) {
  Scene scene("levitating");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, scene.coordinate("x", "m"));
  scene.body("block", slide, Inertia::point(kilograms("-1")));
  const std::vector<CheckResult> results = check_scene(scene, {.digits = 30, .states = 3});
  EXPECT_EQ(named(results, "positiveness").worst, 3);
  EXPECT_FALSE(named(results, "positiveness").passed());
  // Every pivot counts, not the first alone.
  Scene pair("pair");
  const FrameHandle first = pair.prismatic("first", pair.ground(), axis::x, pair.coordinate("x", "m"));
  const FrameHandle second = pair.prismatic("second", pair.ground(), axis::x, pair.coordinate("y", "m"));
  pair.body("heavy", first, Inertia::point(kilograms("2")));
  pair.body("levitating", second, Inertia::point(kilograms("-1")));
  EXPECT_EQ(named(check_scene(pair, {.digits = 30, .states = 2}), "positiveness").worst, 2);
}

}  // namespace
}  // namespace torsor::check_test
