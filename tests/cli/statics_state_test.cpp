// SPDX-License-Identifier: GPL-3.0-or-later
// Which state and which parameters `statics` looks at: --about and --set.
#include <string>

#include <gtest/gtest.h>

#include "torsor/generator/expression/piecewise.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/bodies.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::statics_state_test {
namespace {

using namespace testing_programs;
using namespace testing_mechanisms;

std::string statics(Scene (*scene)(), std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "statics");
  const Outcome outcome = run(scene, arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

bool says(const std::string& text, const std::string& sentence) { return text.find(sentence) != std::string::npos; }

/// m x'' + c x' + (k − b) x = 0, the load b = k² m/(2 N) of the stiffness: a rest at 0 is stable while k < 2 N/m.
Scene loaded_spring() {
  Scene scene("loaded");
  const Expression k = scene.parameter("k", "N/m", 1), b = scene.parameter("b", "N/m", k * k / quantity("2", "N/m"));
  const Expression x = scene.coordinate("x", "m");
  scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(kilograms("1")));
  scene.spring("spring", x, k);
  scene.spring("load", x, -b);
  scene.damper("damper", x, quantity("1", "N s/m"));
  return scene;
}

TEST(StaticsState, TakesAValueIntoThoseThatFollowFromIt) {
  const std::string soft = statics(loaded_spring, {"--about", "x=0"});
  EXPECT_TRUE(says(soft, "With the scene's values: asymptotically stable")) << soft;
  const std::string stiff = statics(loaded_spring, {"--about", "x=0", "--set", "k=4"});
  EXPECT_TRUE(says(stiff, "With k = 4.")) << stiff;
  EXPECT_TRUE(says(stiff, "pivot 1 of the Hessian of -(U + T0) is -4.00000, not a minimum")) << stiff;
  EXPECT_TRUE(says(stiff, "With the scene's values: unstable")) << stiff;
  EXPECT_FALSE(says(stiff, "stable: ")) << stiff;
}

/// m x'' + (c0 + c1 − c2) x' + k x = 0, of decimals that are no binary numbers; `more` multiplies k by such a sum too.
template <int least, bool more>
Scene undamped() {
  Scene scene("undamped");
  const auto damping = [&](const char* name, int n) {
    return scene.parameter(name, "N s/m", Expression(Number::rational(n, 10)));
  };
  const Expression c0 = damping("c0", least), c1 = damping("c1", 2 * least + 1), c2 = damping("c2", 3 * least + 1);
  const Expression none = scene.parameter("none", "N s/m", c0 + c1 - c2), k = scene.parameter("k", "N/m", 4);
  const Expression x = scene.coordinate("x", "m");
  scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(kilograms("1")));
  scene.spring("spring", x, more ? k * (c0 + c1 - c2) / quantity("1", "N s/m") : k);
  scene.damper("damper", x, more ? none : c0 + c1 - c2);
  return scene;
}

TEST(StaticsState, TellsACoefficientThatCancelsFromARounding) {
  for (Scene (*scene)() : {undamped<1, false>, undamped<2, false>, undamped<3, false>, undamped<4, false>, undamped<11, false>}) {
    const std::string text = statics(scene, {"--about", "x=0"});
    EXPECT_TRUE(says(text, "With the scene's values: cannot conclude, a condition is an equality")) << text;
    EXPECT_TRUE(says(text, "stable: -(U + T0) has a strict minimum")) << text;
  }
  for (Scene (*scene)() : {undamped<1, true>, undamped<2, true>, undamped<3, true>, undamped<4, true>, undamped<11, true>}) {
    const std::string text = statics(scene, {"--about", "x=0"});
    EXPECT_TRUE(says(text, "With the scene's values: cannot conclude, a condition is an equality")) << text;
    EXPECT_TRUE(says(text, "is 0.00000, zero within rounding")) << text;
    EXPECT_FALSE(says(text, "unstable")) << text;
  }
}

/// A double pendulum whose first link has no mass, straight down: M = m l² [4 2; 2 1] there.
Scene massless_link() {
  Scene scene("massless_link");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::y, a);
  const FrameHandle second = scene.revolute("second", first, axis::y, b, {.origin = {0, 0, metres("-1")}});
  scene.body("bob", second, Inertia::point(kilograms("1")).at({0, 0, metres("-1")}));
  scene.gravity({0, 0, quantity("-10", "m/s^2")});
  return scene;
}

// Lejeune-Dirichlet bounds rates by T, and T is zero for b' = -2 a' where M is singular.
TEST(StaticsState, CallsNoRestStableWhereTheMassMatrixIsSingular) {
  const std::string text = statics(massless_link, {"--about", "a=0", "--about", "b=0"});
  EXPECT_TRUE(says(text, "With the scene's values: -(U + T0) has a strict minimum, and positions stay near it; cannot conclude "
                         "on rates: M is singular in a, b."))
      << text;
  EXPECT_FALSE(says(text, "stable: ")) << text;
}

/// A point on a circle around which another one draws: its distance at rest is a root of a square.
Scene attracted() {
  Scene scene("attracted");
  const Expression R = scene.parameter("R", "m", 3), l = scene.parameter("l", "m", 1), k = scene.parameter("k", "N m^2", 2);
  const Expression a = scene.coordinate("a", "rad");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::y, a);
  scene.body("bob", arm, Inertia::point(kilograms("1")).at({0, 0, l}));
  scene.gravitation("pull", scene.point("P", arm, {0, 0, l}), scene.point("Q", scene.ground(), {0, 0, R}), k);
  return scene;
}

// As in H, a root of a square is a size.
TEST(StaticsState, WritesRootsOfSquaresInConditionsAsInEntries) {
  const std::string text = statics(attracted, {"--about", "a=0"});
  EXPECT_TRUE(says(text, "H = [ R l k/|R - l|^3 ]")) << text;
  EXPECT_TRUE(says(text, "\n    R l k/|R - l|^3 > 0\n")) << text;
  EXPECT_FALSE(says(text, "sqrt((")) << text;
}

/// A spring whose stiffness shakes with w, and a push along x of F (1 + x/m).
Scene shaken() {
  Scene scene("shaken");
  const Expression w = scene.parameter("w", "1/s", 3), F = scene.parameter("F", "N", 2), x = scene.coordinate("x", "m"),
                   y = scene.coordinate("y", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("block", scene.prismatic("lift", slide, axis::y, y), Inertia::point(kilograms("1")));
  scene.spring("spring", x, quantity("5", "N/m") * (1 + sin(w * scene.time())));
  scene.spring("other", y, quantity("5", "N/m"));
  scene.generalised_force("push", x, F * y / metres("1"));
  return scene;
}

TEST(StaticsState, JudgesWithTheValuesThatAreSet) {
  const std::string text = statics(shaken, {"--about", "x=0", "--about", "y=0", "--set", "w=0", "--set", "F=0"});
  EXPECT_FALSE(says(text, "on time")) << text;
  EXPECT_FALSE(says(text, "'push' acts")) << text;
  EXPECT_TRUE(says(text, "stable: -(U + T0) has a strict minimum")) << text;
  EXPECT_TRUE(says(statics(shaken, {"--about", "x=0", "--set", "F=0"}), "depends on time")) << "w is still 3";
}

// A coefficient that changes in steps has no slope in time, and is none of a rest all the same.
TEST(StaticsState, SeesWhatChangesInStepsOfTime) {
  const auto stepped = [] {
    Scene scene("stepped");
    const Expression x = scene.coordinate("x", "m");
    scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(kilograms("1")));
    scene.spring("spring", x, piecewise({{scene.time() < quantity("5", "s"), quantity("1", "N/m")}}, quantity("2", "N/m")));
    return scene;
  };
  const std::string text = statics(stepped, {"--about", "x=0"});
  EXPECT_TRUE(says(text, "T or U depends on time explicitly")) << text;
}

// All values are put in at once: one that needs another would leave formulas at two states.
TEST(StaticsState, HasNoValueThatNeedsAnotherOfIts) {
  const auto shallow = [] {
    Scene scene("shallow");
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
    scene.body("bead", scene.prismatic("along", scene.prismatic("across", scene.ground(), axis::y, y), axis::x, x),
               Inertia::point(kilograms("1")));
    scene.force_function("field", -quantity("1", "N/m^3") * x * x * y * y / 2);
    return scene;
  };
  for (const char* command : {"equations", "statics"}) {
    expect_failure_beginning(run(shallow, {command, "--about", "x=2*y", "--about", "y=1"}), 2,
                             "--about x = 2*y: the value depends on 'y', which --about gives too; put its value in");
    expect_failure_beginning(run(shallow, {command, "--about", "y=x", "--about", "x=y"}), 2,
                             "--about y = x: the value depends on 'x'");
    EXPECT_EQ(run(shallow, {command, "--about", "x=2*y"}).code, 0);
  }
  expect_failure_beginning(run(shallow, {"equations", "--about", "x'=y'"}), 2,
                           "--about x' = y': the value depends on 'y''; give a formula");
}

Scene hoop() {
  Scene scene("hoop");
  const Expression w = scene.parameter("w", "rad/s", 5), theta = scene.coordinate("theta", "rad"),
                   phi = scene.coordinate("phi", "rad");
  scene.drive(phi, w * scene.time());
  const FrameHandle ring = scene.revolute("ring", scene.ground(), axis::z, phi);
  scene.body("bead", scene.revolute("arm", ring, axis::y, theta), Inertia::point(kilograms("1")).at({0, 0, metres("-1")}));
  scene.gravity({0, 0, quantity("-10", "m/s^2")});
  return scene;
}

TEST(StaticsState, IsARest) {
  const auto refused = [](const std::string& state, const std::string& beginning) {
    expect_failure_beginning(run(hoop, {"statics", "--about", "theta=0", "--about", state}), 2, beginning);
  };
  refused("theta'=2", "--about theta' = 2: at a rest every rate is zero");
  refused("theta''=2", "--about theta'' = 2: at a rest every rate is zero");
  refused("phi=1", "--about phi = 1: the coordinate 'phi' follows the law w*t");
  refused("w=1", "--about takes a state, e.g. theta=0, and 'w' is a parameter: give its value by --set");
  expect_failure_beginning(run(hoop, {"statics", "--about", "theta=theta'"}), 2,
                           "--about theta = theta': the value depends on 'theta''");
  EXPECT_TRUE(says(statics(hoop, {"--about", "theta=0", "--about", "theta'=0"}), "Every equation of equilibrium holds"));
}

TEST(StaticsState, SetsNumbersAndFormulasOfOtherParameters) {
  EXPECT_TRUE(says(statics(loaded_spring, {"--set", "b=k/4"}), "-U = 3/8 k x^2"));
  expect_failure_beginning(run(loaded_spring, {"statics", "--set", "k=2*k"}), 2,
                           "--set k = 2*k: the value 2*k of the parameter 'k' depends on 'k' itself");
  expect_failure_beginning(run(loaded_spring, {"statics", "--set", "k=b"}), 2, "--set k = b: the value b of the parameter 'k'");
  expect_failure_beginning(run(loaded_spring, {"statics", "--set", "k=x"}), 2, "--set k = x: the value depends on 'x'");
}

/// A body on its ball joint.
Scene top() {
  Scene scene("top");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle top = scene.spherical("top", scene.ground(), e);
  scene.body("top", top, generic_body().at({0, 0, metres("-1")}));
  scene.gravity({0, 0, quantity("-10", "m/s^2")});
  return scene;
}

// The quaternion (2, 0, 0, 0) is the attitude (1, 0, 0, 0), as for a start.
TEST(StaticsState, NormalisesAttitudes) {
  const auto at = [](const std::string& w) {
    const std::string text = statics(top, {"--about", "e_w=" + w, "--about", "e_x=0", "--about", "e_y=0", "--about", "e_z=0"});
    return text.substr(text.find("Lejeune-Dirichlet"));
  };
  EXPECT_EQ(at("2"), at("1"));
  expect_failure(run(top, {"statics", "--about", "e_x=0", "--about", "e_y=0", "--about", "e_z=0"}), 2,
                 "--about gives three components of the attitude 'e', which leave the sign of the fourth open: give all four, "
                 "which are normalised");
  expect_failure_beginning(
      run(top, {"statics", "--about", "e_w=0", "--about", "e_x=0", "--about", "e_y=0", "--about", "e_z=0"}), 2,
      "--about: the four components of the attitude 'e' are zero");
}

Scene rubbing_block() {
  testing_mechanisms::Block block;
  const Expression x = rate(block.x), y = rate(block.y);
  block.slide(Expression::quantity("0.3", "1"), {x, y, 0});
  block.scene.gravity({0, 0, quantity("-10", "m/s^2")});
  return block.scene;
}

// Friction along the slip has no direction where nothing slips.
TEST(StaticsState, LeavesFrictionOutThatHasNoDirection) {
  const std::string text = statics(rubbing_block, {"--about", "x=0", "--about", "y=0", "--about", "z=0"});
  EXPECT_TRUE(says(text, "At rest the friction 'slide' can be anything up to its limit, and is left out")) << text;
  EXPECT_TRUE(says(text, "z:  0 = 20 - lambda_floor")) << text;
}

Scene block_on_a_belt() {
  testing_mechanisms::Block block;
  const Expression u = block.scene.parameter("u", "m/s", 2);
  block.slide(Expression::quantity("0.3", "1"), {rate(block.x) - u, 0, 0});
  block.scene.spring("spring", block.x, quantity("5", "N/m"));
  block.scene.gravity({0, 0, quantity("-10", "m/s^2")});
  return block.scene;
}

// What rests on a belt that runs slips: the spring holds it against the friction.
TEST(StaticsState, KeepsTheFrictionOfABelt) {
  const std::string text = statics(block_on_a_belt, {});
  EXPECT_FALSE(says(text, "is left out")) << text;
  EXPECT_TRUE(says(text, "0.3 lambda_floor") || says(text, "3/10 lambda_floor")) << text;
}

}  // namespace
}  // namespace torsor::statics_state_test
