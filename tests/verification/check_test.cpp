// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "torsor/generator/verification/random_state.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/rolling.hpp"
#include "tests/scenes/sliding.hpp"

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
  add_rolling_ball(scene, scene.ground(),
                   Inertia::general({.mass = kilograms("2"), .xx = moment("1"), .yy = moment("1"), .zz = moment("1")})
                       .at({0, 0, metres("0.1")}));
  scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
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
  const auto scale = [](const Expression& rest) { return block_on_a_spring({.rest = rest}); };
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
  const std::vector<CheckResult> results = check_scene(torque_free_body(), {.digits = 30, .states = 3});
  EXPECT_TRUE(named(results, "energy_theorem").passed()) << named(results, "energy_theorem").worst;
}

/// A reaction that pushes along the wrong direction is caught by the gradient of its constraint.
TEST(Check, FailsWhereAReactionDoesNotEnforceItsConstraint) {
  SlidingPoint it("block");
  it.scene.reaction(it.scene.holonomic("floor", it.y + it.x / 100), "N",
                    {.body = it.point, .contact = it.place, .direction = axis::y, .axes = it.scene.ground()});
  const std::vector<CheckResult> results = check_scene(it.scene, {.digits = 30, .states = 2});
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
