// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/validation.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::validation_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

std::string refusal(const Scene& scene) {
  return error_of([&] { validate(scene); });
}

TEST(Validation, LetsAGoodSceneThrough) { EXPECT_EQ(refusal(pendulum()), "no error"); }

// Numbers of type double take the place of a parameter that is set at run time.
TEST(Validation, RefusesARunTimeParameterThatNoDoubleHolds) {
  for (const char* value : {"1e400", "-1e400", "1e-400"}) {
    Scene scene = pendulum();
    const Expression p = scene.run_time_parameter("p", "kg", kilograms(value));
    scene.body("heavy", "arm", Inertia::point(kilograms("1") + p));
    EXPECT_TRUE(refusal(scene).starts_with("the run-time parameter 'p' has the value ")) << refusal(scene);
    Scene fixed = pendulum();
    fixed.parameter("q", "kg", kilograms(value));
    EXPECT_EQ(refusal(fixed), "no error");
  }
}

TEST(Validation, RefusesALengthThatIsNegative) {
  Scene scene = pendulum();
  const Expression r = scene.parameter("r", "m", -1);
  scene.body("wheel", "arm", Inertia::disk(kilograms("1"), r, 1));
  EXPECT_EQ(refusal(scene), "body 'wheel' has the radius of a disk r = -1 m: a length is never negative; give its size");
}

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
  scene.body("wheel", wheel, Inertia::general({.mass = 0}));
  EXPECT_EQ(refusal(scene),
            "coordinate 'phi' must accelerate but has no inertia: it moves body 'wheel' with zero mass; "
            "give a mass, or drive the coordinate by a law of time");
}

TEST(Validation, NamesTheBodyWhoseMassLiesOnItsAxis) {
  Scene scene = pendulum();
  const FrameHandle wheel = scene.revolute("wheel", "arm", axis::z, scene.coordinate("phi", "rad"));
  scene.body("wheel", wheel, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, Expression::quantity("1", "m")}));
  EXPECT_EQ(refusal(scene),
            "coordinate 'phi' must accelerate but has no inertia: it moves body 'wheel' whose mass lies on the axis; give a "
            "moment of inertia about it, or drive the coordinate by a law of time");
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

// What is no number at the start, as sin(z)/z at 0, leaves other states to decide.
TEST(Validation, NamesARedundantCoordinateBesideWhatIsUndefinedAtTheStart) {
  Scene scene("redundant");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression turn = z / metres("1");
  const FrameHandle odd = scene.prismatic("odd", scene.ground(), axis::z, sin(turn) / turn * metres("1"));
  scene.body("odd", odd, Inertia::point(kilograms("1")));
  const FrameHandle first = scene.prismatic("first", scene.ground(), axis::x, x);
  scene.body("bob", scene.prismatic("second", first, axis::x, y), Inertia::point(kilograms("1")));
  const std::string text = refusal(scene);
  EXPECT_TRUE(text.starts_with("the mass matrix is singular at every state: coordinate 'y'")) << text;
}

TEST(Validation, NamesUnitsThatDoNotMatch) {
  Scene heavy("heavy");
  const FrameHandle arm = heavy.revolute("arm", heavy.ground(), axis::z, heavy.coordinate("theta", "rad"));
  heavy.body("bob", arm, Inertia::point(metres("2")));
  EXPECT_EQ(refusal(heavy), "body 'bob': its mass is 2 [m] and must be in kg");

  Scene tied = pendulum();
  tied.spring("spring", Expression(tied.content().coordinates[0].q), Expression::quantity("3", "N/m"));
  // A torque is wanted, and N/m times an angle is none.
  EXPECT_EQ(refusal(tied), "the stiffness of the spring 'spring' on theta [1] is 3 [N/m] and must be in N m");
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
  EXPECT_EQ(refusal(released), "coordinate 'held' moves nothing: no joint uses it in its displacement");
  released.body("hand", released.revolute("hand", "arm", axis::z, 2 * held), Inertia::point(kilograms("1")));
  EXPECT_EQ(refusal(released), "no error");
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
  SlidingPoint it("block"), sloped("block");
  it.scene.reaction(it.scene.holonomic("floor", it.y), "N",
                    {.body = it.point, .contact = it.place, .direction = axis::x, .axes = it.scene.ground()});
  const std::string text = refusal(it.scene);
  EXPECT_TRUE(text.starts_with("reaction 'N' does not enforce constraint 'floor': along coordinate 'x'")) << text;
  EXPECT_NE(text.find("check the point and the direction"), std::string::npos) << text;
  sloped.scene.reaction(
      sloped.scene.holonomic("slope", sloped.x + sloped.y), "N",
      {.body = sloped.point, .contact = sloped.place, .direction = axis::x, .axes = sloped.scene.ground()});
  EXPECT_TRUE(
      refusal(sloped.scene).starts_with("reaction 'N' does not enforce constraint 'slope': along coordinate 'y'"));
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
            "correct initial(...) of the coordinates it ties: x, y");
  scene.initial(y, 0.5_r, 0.25_r);
  EXPECT_EQ(refusal(scene),
            "inconsistent initial state: constraint 'tied' has the rate -0.5 m/s at t = 0 and must have "
            "0; correct initial(...) of the coordinates it ties: x, y");
  scene.initial(x, 1, 0.5_r);
  EXPECT_EQ(refusal(scene), "no error");
  const std::vector<Real> state = initial_state(scene);
  ASSERT_EQ(state.size(), 4U);
  EXPECT_EQ(state[1].to_double(), 0.5);
  EXPECT_EQ(state[3].to_double(), 0.25);
}

// A millimetre too much is one whatever the constraint is multiplied by; twelve decimals are enough for any.
TEST(Validation, JudgesTheStartInAnyUnitOfAConstraint) {
  for (const Expression& factor : {1e-6_r, Expression(1), Expression(1000000)}) {
    const auto refused = [&factor](const Expression& at, const Expression& rate) {
      Scene scene("pendulum");
      const Expression a = scene.coordinate("a", "rad"), y = scene.coordinate("y", "m"), l = scene.parameter("l", "m", 2);
      const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, a);
      scene.body("rod", rod, Inertia::rod(kilograms("1"), l, 0).at({l / 2, 0, 0}));
      scene.body("block", scene.prismatic("block", scene.ground(), axis::y, y), Inertia::point(kilograms("1")));
      scene.holonomic("level", factor * (y - l * sin(a)));
      scene.initial(y, at, rate);
      return refusal(scene);
    };
    EXPECT_EQ(refused(0, 0), "no error");
    EXPECT_EQ(refused(1e-12_r, 1e-12_r), "no error");
    EXPECT_TRUE(refused(0.001_r, 0).starts_with("inconsistent initial state: constraint 'level' has the value"));
    EXPECT_TRUE(refused(0, 0.001_r).starts_with("inconsistent initial state: constraint 'level' has the rate"));
  }
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

// What is differentiated as a function of the configuration must be one: with a velocity in it the equations would be wrong.
TEST(Validation, RefusesVelocitiesWhereAConfigurationIsMeant) {
  const Expression second = Expression::quantity("1", "s");
  const auto refused = [&](const auto& use) {
    Scene scene("formulas");
    const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), q = scene.coordinate("q", "rad");
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
    const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
    const FrameHandle body = scene.revolute("body", lift, axis::y, q);
    scene.body("body", body, Inertia::box(kilograms("1"), metres("1"), metres("2"), metres("3")));
    use(scene, body, x, q);
    return refusal(scene);
  };
  using S = Scene;
  using F = FrameHandle;
  using E = Expression;
  EXPECT_EQ(
      refused([&](S& s, F b, E x, E) {
        s.point_in_plane("c", s.point("P", b, {0, 0, rate(x) * second}), s.ground());
      }),
      "the place of point 'P' depends on the velocity 'x'' through d/dt(x): give a formula of coordinates, time and "
      "parameters");
  const std::string starts[] = {
      refused([&](S& s, F b, E, E q) { s.prismatic("out", b, axis::x, rate(q) * second * metres("1")); }),
      refused([&](S& s, F b, E, E q) { s.revolute("turn", b, axis::x, rate(q) * second); }),
      refused([&](S& s, F b, E x, E) {
        s.weld("far", b, {.origin = {rate(x) * second, 0, 0}});
      }),
      refused([&](S& s, F b, E x, E) {
        s.weld("far", b, {.origin = {x, 0, 0}});
      }),
      refused([&](S& s, F b, E, E q) { s.body("more", b, Inertia::point(kilograms("1") * (2 + sin(q)))); }),
      refused([&](S& s, F b, E x, E) {
        s.body("more", b, Inertia::point(kilograms("1")).at({x, 0, 0}));
      }),
      refused([&](S& s, F, E x, E) { s.spring("k", x + rate(x) * second, Expression::quantity("1", "N/m")); }),
      refused([&](S& s, F, E x, E) {
        s.spring("k", x, Expression::quantity("1", "N/m") * (2 + sin(rate(x) * second / metres("1"))));
      }),
      refused([&](S& s, F b, E x, E) {
        s.spring("k", {.a = s.point("P", b, {0, 0, 0}),
                       .b = s.point("O", s.ground(), {0, 0, 0}),
                       .stiffness = Expression::quantity("1", "N/m") * (2 + sin(rate(x) * second / metres("1")))});
      }),
      refused([&](S& s, F b, E, E) {
        s.weld("far", b, {.origin = {s.time() / second * metres("1"), 0, 0}});
      }),
      refused([&](S& s, F, E x, E) { s.motor("m", rate(x) * second); }),
      refused([&](S& s, F, E x, E) { s.holonomic("h", x + rate(x) * second); }),
      refused([&](S& s, F b, E, E q) {
        s.no_slip("n", {.body = b,
                        .contact = s.point("P", b, {0, 0, 0}),
                        .direction = {rate(q) * second, 1, 0},
                        .axes = s.ground()});
      }),
      refused([&](S& s, F b, E x, E) { s.point_in_plane("c", s.sphere_contact("P", b, x, s.ground()), s.ground()); }),
  };
  const char* expected[] = {
      "the displacement of joint 'out' depends on the velocity 'q''",
      "the displacement of joint 'turn' depends on the velocity 'q''",
      "the placement of joint 'far' depends on the velocity 'x''",
      "the placement of joint 'far' depends on the coordinate 'x'",
      "the inertia of body 'more' depends on 'q', which changes in time",
      "the inertia of body 'more' depends on 'x', which changes in time",
      "the elongation of spring 'k' depends on the velocity 'x''",
      "the stiffness of spring 'k' depends on the velocity 'x''",
      "the stiffness of spring 'k' depends on the velocity 'x''",
      "the placement of joint 'far' depends on the time 't'",
      "the displacement of motor 'm' depends on the velocity 'x''",
      "the holonomic constraint 'h' depends on the velocity 'x''",
      "the direction of constraint 'n' depends on the velocity 'q''",
      "the radius of point 'P' depends on the coordinate 'x'",
  };
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_TRUE(starts[i].starts_with(expected[i])) << starts[i] << " instead of " << expected[i];
  }
}

// The rate of a coordinate that follows a law of time is a formula of time.
TEST(Validation, TakesTheRateOfADrivenCoordinateForWhatItIs) {
  Scene scene = pendulum();
  const Expression wave = scene.coordinate("wave", "m");
  scene.drive(wave, metres("0.1") * sin(Expression::quantity("2", "rad/s") * scene.time()));
  scene.prismatic("shaken", scene.ground(), axis::x, wave);
  scene.point("P", "arm", {rate(wave) * Expression::quantity("1", "s"), 0, 0});
  EXPECT_EQ(refusal(scene), "no error");
}

// A released coordinate beside a law of time, or with a factor: its reaction is that of a joint of its own.
TEST(Validation, LetsAReleasedCoordinateStandInAFormula) {
  const auto lift = [](bool apart) {
    Scene scene("lift");
    const Expression height = scene.coordinate("height", "m"), q = scene.coordinate("q", "rad");
    const Expression held = scene.released_coordinate("held", "m");
    scene.drive(height, metres("0.1") * sin(Expression::quantity("2", "rad/s") * scene.time()));
    FrameHandle table = scene.prismatic("table", scene.ground(), axis::y, apart ? height : height + 3 * held);
    if (apart) table = scene.prismatic("pad", table, axis::y, held);
    const FrameHandle arm = scene.revolute("arm", table, axis::z, q);
    scene.body("arm", arm, Inertia::rod(kilograms("2"), metres("1"), 0).at({metres("0.5"), 0, 0}));
    scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
    EXPECT_EQ(refusal(scene), "no error");
    const WorkingDigits precision(50);
    const Equations equations(scene);
    NamedState state(equations, {{"q", rational(1, 3)}, {"q'", Real(2)}, {"q''", Real(-1)}, {"t", rational(2, 5)}});
    return state(equations.inverse_dynamics().back());
  };
  // Three times as far for each unit of the coordinate: three times the force. Some roundings in 50 digits.
  EXPECT_LT(abs(lift(false) - Real(3) * lift(true)).to_double(), 1e-45);
  EXPECT_GT(abs(lift(true)).to_double(), 1.0);
}

}  // namespace
}  // namespace torsor::validation_test
