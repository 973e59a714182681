// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/scene_runner.hpp"

namespace torsor::bad_scenes_test {
namespace {

using namespace testing_programs;

/// Every command looks at the whole scene first: each gives the same single line.
void expect_refused(Scene (*make_scene)(), const std::string& message) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"list"}, {"equations"}, {"counts"}, {"check"}, {"reference", "--times", "1"}}) {
    expect_failure(run(make_scene, arguments), 3, message);
  }
}

TEST(BadScene, WithADuplicateNameIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        scene.coordinate("theta", "rad");
        return scene;
      },
      "duplicate name 'theta': the scene 'pendulum' already has a coordinate of that name; choose another name for the "
      "new "
      "coordinate");
}

TEST(BadScene, WithAnUnknownFrameIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        scene.weld("hand", "elbow", {});
        return scene;
      },
      "unknown frame 'elbow' in joint 'hand': the scene has ground, arm, hand");
}

TEST(BadScene, WithABodyWithoutMassThatMustAccelerateIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        const FrameHandle slide = scene.prismatic("slide", "arm", axis::x, scene.coordinate("x", "m"));
        scene.body("sleeve", slide, Inertia::point(0));
        return scene;
      },
      "coordinate 'x' must accelerate but has no inertia: it moves body 'sleeve' with zero mass; give a mass, or drive "
      "the "
      "coordinate by a law of time");
}

TEST(BadScene, WithUnitsThatDoNotMatchIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        const Expression width = scene.parameter("width", "m", 1);
        scene.holonomic("odd", width + scene.time());
        return scene;
      },
      "cannot add width [m] and t [s]: both terms of a sum need the same unit");
  expect_refused(
      [] {
        Scene scene = pendulum();
        scene.point("P", "arm", {sin(scene.parameter("width", "m", 1)), 0, 0});
        return scene;
      },
      "the argument of sin(width) has the unit m and must be dimensionless: divide it by a quantity of that unit");
}

TEST(BadScene, WithADrivenCoordinateThatIsAlsoAnUnknownIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        const Expression phi = scene.coordinate("phi", "rad");
        scene.initial(phi, 1);
        scene.drive(phi, Expression::quantity("3", "rad/s") * scene.time());
        return scene;
      },
      "coordinate 'phi' is driven by the law 3*t and cannot also be an unknown with an initial value: drop "
      "initial('phi') "
      "or drive('phi')");
}

TEST(BadScene, WithAConstraintThatInvolvesNoCoordinateIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();
        scene.point("A", scene.ground(), {0, 0, 0});
        scene.point("B", scene.ground(), {1 * Expression::quantity("1", "m"), 0, 0});
        scene.closure("bar", scene.point("A"), scene.point("B"), axis::x);
        return scene;
      },
      "constraint 'bar' involves no coordinate: no motion can satisfy or violate it; drop it or write it with the "
      "scene's "
      "coordinates");
}

TEST(BadScene, WithAnInconsistentInitialStateIsRefused) {
  expect_refused(
      [] {
        Scene scene = pendulum();  // theta starts at 1/2
        scene.holonomic("straight", Expression(scene.content().coordinates[0].q) - Expression(Number::rational(1, 4)));
        return scene;
      },
      "inconsistent initial state: constraint 'straight' has the value 0.25 at t = 0 and must have 0; correct "
      "initial(...) of the coordinates it ties: theta; a state nearby that fulfils all: initial(theta, 0.25)");
}

TEST(BadScene, ThatThrowsSomethingElseStillGivesOneLine) {
  expect_failure_beginning(run([]() -> Scene { throw std::out_of_range("index 7"); }, {"list"}), 3,
                           "unexpected failure: index 7");
}

}  // namespace
}  // namespace torsor::bad_scenes_test
