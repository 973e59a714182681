// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/frame_motion.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_model.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::frame_motion_test {
namespace {

using namespace testing_symbols;
using testing_mechanisms::metres;
using testing_mechanisms::random_mechanism;

class RandomFrames : public testing_mechanisms::RandomModel {
 protected:
  RandomFrames() : RandomModel(11) {}

  /// Components of order one that depend on time, coordinates and velocities.
  Vector moving_vector() {
    const Value q = model.q(0);
    const Value angle = q.unit().is_dimensionless() ? q : q / program.number(Number(1), q.unit());
    const Value speed = model.v(0) / program.number(Number(1), model.v(0).unit());
    return {program.sin(angle), program.number(Number::rational(2, 3)), speed};
  }
};

TEST_P(RandomFrames, DifferentiateAVectorAsItsComponentsChange) {
  const Vector v = moving_vector();
  for (int link = 0; link < links(); ++link) {
    for (int reference = 0; reference < links(); ++reference) {
      const Vector seen = bound(program, model.express(v, link, reference));
      const Vector direct = time_derivative(seen);
      const Vector by_formula = derivative_in(model, v, link, reference);
      EXPECT_LT(size(model.express(by_formula, link, reference) - direct), 1e-45) << link << " in " << reference;
    }
  }
}

TEST_P(RandomFrames, ComposeTheirAngularVelocitiesAndChangeSignWhenSwapped) {
  const int last = links() - 1;
  for (int a = 0; a < links(); ++a) {
    const int b = last - a;
    const int c = a / 2;
    const Vector ab = angular_velocity(model, a, b, c);
    EXPECT_LT(size(ab + angular_velocity(model, b, a, c)), 1e-45);
    EXPECT_LT(size(angular_velocity(model, a, c, c) - ab - angular_velocity(model, b, c, c)), 1e-45);
    EXPECT_LT(size(angular_velocity_from_axes(model, a, b, c) - ab), 1e-45) << a << " in " << b;
  }
}

TEST_P(RandomFrames, ComposeTheirTwists) {
  const int a = links() - 1;
  for (int b = 0; b < links(); ++b) {
    const Twist whole = relative_twist(model, a, 0);
    const Twist upper = relative_twist(model, a, b);
    const Twist lower_there = relative_twist(model, b, 0);  // at b's origin, in b's axes
    const Vector arm = bound(program, model.locate(Vector(), a, b));
    const Twist moved = reduced_at(lower_there, arm);
    const Vector turn = model.express(moved.angular, b, a) + upper.angular;
    EXPECT_LT(size(turn - whole.angular), 1e-45);
    const Vector velocity = model.express(bound(program, moved.linear), b, a) + upper.linear;
    EXPECT_LT(size(velocity - whole.linear), 1e-45);
    // The other way round: minus the same screw, at b's origin in b's axes.
    const Twist swapped = relative_twist(model, b, a);
    const Vector back = bound(program, model.locate(Vector(), b, a));
    const Twist there = reduced_at(upper, back);
    EXPECT_LT(size(model.express(bound(program, there.linear), a, b) + swapped.linear), 1e-45);
  }
}

TEST_P(RandomFrames, HaveAnAccelerationFieldThatIsTheSecondDerivativeOfPositions) {
  const int link = links() - 1;
  const Vector place(program.number(Number::rational(1, 3), units::metre),
                     program.number(Number::rational(-2, 7), units::metre),
                     program.number(Number::rational(4, 5), units::metre));
  for (int reference = 0; reference < link; ++reference) {
    const BodyMotion motion = body_motion(model, link, reference);
    const Vector position = bound(program, model.locate(place, link, reference));
    const Vector velocity = bound(program, time_derivative(position));
    const Vector acceleration = time_derivative(velocity);
    const Vector v = model.express(bound(program, motion.velocity_at(place)), link, reference);
    const Vector gamma = model.express(bound(program, motion.acceleration_at(place)), link, reference);
    EXPECT_LT(size(v - velocity), 1e-45);
    EXPECT_LT(size(gamma - acceleration), 1e-44);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFrames, ::testing::Range(300U, 312U));

/// A ball joint between two arms, its orientation a unit quaternion: angular velocities there are quasi-velocities.
TEST(FramesOfAQuaternion, MoveAsTheirPositionsDifferentiated) {
  const WorkingDigits precision(50);
  Scene scene("ball_joint");
  const FrameHandle base = scene.revolute("base", scene.ground(), axis::x, scene.coordinate("a", "rad"));
  const FrameHandle ball = scene.spherical("ball", base, scene.attitude("e"), {.origin = {0, metres("0.7"), 0}});
  const FrameHandle tip =
      scene.revolute("tip", ball, axis::y, scene.coordinate("b", "rad"), {.origin = {metres("0.4"), 0, 0}});
  scene.body("tip", tip, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, metres("0.2")}));
  const Equations equations(scene);
  const Model& model = equations.model();
  Program& program = equations.program();
  const RandomState state(scene, 17);
  Evaluator<Real> evaluate(program, state.in_real());
  const auto size = [&](const Vector& v) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(evaluate(v[i])).to_double();
    return sum;
  };
  const Vector place(program.number(Number::rational(1, 3), units::metre), Value(),
                     program.number(Number::rational(4, 5), units::metre));
  const int links = static_cast<int>(model.links().size());
  for (int link = 0; link < links; ++link) {
    for (int reference = 0; reference < links; ++reference) {
      const BodyMotion motion = body_motion(model, link, reference);
      const Vector position = bound(program, model.locate(place, link, reference));
      const Vector velocity = bound(program, time_derivative(position));
      const Vector v = model.express(bound(program, motion.velocity_at(place)), link, reference);
      const Vector gamma = model.express(bound(program, motion.acceleration_at(place)), link, reference);
      // Everything is of order ten: 50 digits leave far less than 1e-45.
      EXPECT_LT(size(v - velocity), 1e-45) << link << " in " << reference;
      EXPECT_LT(size(gamma - time_derivative(velocity)), 1e-45) << link << " in " << reference;
    }
  }
  EXPECT_EQ(recognise_motion(model, model.place(ball, "test").link, 1).kind, MotionKind::rotation);
}

/// Two arms in a plane, a slide across the second, and a screw that advances 0.3 m per radian.
class NamedMotions : public ::testing::Test {
 protected:
  static Scene make() {
    Scene scene("named_motions");
    const Expression a = scene.coordinate("a", "rad");
    const Expression b = scene.coordinate("b", "rad");
    const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a, {.origin = {metres("0.5"), 0, 0}});
    const FrameHandle second = scene.revolute("second", first, axis::z, b, {.origin = {metres("2"), 0, 0}});
    scene.prismatic("slide", second, axis::y, scene.coordinate("s", "m"));
    const Expression c = scene.coordinate("c", "rad");
    const FrameHandle turned = scene.revolute("turned", scene.ground(), axis::x, c);
    scene.prismatic("nut", turned, axis::x, metres("0.3") * c);
    const FrameHandle tilted = scene.revolute("tilted", first, axis::x, scene.coordinate("d", "rad"));
    scene.body("bob", tilted, Inertia::point(Expression::quantity("1", "kg")));
    return scene;
  }
  RigidMotion of(const char* link, const char* reference) {
    const int a = equations.model().place(link, "test").link;
    const int b = equations.model().place(reference, "test").link;
    return recognise_motion(equations.model(), a, b);
  }
  bool is(const Value& value, const Expression& expected) {
    return identically_zero(value - equations.program().lower(expected));
  }

  Equations equations{make()};
};

TEST_F(NamedMotions, AreRecognisedBetweenAnyTwoFrames) {
  EXPECT_EQ(of("first", "first").kind, MotionKind::rest);
  EXPECT_EQ(of("slide", "second").kind, MotionKind::translation);
  EXPECT_EQ(of("second", "slide").kind, MotionKind::translation);
  EXPECT_EQ(of("slide", "ground").kind, MotionKind::rotation);
  EXPECT_EQ(of("nut", "ground").kind, MotionKind::screw);
  EXPECT_EQ(of("nut", "turned").kind, MotionKind::translation);
}

TEST_F(NamedMotions, TurnAboutAFixedOrAMovingAxis) {
  const RigidMotion first = of("first", "ground");
  EXPECT_EQ(first.kind, MotionKind::rotation);
  EXPECT_TRUE(first.fixed_axis);
  EXPECT_TRUE(is(first.axis->ah[0], metres("0.5")));
  const RigidMotion second = of("second", "ground");
  EXPECT_EQ(second.kind, MotionKind::rotation);
  EXPECT_FALSE(second.fixed_axis);
  EXPECT_TRUE(of("second", "first").fixed_axis);
  EXPECT_TRUE(of("ground", "first").fixed_axis);
  EXPECT_FALSE(of("tilted", "ground").fixed_axis);
}

TEST_F(NamedMotions, ScrewAlongAFixedAxisWithTheirPitch) {
  const RigidMotion nut = of("nut", "ground");
  EXPECT_TRUE(nut.fixed_axis);
  EXPECT_TRUE(is(nut.axis->pitch, metres("0.3")));
  EXPECT_TRUE(is(nut.axis->ah[1], 0) && is(nut.axis->ah[2], 0));
}

}  // namespace
}  // namespace torsor::frame_motion_test
