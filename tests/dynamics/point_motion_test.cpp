// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/point_motion.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/contact_motion.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_model.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::point_motion_test {
namespace {

using namespace testing_symbols;
using testing_mechanisms::metres;
using testing_mechanisms::random_mechanism;

class RandomPoint : public testing_mechanisms::RandomModel {
 protected:
  RandomPoint() : RandomModel(5) {}

  /// A point that moves in its link with the first coordinate, as contact points do.
  GeometricPoint moving_point(int link) {
    const Value one = program.number(Number(1), units::metre);
    const Value q = model.q(0);
    const Value angle = q.unit().is_dimensionless() ? q : q / one;
    const Value x = program.sin(angle) * one;
    const Value y = angle * one;
    return {link, {x, y * angle, program.number(Number::rational(2, 3), units::metre)}};
  }
};

TEST_P(RandomPoint, MovesAsItsPositionDifferentiatedInTheFrameOfReference) {
  for (int link = 0; link < links(); ++link) {
    for (int reference = 0; reference < links(); ++reference) {
      const GeometricPoint point = moving_point(link);
      const Vector position = bound(program, model.locate(point.place, link, reference));
      const Vector v = bound(program, time_derivative(position));
      const Vector gamma = time_derivative(v);
      const PointMotion motion =
          point_motion(model, point, {.moving = link, .reference = reference, .axes = reference});
      EXPECT_LT(size(motion.position - position), 1e-45);
      EXPECT_LT(size(motion.absolute_velocity - v), 1e-45) << link << " in " << reference;
      EXPECT_LT(size(motion.absolute_acceleration - gamma), 1e-44) << link << " in " << reference;
    }
  }
}

TEST_P(RandomPoint, ComposesItsVelocitiesAndAccelerationsThroughAnyFrame) {
  const int link = links() - 1;
  const GeometricPoint point = moving_point(link);
  for (int moving = 0; moving < links(); ++moving) {
    for (int reference = 0; reference < links(); ++reference) {
      const PointMotion m = point_motion(model, point, {.moving = moving, .reference = reference, .axes = link});
      EXPECT_LT(size(m.relative_velocity + m.transport_velocity - m.absolute_velocity), 1e-45);
      const Vector sum = m.relative_acceleration + m.transport_acceleration + m.coriolis_acceleration;
      EXPECT_LT(size(sum - m.absolute_acceleration), 1e-44) << moving << " in " << reference;
    }
  }
}

/// The transport velocity is that of the point of the frame that is there at that instant: a point held there.
TEST_P(RandomPoint, IsCarriedByTheCoincidentPointOfTheFrame) {
  const int link = links() - 1;
  for (int moving = 0; moving < links(); ++moving) {
    const GeometricPoint point = moving_point(link);
    const PointMotion motion = point_motion(model, point, {.moving = moving});
    // The place in the moving frame as constants, rounded to 50 digits: its own rates are null.
    Vector held;
    for (int i = 0; i < 3; ++i) {
      const Real here = evaluate(model.locate(point.place, link, moving)[i]);
      held[i] = program.number(here.to_number(), units::metre);
    }
    const Vector position = bound(program, model.locate(held, moving, 0));
    const Vector v = bound(program, time_derivative(position));
    EXPECT_LT(size(motion.transport_velocity - v), 1e-45);
    EXPECT_LT(size(motion.transport_acceleration - time_derivative(v)), 1e-44);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPoint, ::testing::Range(400U, 412U));

/// A wheel of radius R that turns by phi about z on a carriage moving along x; I is under its centre C.
class WheelOnTheGround : public ::testing::Test {
 protected:
  static Scene make() {
    Scene scene("wheel_on_the_ground");
    const Expression radius = scene.parameter("R", "m");
    const FrameHandle carriage = scene.prismatic("carriage", scene.ground(), axis::x, scene.coordinate("x", "m"));
    const FrameHandle wheel = scene.revolute("wheel", carriage, axis::z, scene.coordinate("phi", "rad"));
    scene.body("wheel", wheel, Inertia::disk(Expression::quantity("1", "kg"), radius, 2));
    scene.point("I", carriage, {0, -radius, 0});
    return scene;
  }
  void expect(const Vector& v, const Value& x, const Value& y) {
    EXPECT_TRUE(identically_zero(v - Vector(x, y, Value())));
  }

  Equations equations{make()};
  Program& program = equations.program();
  const Model& model = equations.model();
  Value radius = program.lower(equations.scene().content().parameters[0].symbol);
  Value x1 = model.v(0), x2 = model.a(0), phi1 = model.v(1), phi2 = model.a(1);
};

TEST_F(WheelOnTheGround, HasAContactPointThatIsNoPointOfTheWheel) {
  const PointMotion motion = point_motion(model, Scene::point("I"), "wheel", "ground");
  const Value turn = radius * phi1;
  const Value square = turn * phi1;
  const Value angular = radius * phi2;
  expect(motion.position, model.q(0), -radius);
  expect(motion.absolute_velocity, x1, Value());
  expect(motion.transport_velocity, x1 + turn, Value());  // V(I ∈ wheel/ground): null when it rolls, x' = −R phi'
  expect(motion.relative_velocity, -turn, Value());
  expect(motion.absolute_acceleration, x2, Value());
  expect(motion.transport_acceleration, x2 + angular, square);
  expect(motion.relative_acceleration, -angular, square);
  expect(motion.coriolis_acceleration, Value(), Number(-2) * square);
}

TEST_F(WheelOnTheGround, IsSeenFromItsCarriageAtRest) {
  const PointMotion motion = point_motion(model, Scene::point("I"), "wheel", "carriage");
  expect(motion.absolute_velocity, Value(), Value());
  expect(motion.absolute_acceleration, Value(), Value());
  expect(motion.transport_velocity, radius * phi1, Value());
}

TEST_F(WheelOnTheGround, NamesThePointOrFrameThatDoesNotExist) {
  const std::string point = error_of<SceneError>([&] { point_motion(model, Scene::point("J"), "wheel", "ground"); });
  EXPECT_NE(point.find("'J'"), std::string::npos) << point;
  const std::string frame = error_of<SceneError>([&] { point_motion(model, Scene::point("I"), "wheels", "ground"); });
  EXPECT_NE(frame.find("'wheels'"), std::string::npos) << frame;
}

/// A sphere of radius R and centre C carried along x, y, z and turned by two angles, over a plate that slides along x.
class SphereOnAPlate : public ::testing::Test {
 protected:
  static Scene make() {
    Scene scene("sphere_on_a_plate");
    const Expression r = scene.parameter("R", "m");
    scene.prismatic("plate", scene.ground(), axis::x, scene.coordinate("p", "m"));
    const FrameHandle cx = scene.prismatic("cx", scene.ground(), axis::x, scene.coordinate("x", "m"));
    const FrameHandle cy = scene.prismatic("cy", cx, axis::y, scene.coordinate("y", "m"));
    const FrameHandle cz = scene.prismatic("cz", cy, axis::z, scene.coordinate("z", "m"));
    const FrameHandle yaw = scene.revolute("yaw", cz, axis::z, scene.coordinate("psi", "rad"));
    const FrameHandle sphere = scene.revolute("sphere", yaw, axis::x, scene.coordinate("theta", "rad"));
    scene.body("sphere", sphere, Inertia::solid_sphere(Expression::quantity("1", "kg"), r));
    scene.point("I", cz, {0, 0, -r});
    return scene;
  }
  Value rate(const char* name) { return program.lower(Expression(find(name))); }
  SymbolPointer find(const std::string& name) {
    for (const CoordinateContent& c : model.coordinates()) {
      if (c.q->name == name) return c.v;
    }
    return nullptr;
  }

  Equations equations{make()};
  Program& program = equations.program();
  const Model& model = equations.model();
  Value radius = program.lower(equations.scene().content().parameters[0].symbol);

  ContactMotion at_contact(const Triple& normal) {
    return contact_motion(model, {.body_1 = "sphere", .body_2 = "plate", .contact = Scene::point("I"), .normal = normal,
                                  .normal_axes = "ground"});
  }
};

TEST_F(SphereOnAPlate, SlidesRollsAndSpins) {
  // n = z from the plate to the sphere, given three times too long.
  const ContactMotion contact = at_contact({0, 0, 3});
  const Value psi = model.q(4);
  // Ω = psi' z + theta' u, u = (cos psi, sin psi, 0); V(I) = V(C) + Ω ∧ (−R z).
  const Vector u(program.cos(psi), program.sin(psi), Value());
  const Vector rolling = rate("theta") * u;
  const Vector minus_z(Value(), Value(), -radius);
  Vector sliding(rate("x") - rate("p"), rate("y"), Value());
  sliding += cross(rolling, minus_z);
  EXPECT_TRUE(identically_zero(contact.sliding - sliding));
  EXPECT_TRUE(identically_zero(contact.rolling - rolling));
  EXPECT_TRUE(identically_zero(contact.spinning - rate("psi")));
  EXPECT_TRUE(identically_zero(contact.separation - rate("z")));
  EXPECT_TRUE(identically_zero(contact.normal - Vector(Value(), Value(), program.number(Number(1)))));
}

TEST_F(SphereOnAPlate, HasTheOppositeMotionOfThePlateOnTheSphere) {
  const ContactMotion one = at_contact(axis::z);
  const ContactMotion other =
      contact_motion(model, {.body_1 = "plate", .body_2 = "sphere", .contact = Scene::point("I"), .normal = -axis::z,
                             .normal_axes = "ground"});
  EXPECT_TRUE(identically_zero(one.sliding + other.sliding));
  EXPECT_TRUE(identically_zero(one.rolling + other.rolling));
  EXPECT_TRUE(identically_zero(one.spinning - other.spinning));
  EXPECT_TRUE(identically_zero(one.separation - other.separation));
}

/// V(I ∈ S1/S2) = V(I/S2) − V(I/S1), the geometric point's velocities seen from either body.
TEST_F(SphereOnAPlate, SlidesWithTheDifferenceOfTheContactPointsVelocities) {
  const ContactMotion contact = at_contact(axis::z);
  const Vector in_plate = point_motion(model, Scene::point("I"), "plate", "plate").relative_velocity;
  const Vector in_sphere = point_motion(model, Scene::point("I"), "sphere", "sphere").relative_velocity;
  const Vector whole = contact.sliding + contact.separation * contact.normal;
  EXPECT_TRUE(identically_zero(in_plate - in_sphere - whole));
}

TEST_F(SphereOnAPlate, NeedsANormal) {
  EXPECT_EQ(error_of<SceneError>([&] { at_contact({0, 0, 0}); }),
            "the normal of a contact is the null vector: give the direction from S2 to S1");
}

}  // namespace
}  // namespace torsor::point_motion_test
