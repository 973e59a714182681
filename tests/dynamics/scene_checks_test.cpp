// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says of its joints, contacts and initial state is refused when it is not so.
#include "torsor/generator/dynamics/equations/scene_checks.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/axis_bounds.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::scene_checks_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

std::string refusal(const Scene& scene) {
  return error_of([&] { validate(scene); });
}

TEST(LawOfTime, IsRefusedWhenItDependsOnItsOwnCoordinate) {
  Scene scene = pendulum();
  const Expression phi = scene.coordinate("phi", "rad");
  EXPECT_EQ(
      error_of<SceneError>([&] { scene.drive(phi, sin(phi) + quantity("2", "rad/s") * scene.time()); }),
      "coordinate 'phi' cannot follow the law (sin(phi) + 2*t): that depends on 'phi' itself; write the law without "
      "'phi', as a formula of time and of coordinates that do not follow it");
  EXPECT_THROW(scene.drive(phi, rate(phi) * quantity("1", "s")), SceneError);
}

TEST(LawOfTime, IsRefusedWhenLawsNameEachOther) {
  Scene scene = pendulum();
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  scene.drive(a, 2 * b);
  scene.drive(b, c + quantity("1", "rad/s") * scene.time());
  EXPECT_EQ(error_of<SceneError>([&] { scene.drive(c, -a); }),
            "coordinate 'c' cannot follow the law -a: that depends on 'a', whose law depends on 'b', whose law depends "
            "on 'c' itself; write the law without 'c', as a formula of time and of coordinates that do not follow it");
  scene.drive(c, quantity("3", "rad/s") * scene.time());  // a chain of laws is one of time
  scene.body("wheel", scene.revolute("wheel", "arm", axis::z, a), Inertia::disk(kilograms("1"), metres("1"), 2));
  scene.body("second", scene.revolute("second", "arm", axis::z, b + c), Inertia::disk(kilograms("1"), metres("1"), 2));
  EXPECT_EQ(refusal(scene), "no error");
}

TEST(InitialAttitude, IsRefusedInAnotherUnit) {
  Scene scene("top");
  const AttitudeHandle e = scene.attitude("e");
  EXPECT_EQ(error_of<UnitError>([&] {
              scene.initial(e, {1, 0, 0, 0}, {quantity("3", "m/s"), 0, 0});
            }),
            "initial angular velocity of 'e' is given in m/s and must be in rad/s");
  EXPECT_EQ(error_of<UnitError>([&] {
              scene.initial(e, {metres("1"), 0, 0, 0});
            }),
            "initial quaternion of 'e' is given in m and must be in plain numbers");
  EXPECT_EQ(error_of([&] { scene.initial(e, {2, 1, 0, 0}, {quantity("3", "rad/s"), 1, 0}); }), "no error");
}

TEST(ReleasedCoordinate, HasNoInitialValue) {
  Scene scene = pendulum();
  const Expression held = scene.released_coordinate("held", "rad");
  EXPECT_EQ(
      error_of<SceneError>([&] { scene.initial(held, 1); }),
      "coordinate 'held' is released, held at zero by its joint, and has no initial value: drop initial('held'), or "
      "declare it by coordinate(...)");
}

Scene on_a_universal_joint(const Triple& first, const Triple& second) {
  Scene scene("shaft");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  const Inertia rod = Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("1.5"),
                                        .zz = moment("2")});
  scene.body(
      "shaft",
      scene.universal("shaft", scene.ground(), {.first = first, .first_angle = a, .second = second, .second_angle = b}),
      rod);
  return scene;
}

TEST(UniversalJoint, IsRefusedWithAxesThatAreNotPerpendicular) {
  EXPECT_EQ(refusal(on_a_universal_joint({1, 2, 2}, {2, 1, -2})), "no error");
  EXPECT_EQ(
      refusal(on_a_universal_joint({1, 0, 0}, {3, 4, 0})),
      "the axes (1, 0, 0) and (3, 4, 0) of the universal joint 'shaft' are not perpendicular (the cosine of their "
      "angle is 0.6): correct one, or make the joint of two revolute ones");
}

// Parameters may turn them later: libraries and units look at that where parameters are set.
TEST(UniversalJoint, HasABoundWhereParametersTurnItsAxes) {
  Scene scene("shaft");
  const Expression lean = scene.parameter("lean", "1", 0);
  scene.universal("shaft", scene.ground(), {.first = axis::x,
                                            .first_angle = scene.coordinate("a", "rad"),
                                            .second = {lean, 1, 0},
                                            .second_angle = scene.coordinate("b", "rad")});
  const auto said = [&](const Expression& value) {
    scene.set_parameter(lean, value);
    return error_of<SceneError>([&] {
      require_bounds(scene.content(), bounds_that_depend_on(scene.content(), {lean.as_symbol()}));
    });
  };
  EXPECT_EQ(said(0), "no error");
  EXPECT_EQ(said(0.75_r),
            "the axes (1, 0, 0) and (lean, 1, 0) of the universal joint 'shaft' are not perpendicular (the cosine of their angle "
            "is 0.6): correct one, or make the joint of two revolute ones");
}

TEST(Joint, HasABoundWhereParametersMakeItsAxis) {
  Scene scene("door");
  const Expression tilt = scene.parameter("tilt", "1", 1);
  scene.revolute("hinge", scene.ground(), {0, tilt, 0}, scene.coordinate("a", "rad"));
  EXPECT_EQ(bounds_that_depend_on(scene.content(), {tilt.as_symbol()}).size(), 1u);
  scene.set_parameter(tilt, 0);
  EXPECT_EQ(error_of<SceneError>([&] { require_bounds(scene.content(), bounds_of_axes(scene.content())); }),
            "the axis of joint 'hinge' is the null vector: give a direction");
}

Scene sliding_block(const Expression& coefficient, bool rolls) {
  Block it;
  if (rolls) {
    it.scene.rolling_resistance(
        "friction", it.floor,
        {.length = coefficient * metres("1"), .body = it.block, .direction = axis::y, .axes = it.scene.ground()});
  } else {
    it.slide(coefficient, axis::x, "friction");
  }
  return it.scene;
}

TEST(Friction, IsRefusedWithANegativeCoefficient) {
  EXPECT_EQ(refusal(sliding_block(0.2_r, false)), "no error");
  EXPECT_EQ(
      refusal(sliding_block(-0.2_r, false)),
      "friction 'friction' has the coefficient -1/5 = -0.2 and must not have a negative one: its force would push "
      "along the slip; turn the direction instead");
  EXPECT_TRUE(refusal(sliding_block(-0.2_r, true)).starts_with("friction 'friction' has the coefficient "));
}

TEST(Friction, IsRefusedWhereItDependsOnMoreThanTheState) {
  Block block;
  block.slide(rate(rate(block.x)) / quantity("100", "m/s^2") + 0.2_r, axis::x);
  EXPECT_TRUE(refusal(block.scene).starts_with("the coefficient of friction 'slide' depends on the acceleration 'x''' through"))
      << refusal(block.scene);
  Block pushed;
  const Expression u = pushed.scene.motor("push", pushed.x);
  pushed.slide(u / quantity("1", "N"), axis::x);
  EXPECT_TRUE(refusal(pushed.scene).starts_with("the coefficient of friction 'slide' depends on the input 'push' through"))
      << refusal(pushed.scene);
}

TEST(Friction, IsRefusedWhereTheMultiplierIsNoNormalForce) {
  const auto refused = [](const std::function<Expression(const Block&)>& left, const Triple& direction) {
    Block block;
    const ConstraintHandle table = block.scene.holonomic("table", left(block));
    block.scene.sliding_friction("slide", table,
                                 {.coefficient = 0.2_r, .body = block.block, .point = block.contact, .direction = direction,
                                  .axes = block.scene.ground()});
    return refusal(block.scene);
  };
  const auto slope = [](const Block& b) { return 0.6_r * b.x + 0.8_r * b.z; };
  EXPECT_EQ(refused(slope, {4, 0, -3}), "no error");
  EXPECT_EQ(refused(slope, axis::y), "no error");
  EXPECT_EQ(refused([&](const Block& b) { return 2 * slope(b); }, axis::y),
            "friction 'slide' needs the normal force of its contact, and the multiplier of constraint 'table' is 0.5 times that "
            "in the initial configuration: write the constraint as the distance itself, with a rate of 1 along the normal, "
            "(z - h)/sqrt(1 + h'^2) for z = h(x)");
  EXPECT_TRUE(refused([&](const Block& b) { return slope(b) / 2; }, axis::y).find(" is 2 times that in the initial") !=
              std::string::npos);
  EXPECT_EQ(refused(slope, axis::x),
            "the direction of friction 'slide' is not across the normal of constraint 'table' in the initial configuration: "
            "friction acts in the tangential plane; give a direction in it");
}

// z = x²/2 m has the slope x: at the vertex z - x²/2 has a rate of 1 along the normal, and nowhere else.
TEST(Friction, IsRefusedOnACurvedSurfaceWithoutItsDistance) {
  const auto refused = [](bool distance) {
    Scene scene("bowl");
    const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
    const FrameHandle bead = scene.prismatic("bead", scene.prismatic("slide", scene.ground(), axis::x, x), axis::z, z);
    scene.body("bead", bead, Inertia::point(kilograms("1")));
    const PointHandle point = scene.point("P", bead, {0, 0, 0});
    const Expression metre = metres("1"), slope = x / metre, height = z - x * x / (2 * metre);
    const ConstraintHandle bowl = scene.holonomic("bowl", distance ? height / sqrt(1 + slope * slope) : height);
    scene.sliding_friction("slide", bowl,
                           {.coefficient = 0.2_r, .body = bead, .point = point, .direction = {1, 0, slope}, .axes = scene.ground()});
    return refusal(scene);
  };
  EXPECT_EQ(refused(true), "no error");
  EXPECT_NE(refused(false).find(" times that in another configuration: "), std::string::npos) << refused(false);
}

// The tip of a rod that turns about a fixed pivot shows no force along the rod: of the normal of a floor a part alone.
TEST(Friction, IsTakenWhereAPartOfTheNormalDoesNothing) {
  const auto refused = [](const char* part) {
    Scene scene("rod");
    const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
    const FrameHandle rod = scene.revolute("rod", scene.revolute("yoke", scene.ground(), axis::z, a), axis::y, b);
    scene.body("rod", rod, Inertia::point(kilograms("1")).at({metres("5"), 0, 0}));
    const PointHandle tip = scene.point("tip", rod, {metres("5"), 0, 0});
    const PointHandle below = scene.point("below", scene.ground(), {0, 0, metres("-3")});
    scene.initial(b, atan2(Expression(3), Expression(4)));
    const ConstraintHandle floor = scene.closure("floor", below, tip, {0, 0, quantity(part, "1")});
    scene.sliding_friction("slide", floor,
                           {.coefficient = 0.2_r, .body = rod, .point = tip, .direction = axis::y, .axes = scene.ground()});
    return refusal(scene);
  };
  EXPECT_EQ(refused("1"), "no error");
  EXPECT_NE(refused("0.5").find(" is 2 times that in the initial configuration"), std::string::npos) << refused("0.5");
}

TEST(Friction, IsRefusedAtAPointWhereItsNormalForceIsNot) {
  Scene scene("wheel");
  const Expression z = scene.coordinate("z", "m"), turn = scene.coordinate("turn", "rad"), x = scene.coordinate("x", "m");
  const FrameHandle lift = scene.prismatic("lift", scene.prismatic("slide", scene.ground(), axis::x, x), axis::z, z);
  const FrameHandle wheel = scene.revolute("wheel", lift, axis::y, turn);
  scene.body("wheel", wheel, Inertia::disk(kilograms("1"), metres("1"), 1));
  const ConstraintHandle floor = scene.holonomic("floor", z);
  const PointHandle below = scene.point("below", lift, {0, 0, metres("-1")});
  const PointHandle beside = scene.point("beside", lift, {metres("1"), 0, 0});
  const auto sliding_at = [&](const PointHandle& point) {
    Scene tried = scene;
    tried.sliding_friction("slide", floor,
                           {.coefficient = 0.2_r, .body = wheel, .point = point, .direction = axis::x, .axes = tried.ground()});
    return refusal(tried);
  };
  EXPECT_EQ(sliding_at(below), "no error");
  EXPECT_EQ(sliding_at(beside),
            "friction 'slide' takes the multiplier of constraint 'floor' for the normal force at its point, and no force there "
            "does what that multiplier does to 'turn'': give the point at which the constraint's force acts");
}

TEST(InitialValue, IsRefusedAsAFormulaOfTheState) {
  Scene scene = pendulum();
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  scene.body("wheel", scene.revolute("wheel", "arm", axis::z, a), Inertia::disk(kilograms("1"), metres("1"), 2));
  scene.body("second", scene.revolute("second", "arm", axis::z, b), Inertia::disk(kilograms("1"), metres("1"), 2));
  scene.initial(b, 5);
  scene.initial(a, 2 * b);
  EXPECT_EQ(refusal(scene),
            "the initial value of 'a' depends on the coordinate 'b' through 2*b: give a formula of parameters");
}

TEST(IndependentCoordinate, IsRefusedALawOfTime) {
  Scene scene("cart");
  const Expression x = scene.coordinate("x", "m");
  scene.independent({x});
  EXPECT_EQ(error_of<SceneError>([&] { scene.drive(x, quantity("0.1", "m/s") * scene.time()); }),
            "coordinate 'x' is named in independent(...) and cannot follow a law of time: name an unknown one there");
}

TEST(Rolling, OfABodyOnItselfIsRefused) {
  Scene scene("wheel");
  const Expression x = scene.coordinate("x", "m"), turn = scene.coordinate("turn", "rad");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle wheel = scene.revolute("wheel", slide, axis::y, turn);
  scene.body("wheel", wheel, Inertia::disk(kilograms("1"), metres("1"), 1));
  const FrameHandle rim = scene.weld("rim", wheel, {{metres("1"), 0, 0}, {}});
  const PointHandle touch = scene.point("touch", slide, {0, 0, metres("-1")});
  Scene right = scene;
  right.no_slip("rolls", {.body = wheel, .contact = touch, .direction = axis::x, .axes = slide});
  EXPECT_EQ(refusal(right), "no error");
  scene.rolling("rolls", {.body = wheel, .on = rim, .contact = touch, .tangents = slide});
  EXPECT_EQ(
      refusal(scene),
      "constraint 'rolls_x': frame 'wheel' cannot slip on frame 'rim', for both are of one body; name the other body "
      "in contact");
}

/// A lever on the ground that turns about z by `start` twelfths of π, and is held by a second joint at its origin.
Scene held_lever(JointType type, int start, int placed, bool across) {
  Scene scene("lever");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  scene.initial(a, Expression(start) * pi() / Expression(12));
  const FrameHandle lever = scene.revolute("lever", scene.ground(), axis::z, a);
  const FrameHandle arm = scene.revolute("arm", lever, axis::x, b);
  scene.body(
      "arm", arm,
      Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("1.5"),
                        .zz = moment("2")}));
  const FrameHandle end = across ? scene.weld("end", arm, {{}, Rotation::about(1, -6)}) : arm;
  const Rotation turned = Rotation::about(2, placed);
  const FrameHandle seat = scene.weld("seat", scene.ground(), {{}, across ? turned * Rotation::about(1, -6) : turned});
  scene.loop_joint("held", {.type = type, .a = seat, .b = end});
  return scene;
}

TEST(ClosingJoint, IsRefusedWhenItStartsHalfATurnOff) {
  // About z the lever may stand at any angle of a revolute joint along z, but not upside down.
  EXPECT_EQ(refusal(held_lever(JointType::revolute, 3, 0, true)), "no error");
  EXPECT_EQ(refusal(held_lever(JointType::cylindrical, 5, 5, false)), "no error");
  EXPECT_EQ(
      refusal(held_lever(JointType::cylindrical, 17, 5, false)),
      "joint 'held' is assembled the wrong way round: at the start axis x of frame 'seat' and that of frame 'arm' "
      "have a cosine of -1 and must have 1; correct initial(...) of the coordinates it ties, or correct the placement of one "
      "frame");
  EXPECT_TRUE(refusal(held_lever(JointType::prismatic, 12, 0, false)).starts_with("joint 'held' is assembled"));
}

/// A body that a plane touches, in space.
struct Touching {
  Scene scene{"touching"};
  Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  FrameHandle body = scene.prismatic("body", along, axis::z, z);
  shape::Plane floor{.frame = scene.ground()};
  Touching() {
    scene.body("body", body, Inertia::point(kilograms("1")));
    scene.initial(z, metres("9"));
  }
};

TEST(DiscOnAPlane, IsRefusedWhereItLiesFlatInEveryPosition) {
  Touching it;
  it.scene.contact("c", shape::Disc{.frame = it.body, .axis = axis::z, .radius = metres("0.1")}, it.floor);
  EXPECT_EQ(refusal(it.scene),
            "the axis of contact 'c' is along the normal of its plane in every position: its rim lies flat, and touches at no "
            "single point; let points of the rim, a box or spheres touch instead");
}

TEST(SizesOfContacts, AreRefusedBelowZero) {
  const auto refused = [](const ContactShape& shape, Touching& it) {
    it.scene.contact("c", shape, it.floor);
    return refusal(it.scene);
  };
  const std::string size = ": give the size of what touches the plane";
  Touching ball, plate, ring, tube, good;
  EXPECT_EQ(refused(shape::Sphere{.frame = ball.body, .radius = -metres("0.1")}, ball),
            "contact 'c' has the radius -1/10 = -0.1" + size);
  const Expression r = plate.scene.parameter("r", "m", Number::rational(-1, 10));
  EXPECT_EQ(refused(shape::Disc{.frame = plate.body, .axis = axis::y, .radius = r}, plate),
            "contact 'c' has the radius r = -0.1" + size);
  const auto torus = [](const Touching& it, const Expression& circle_radius, const Expression& tube_radius) {
    return shape::Torus{.frame = it.body, .axis = axis::y, .circle_radius = circle_radius, .tube_radius = tube_radius};
  };
  EXPECT_EQ(refused(torus(ring, -metres("1"), metres("2")), ring),
            "contact 'c' has the radius -1 = -1" + size);
  EXPECT_EQ(refused(torus(tube, metres("1"), -metres("2")), tube),
            "contact 'c' has the tube's radius -2 = -2" + size);
  EXPECT_EQ(refused(torus(good, metres("1"), metres("0")), good), "no error");
}

// An internal point is nothing that its author wrote.
TEST(SizesOfContacts, OfOtherUnitsNameTheContact) {
  const auto refused = [](const ContactShape& shape, Touching& it) {
    return error_of<UnitError>([&] { it.scene.contact("c", shape, it.floor); }).substr(0, 46);
  };
  const Expression mass = quantity("1", "kg");
  Touching ball, plate, ring, egg;
  EXPECT_EQ(refused(shape::Sphere{.frame = ball.body, .radius = mass}, ball).find("the radius of the contact 'c'"), 0U);
  EXPECT_EQ(refused(shape::Disc{.frame = plate.body, .axis = {mass, 0, 0}, .radius = metres("1")}, plate)
                .find("a component of the axis of the contact 'c'"), 0U);
  EXPECT_EQ(refused(shape::Torus{.frame = ring.body, .axis = axis::y, .circle_radius = metres("1"), .tube_radius = mass}, ring)
                .find("the tube's radius of the contact 'c'"), 0U);
  EXPECT_EQ(refused(shape::Ellipsoid{.frame = egg.body, .semi_axes = {metres("1"), mass, metres("1")}}, egg)
                .find("the semi-axis of the contact 'c'"), 0U);
}

TEST(SizesOfContacts, AreFormulasOfParameters) {
  Touching ring, egg;
  const shape::Torus growing{.frame = ring.body, .axis = axis::y, .circle_radius = metres("1"), .tube_radius = ring.x};
  ring.scene.contact("c", growing, ring.floor);
  EXPECT_NE(refusal(ring.scene).find("the tube's radius of contact 'c'"), std::string::npos) << refusal(ring.scene);
  const Expression grown = metres("1") + quantity("1", "m/s") * egg.scene.time();
  egg.scene.contact("c", shape::Ellipsoid{.frame = egg.body, .semi_axes = {grown, metres("1"), metres("1")}}, egg.floor);
  EXPECT_NE(refusal(egg.scene).find("the support function of contact 'c'"), std::string::npos) << refusal(egg.scene);
}

// Along nothing nothing is held: taken as an equation it would hold whatever the motion.
TEST(DirectionsOfConstraints, AreNotNull) {
  const auto refused = [](auto hold) {
    Touching it;
    const PointHandle at = it.scene.point("at", it.body, {}), home = it.scene.point("home", it.scene.ground(), {});
    hold(it, at, home);
    return error_of([&] { Equations(it.scene).constraints(); });
  };
  const std::string message =
      "the direction of constraint 'c' is the null vector, along which nothing is held: give the direction";
  EXPECT_EQ(refused([](Touching& it, const PointHandle& at, const PointHandle& home) {
              it.scene.closure("c", home, at, {0, it.x / it.x - 1, 0});
            }),
            message);
  EXPECT_EQ(refused([](Touching& it, const PointHandle& at, const PointHandle&) {
              it.scene.no_slip("c", {.body = it.body, .contact = at, .direction = {0, 0, 0}, .axes = it.scene.ground()});
            }),
            message);
  EXPECT_EQ(refused([](Touching& it, const PointHandle& at, const PointHandle& home) {
              it.scene.closure("c", home, at, axis::z);
            }),
            "no error");
}

}  // namespace
}  // namespace torsor::scene_checks_test
