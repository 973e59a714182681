// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/validation.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/simple_scenes.hpp"

namespace torsor::validation_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

std::string refusal(const Scene& scene) {
  return error_of([&] { validate(scene); });
}

TEST(Validation, LetsAGoodSceneThrough) { EXPECT_EQ(refusal(pendulum()), "no error"); }

TEST(Validation, NamesAnUnknownFrameAndTheKnownOnes) {
  Scene scene = pendulum();
  scene.body("lost", "elbow", Inertia::point(kilograms("1")));
  EXPECT_EQ(refusal(scene), "unknown frame 'elbow' in body 'lost': the scene has ground, arm");
}

TEST(Validation, NamesAnUnknownFrameOfAPointThatNothingUses) {
  Scene scene = pendulum();
  scene.point("P", "elbow", {0, 0, 0});
  EXPECT_EQ(refusal(scene), "unknown frame 'elbow' in point 'P': the scene has ground, arm");
}

TEST(Validation, NamesAFrameThatHangsOnItself) {
  Scene scene = pendulum();
  scene.weld("a", "b", {});
  scene.weld("b", "a", {});
  EXPECT_EQ(refusal(scene),
            "frame 'a' hangs on itself: its chain of parents never reaches the ground; close a loop with "
            "a constraint instead");
}

TEST(Validation, NamesTheCoordinateThatMustAccelerateWithoutMass) {
  Scene scene = pendulum();
  scene.revolute("hand", "arm", axis::z, scene.coordinate("phi", "rad"));
  EXPECT_EQ(refusal(scene),
            "coordinate 'phi' must accelerate but has no inertia: it moves frames without any body with "
            "zero mass; give a mass, or drive the coordinate by a law of time");
}

TEST(Validation, NamesTheBodyThatHasNoInertiaAboutItsAxis) {
  Scene scene = pendulum();
  const FrameHandle wheel = scene.revolute("wheel", "arm", axis::z, scene.coordinate("phi", "rad"));
  scene.body("wheel", wheel, Inertia::general(0, 0, 0, 0));
  EXPECT_EQ(refusal(scene),
            "coordinate 'phi' must accelerate but has no inertia: it moves body 'wheel' with zero mass; "
            "give a mass, or drive the coordinate by a law of time");
}

TEST(Validation, NamesARedundantCoordinate) {
  Scene scene("redundant");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const FrameHandle first = scene.prismatic("first", scene.ground(), axis::x, x);
  scene.body("bob", scene.prismatic("second", first, axis::x, y), Inertia::point(kilograms("1")));
  const std::string text = refusal(scene);
  EXPECT_TRUE(text.starts_with("the mass matrix is singular at every state: coordinate 'y'")) << text;
  EXPECT_NE(text.find("give masses or inertias, or remove a redundant coordinate"), std::string::npos) << text;
}

TEST(Validation, NamesUnitsThatDoNotMatch) {
  Scene heavy("heavy");
  const FrameHandle arm = heavy.revolute("arm", heavy.ground(), axis::z, heavy.coordinate("theta", "rad"));
  heavy.body("bob", arm, Inertia::point(metres("2")));
  EXPECT_EQ(refusal(heavy), "body 'bob': its mass is 2 [m] and must be in kg");

  Scene tied = pendulum();
  tied.spring("spring", Expression(tied.content().coordinates[0].q), Expression::quantity("3", "N/m"));
  // A torque is wanted, and N/m times an angle is none.
  EXPECT_EQ(refusal(tied), "the stiffness of the spring 'spring' on theta [1] is 3 [kg s^-2] and must be in kg m^2 s^-2");
}

TEST(Validation, NamesADrivenCoordinateThatIsAskedAsUnknownToo) {
  Scene scene = pendulum();
  const Expression phi = scene.coordinate("phi", "rad");
  scene.drive(phi, Expression::quantity("2", "rad/s") * scene.time());
  scene.initial(phi, 1);
  EXPECT_EQ(refusal(scene),
            "coordinate 'phi' is driven by the law 2*t and cannot also be an unknown with an initial value: "
            "drop initial('phi') or drive('phi')");
}

TEST(Validation, NamesACoordinateThatMovesNothing) {
  Scene scene = pendulum();
  scene.coordinate("idle", "m");
  EXPECT_EQ(refusal(scene), "coordinate 'idle' moves nothing: no joint uses it");
  Scene released = pendulum();
  const Expression held = released.released_coordinate("held", "rad");
  released.body("hand", released.revolute("hand", "arm", axis::z, 2 * held), Inertia::point(kilograms("1")));
  EXPECT_EQ(refusal(released), "coordinate 'held' moves nothing: no joint uses it as its whole displacement");
}

TEST(Validation, NamesASceneWithoutUnknowns) {
  EXPECT_EQ(refusal(Scene("empty")),
            "the scene 'empty' has no unknown coordinate: nothing is left to derive; add "
            "coordinate(...) and use it in a joint");
}

TEST(Validation, NamesAConstraintThatInvolvesNoCoordinate) {
  Scene scene = pendulum();
  scene.holonomic("nothing", scene.time() - Expression::quantity("1", "s"));
  EXPECT_EQ(refusal(scene),
            "constraint 'nothing' involves no coordinate: no motion can satisfy or violate it; drop it or "
            "write it with the scene's coordinates");
}

TEST(Validation, NamesAConstraintThatIsNotLinearInTheVelocities) {
  Scene scene = pendulum();
  scene.nonholonomic(
      "square", pow(rate(Expression(scene.content().coordinates[0].q)), 2) - Expression::quantity("1", "rad^2/s^2"));
  EXPECT_EQ(refusal(scene),
            "constraint 'square' is not linear in the velocities: its left-hand side must be Σ a(q, t) q̇ − "
            "b(q, t)");
}

TEST(Validation, NamesAConstraintOnACoordinateThatIsHeldAtZero) {
  Scene scene = pendulum();
  const Expression held = scene.released_coordinate("held", "rad");
  scene.body("hand", scene.revolute("hand", "arm", axis::z, held), Inertia::disk(kilograms("1"), metres("1"), 2));
  scene.holonomic("tied", Expression(scene.content().coordinates[0].q) - held);
  EXPECT_EQ(refusal(scene),
            "constraint 'tied' names the released coordinate 'held', which its joint holds at zero: write "
            "the constraint without it");
}

TEST(Validation, NamesAReactionThatDoesNotEnforceItsConstraint) {
  Scene scene("block");
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle block = scene.prismatic("block", slide, axis::y, y);
  scene.body("block", block, Inertia::point(kilograms("1")));
  scene.point("P", block, {0, 0, 0});
  scene.reaction(scene.holonomic("floor", y), "N", block, "P", axis::x, scene.ground());
  const std::string text = refusal(scene);
  EXPECT_TRUE(text.starts_with("reaction 'N' does not enforce constraint 'floor': along coordinate 'x'")) << text;
  EXPECT_NE(text.find("check the point and the direction"), std::string::npos) << text;
}

class ConstrainedPair : public ::testing::Test {
 protected:
  Scene scene{"pair"};
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  ConstrainedPair() {
    const FrameHandle first = scene.prismatic("first", scene.ground(), axis::x, x);
    scene.body("first", first, Inertia::point(kilograms("1")));
    scene.body("second", scene.prismatic("second", scene.ground(), axis::y, y), Inertia::point(kilograms("1")));
    scene.holonomic("tied", x - 2 * y);
  }
};

TEST_F(ConstrainedPair, MustStartOnItsConstraintsInPositionAndInVelocity) {
  scene.initial(x, 1);
  EXPECT_EQ(refusal(scene),
            "inconsistent initial state: constraint 'tied' has the value 1 m at t = 0 and must have 0; "
            "correct initial(...) of the coordinates it ties");
  scene.initial(y, 0.5_r, 0.25_r);
  EXPECT_EQ(refusal(scene),
            "inconsistent initial state: constraint 'tied' has the rate -0.5 m s^-1 at t = 0 and must have "
            "0; correct initial(...) of the coordinates it ties");
  scene.initial(x, 1, 0.5_r);
  EXPECT_EQ(refusal(scene), "no error");
  const std::vector<Real> state = initial_state(scene);
  ASSERT_EQ(state.size(), 4U);
  EXPECT_EQ(state[1].to_double(), 0.5);
  EXPECT_EQ(state[3].to_double(), 0.25);
}

TEST(InitialState, EvaluatesFormulasOfParameters) {
  Scene scene = pendulum();
  const Expression l = scene.parameter("l", "m", 3);
  const Expression k = scene.run_time_parameter("k", "1", l / metres("12") * pi());
  scene.initial(Expression(scene.content().coordinates[0].q), 2 * k);
  EXPECT_LT(relative_difference(initial_state(scene)[0], Real::pi() / Real(2)), 1e-45);
  scene.parameter("unknown", "m");
  EXPECT_TRUE(initial_state(scene).empty());
}

}  // namespace
}  // namespace torsor::validation_test
