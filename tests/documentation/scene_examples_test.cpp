// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of docs/scene.md: scripts/scene_reference takes what stands between "// example: NAMES" and "// end".
#include <gtest/gtest.h>

#include "generator/dynamics/equations/equations.hpp"
#include "generator/dynamics/equations/validation.hpp"
#include "generator/expression/piecewise.hpp"
#include "generator/mechanics/inertia_operations.hpp"
#include "generator/mechanics/scene.hpp"

namespace torsor::scene_examples {
namespace {

using namespace torsor::literals;

/// A scene with some parameters. In the end it gets a body on the frame named last, unless it has one, and must be a
/// mechanism that can be solved for its motion.
class SceneExamples : public testing::Test {
 protected:
  void stands() {
    if (scene.content().bodies.empty()) {
      const FrameHandle last{static_cast<int>(scene.content().frames.size()) - 1};
      scene.body("load", last, Inertia::box(m, r, l, h).at({r, l, h}));
    }
    ASSERT_NO_THROW(validate(scene));
    const Equations equations(scene);
    EXPECT_FALSE(equations.inverse_dynamics().empty());
    EXPECT_FALSE(equations.forward().accelerations.empty());
  }

  Scene scene{"example"};
  const Expression m = scene.parameter("m", "kg", 2), r = scene.parameter("r", "m", 0.1_r),
                   l = scene.parameter("l", "m", 0.5_r);
  const Expression h = scene.parameter("h", "m", 0.3_r), g = scene.parameter("g", "m/s^2", 9.81_r);
};

TEST_F(SceneExamples, OfQuantities) {
  // example: parameter run_time_parameter coordinate
  const Expression M = scene.parameter("M", "kg", 2);
  const Expression half_M = scene.parameter("half_M", "kg", M / 2);
  const Expression L = scene.run_time_parameter("L", "m", 0.5_r);
  const Expression theta = scene.coordinate("theta", "rad");
  // end
  const Expression phi = scene.coordinate("phi", "rad");
  // example: drive time
  scene.drive(phi, 3 * sin(Expression::quantity("2", "1/s") * scene.time()));
  // end
  // example: initial
  scene.initial(theta, Expression(1) / 2, 3);  // theta = 0.5 rad, theta' = 3 rad/s
  // end
  // example: limits
  scene.limits(theta, {.lower = -2, .upper = 2, .velocity = 3, .effort = 40});
  // end
  const FrameHandle arm = scene.revolute("arm", "ground", axis::z, theta);
  const FrameHandle hand = scene.revolute("hand", arm, axis::x, phi, {.origin = {L, 0, 0}});
  scene.body("arm", arm, Inertia::rod(M, L, 0));
  scene.body("hand", hand, Inertia::solid_sphere(half_M, L));
  stands();
}

TEST_F(SceneExamples, OfReleasedCoordinatesAndAttitudes) {
  const Expression theta = scene.coordinate("theta", "rad");
  // example: released_coordinate
  const Expression Z = scene.released_coordinate("Z", "m");  // the kernel `reactions` gives the bearing's force along z
  const FrameHandle bearing = scene.prismatic("bearing", "ground", axis::z, Z);
  const FrameHandle wheel = scene.revolute("wheel", bearing, axis::z, theta);
  // end
  scene.body("wheel", wheel, Inertia::disk(m, r, 2));
  // example: attitude attitude_components
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle top = scene.spherical("top", "ground", e);
  const Expression tilt = scene.attitude_components(e)[1];
  // end
  scene.body("top", top, Inertia::cone(m, r, l, 2).at({0, 0, 3 * l / 4}));
  scene.force_function("vane", Expression::quantity("2", "J") * tilt);
  stands();
}

TEST_F(SceneExamples, OfSimpleJoints) {
  const Expression theta = scene.coordinate("theta", "rad"), x = scene.coordinate("x", "m");
  // example: ground weld
  const FrameHandle table = scene.weld("table", scene.ground(), {.origin = {0, 0, h}});
  // end
  // example: revolute
  const FrameHandle arm = scene.revolute("arm", table, axis::z, theta, {.origin = {0, 0, r}});
  // end
  // example: prismatic
  const FrameHandle hand = scene.prismatic("hand", arm, axis::x, x);
  // end
  // example: name_joint
  scene.name_joint(hand, "slide");
  // end
  stands();
}

TEST_F(SceneExamples, OfHelicalJoints) {
  // example: helical
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression pitch = scene.parameter("pitch", "m/rad", 0.001_r);
  const FrameHandle nut = scene.helical("nut", "ground", {.axis = axis::z, .angle = theta, .pitch = pitch});
  // end
  EXPECT_GT(nut.index, 0);
  stands();
}

TEST_F(SceneExamples, OfCylindricalJoints) {
  // example: cylindrical
  const Expression z = scene.coordinate("z", "m"), theta = scene.coordinate("theta", "rad");
  scene.cylindrical("piston", "ground", {.axis = axis::z, .displacement = z, .angle = theta});
  // end
  stands();
}

TEST_F(SceneExamples, OfUniversalJoints) {
  // example: universal
  const Expression alpha = scene.coordinate("alpha", "rad"), beta = scene.coordinate("beta", "rad");
  scene.universal("cross", "ground", {.first = axis::x, .first_angle = alpha, .second = axis::y, .second_angle = beta});
  // end
  stands();
}

TEST_F(SceneExamples, OfSphericalJoints) {
  // example: spherical
  const Expression psi = scene.coordinate("psi", "rad"), theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.spherical("top", "ground", AngleSequence::euler, {psi, theta, phi});
  scene.initial(theta, 1);  // Euler's angles are singular at theta = 0
  // end
  stands();
}

TEST_F(SceneExamples, OfPlanarJoints) {
  // example: planar
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression heading = scene.coordinate("heading", "rad");
  scene.planar("robot", "ground", {.x = x, .y = y, .angle = heading});
  // end
  stands();
}

TEST_F(SceneExamples, OfLineContactJoints) {
  // example: line_contact
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression yaw = scene.coordinate("yaw", "rad"), roll = scene.coordinate("roll", "rad");
  scene.line_contact("roller", "ground", {.x = x, .y = y, .yaw = yaw, .roll = roll});
  // end
  stands();
}

TEST_F(SceneExamples, OfSphereInCylinderJoints) {
  // example: sphere_in_cylinder
  const Expression x = scene.coordinate("x", "m");
  scene.sphere_in_cylinder("ball", "ground", {.axis = axis::x, .displacement = x, .turn = scene.attitude("e")});
  // end
  stands();
}

TEST_F(SceneExamples, OfPointContactJoints) {
  // example: point_contact
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  scene.point_contact("tip", "ground", {.x = x, .y = y, .turn = scene.attitude("e")});
  // end
  stands();
}

TEST_F(SceneExamples, OfFreeJoints) {
  // example: free
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle satellite = scene.free("satellite", "ground", {x, y, z}, scene.attitude("e"));
  // end
  EXPECT_GT(satellite.index, 0);
  stands();
}

/// A free body, whose point of contact is kept on the ground.
class ContactExamples : public SceneExamples {
 protected:
  void lies_on_the_floor(const PointHandle& touch) {
    scene.initial(z, r);
    scene.point_in_plane("floor", touch, "ground");
    stands();
  }

  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle body = scene.free("body", "ground", {x, y, z}, scene.attitude("e"));
};

TEST_F(ContactExamples, OfSphereContact) {
  const FrameHandle ball = body;
  // example: sphere_contact
  const PointHandle touch = scene.sphere_contact("touch", ball, r, "ground");
  // end
  // example: point
  scene.point("tip", ball, {r, 0, 0});
  scene.force("push", {.body = ball, .point = scene.point("tip"), .components = {m * g, 0, 0}, .axes = "ground"});
  // end
  lies_on_the_floor(touch);
}

TEST_F(ContactExamples, OfDiscContact) {
  const FrameHandle wheel = body;
  // example: disc_contact
  const PointHandle touch =
      scene.disc_contact("touch", {.frame = wheel, .axis = axis::y, .radius = r, .plane = "ground"});
  // end
  lies_on_the_floor(touch);
}

TEST_F(ContactExamples, OfTorusContact) {
  const FrameHandle tyre = body;
  // example: torus_contact
  const PointHandle touch = scene.torus_contact(
      "touch",
      {.frame = tyre, .axis = axis::y, .circle_radius = 0.9_r * r, .tube_radius = 0.1_r * r, .plane = "ground"});
  // end
  lies_on_the_floor(touch);
}

TEST_F(ContactExamples, OfEllipsoidContact) {
  const FrameHandle stone = body;
  // example: ellipsoid_contact
  const PointHandle touch = scene.ellipsoid_contact("touch", stone, {3 * r, 2 * r, r}, "ground");
  // end
  lies_on_the_floor(touch);
}

TEST_F(ContactExamples, OfSupportContact) {
  const FrameHandle ball = body;
  // example: support_contact
  const auto support = [&](const Triple& u) {  // of a sphere
    return r * sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  };
  const PointHandle touch = scene.support_contact("touch", ball, support, "ground");
  // end
  lies_on_the_floor(touch);
}

TEST_F(SceneExamples, OfInertias) {
  const Expression a = scene.parameter("a", "m", 0.3_r), b = scene.parameter("b", "m", 0.4_r);
  const Expression J = scene.parameter("J", "kg m^2", 1);
  std::vector<Inertia> all;
  // example: body
  const FrameHandle arm = scene.revolute("arm", "ground", axis::y, scene.coordinate("theta", "rad"));
  scene.body("arm", arm, Inertia::rod(m, l, 0).at({l / 2, 0, 0}));
  // end
  // example: Inertia::point
  all.push_back(Inertia::point(m).at({l, 0, 0}));
  // end
  // example: Inertia::general
  all.push_back(Inertia::general(m, J, J, 2 * J));
  // end
  // example: Inertia::rod
  all.push_back(Inertia::rod(m, l, 0));  // along x
  // end
  // example: Inertia::disk Inertia::ring
  all.push_back(Inertia::disk(m, r, 2));  // turns about z
  all.push_back(Inertia::ring(m, r, 2));
  // end
  // example: Inertia::cylinder Inertia::hollow_cylinder Inertia::cylindrical_shell
  all.push_back(Inertia::cylinder(m, r, l, 2));
  all.push_back(Inertia::hollow_cylinder(m, 2 * r, r, l, 2));
  all.push_back(Inertia::cylindrical_shell(m, r, l, 2));
  // end
  // example: Inertia::cone Inertia::conical_shell
  all.push_back(Inertia::cone(m, r, l, 2).at({0, 0, 3 * l / 4}));  // its apex at the origin
  all.push_back(Inertia::conical_shell(m, r, l, 2));
  // end
  // example: Inertia::solid_sphere Inertia::hollow_sphere
  all.push_back(Inertia::solid_sphere(m, r));
  all.push_back(Inertia::hollow_sphere(m, r));
  // end
  // example: Inertia::box Inertia::plate
  all.push_back(Inertia::box(m, a, b, l));
  all.push_back(Inertia::plate(m, a, b));
  // end
  // example: Inertia::half_disk Inertia::quarter_disk Inertia::triangle
  all.push_back(Inertia::half_disk(m, r, 2));
  all.push_back(Inertia::quarter_disk(m, r, 2));
  all.push_back(Inertia::triangle(m, {0, 0, 0}, {a, 0, 0}, {0, b, 0}));
  // end
  // example: at rotated
  all.push_back(Inertia::plate(m, a, b).rotated(axis::x, Expression(1) / 3).at({0, l, 0}));
  // end
  for (std::size_t i = 0; i < all.size(); ++i) scene.body("part_" + std::to_string(i), arm, all[i]);
  EXPECT_EQ(all.size(), 18U);
  stands();
}

TEST_F(SceneExamples, OfMeasuredVectors) {
  const Expression theta = scene.coordinate("theta", "rad"), phi = scene.coordinate("phi", "rad");
  const FrameHandle arm = scene.revolute("arm", "ground", axis::y, theta);
  const FrameHandle hand = scene.revolute("hand", arm, axis::y, phi, {.origin = {l, 0, 0}});
  scene.point("tip", hand, {l, 0, 0});
  const Expression k = scene.parameter("k", "J", 2), c = scene.parameter("c", "N s^2/m^2", 0.1_r);
  const Expression d = scene.parameter("d", "N m s", 0.1_r), s = scene.parameter("s", "N/m", 3);
  // example: direction
  scene.force_function("compass", k * scene.direction("hand", axis::x, "ground")[2]);
  // end
  // example: position
  const Triple p = scene.position(scene.point("tip"), "ground");
  scene.force_function("elastic", -s * (p[0] * p[0] + p[2] * p[2]) / 2);
  // end
  // example: angular_velocity
  const Expression spin = scene.angular_velocity("hand", "ground")[1];
  scene.torque("brake", "hand", {0, -d * spin, 0}, "ground");
  // end
  // example: velocity
  const Triple v = scene.velocity(scene.point("tip"), "hand", "ground");
  scene.force("wind", {.body = "hand",
                       .point = scene.point("tip"),
                       .components = {-c * abs(v[0]) * v[0], 0, -c * abs(v[2]) * v[2]},
                       .axes = "ground"});
  // end
  stands();
}

TEST_F(SceneExamples, OfActions) {
  const Expression x = scene.coordinate("x", "m"), theta = scene.coordinate("theta", "rad");
  const FrameHandle trolley = scene.prismatic("trolley", "ground", axis::x, x);
  const FrameHandle rod = scene.revolute("rod", trolley, axis::y, theta);
  scene.body("trolley", trolley, Inertia::point(m));
  scene.body("rod", rod, Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
  const PointHandle tip = scene.point("tip", rod, {0, 0, -l}), wall = scene.point("wall", "ground", {4 * l, 0, 0});
  const Expression k = scene.parameter("k", "N/m", 100), c = scene.parameter("c", "N s/m", 2),
                   F = scene.parameter("F", "N", 3);
  const Expression C = scene.parameter("C", "N m", 1), d = scene.parameter("d", "N m s", 1),
                   f = scene.parameter("f", "N s^2/m^2", 1);
  // example: gravity
  scene.gravity({0, 0, -g});
  // end
  // example: spring damper
  scene.spring("spring", x, k);                                            // on a coordinate
  scene.spring("rope", {.a = tip, .b = wall, .stiffness = k, .rest = l});  // between two points
  scene.damper("damper", x, c);
  scene.damper("shock_absorber", tip, wall, c);
  // end
  // example: motor
  const Expression drive = scene.motor("drive", x);  // its force is an input of the kernels
  // end
  static_cast<void>(drive);
  // example: force
  scene.force("push", {.body = "rod", .point = tip, .components = {F, 0, 0}, .axes = "ground"});
  // end
  // example: torque
  scene.torque("twist", "rod", {0, C, 0}, "rod");
  // end
  // example: wrench
  scene.wrench("hand", {.body = "rod", .point = tip, .force = {0, 0, F}, .moment = {0, C, 0}, .axes = "rod"});
  // end
  // example: force_function
  scene.force_function("magnet", C * cos(2 * theta));
  // end
  // example: generalised_force
  const Expression v = rate(x);
  scene.generalised_force("air", x, -f * abs(v) * v);
  // end
  // example: gravitation
  scene.gravitation("attraction", tip, wall, scene.parameter("G", "N m^2", 0.1_r));
  // end
  // example: drag rotational_drag
  scene.drag("water", {.body = "rod", .point = tip, .coefficient = c});
  scene.rotational_drag("grease", "rod", d, "trolley");
  // end
  // example: force_between torque_between
  scene.force_between("pair", {.a = "rod", .b = "trolley", .point = tip, .components = {F, 0, 0}, .axes = "trolley"});
  scene.torque_between("actuator", {.a = "rod", .b = "trolley", .components = {0, C, 0}, .axes = "trolley"});
  // end
  stands();
}

TEST_F(SceneExamples, OfContactLaws) {
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  scene.initial(z, r);
  scene.initial(x, 0, Expression::quantity("1", "m/s"));
  const FrameHandle ball = scene.free("ball", "ground", {x, y, z}, scene.attitude("e"));
  scene.body("ball", ball, Inertia::solid_sphere(m, r));
  scene.gravity({0, 0, -g});
  const Expression f = scene.parameter("f", "1", 0.3_r), d = scene.parameter("d", "m", 0.001_r);
  // example: sliding_friction
  const PointHandle touch = scene.sphere_contact("touch", ball, r, "ground");
  const ConstraintHandle floor = scene.point_in_plane("floor", touch, "ground");
  scene.sliding_friction("slides", floor,
                         {.coefficient = f,
                          .body = ball,
                          .point = touch,
                          .direction = scene.velocity(touch, ball, "ground"),
                          .axes = "ground"});
  // end
  // example: rolling_resistance spinning_resistance
  const Triple turn = scene.angular_velocity(ball, "ground");
  scene.rolling_resistance("rolls", floor,
                           {.length = d, .body = ball, .direction = {turn[0], turn[1], 0}, .axes = "ground"});
  scene.spinning_resistance("spins", floor,
                            {.length = d, .body = ball, .direction = {0, 0, turn[2]}, .axes = "ground"});
  // end
  stands();
}

TEST_F(SceneExamples, OfALawOfFriction) {
  const Expression px = scene.coordinate("x", "m"), py = scene.coordinate("y", "m"), pz = scene.coordinate("z", "m");
  const FrameHandle x_slide = scene.prismatic("x_slide", "ground", axis::x, px),
                    y_slide = scene.prismatic("y_slide", x_slide, axis::y, py);
  const FrameHandle block = scene.prismatic("block", y_slide, axis::z, pz);
  // example: friction_law
  const PointHandle foot = scene.point("foot", block, {0, 0, 0});
  const ConstraintHandle held = scene.point_in_plane("held", foot, "ground");
  const auto stribeck = [](const Expression& s) {
    return Expression(3) / 10 + exp(-s / Expression::quantity("0.1", "m/s"));
  };
  scene.friction_law("friction", held, {.law = stribeck, .body = block, .point = foot, .plane = "ground"});
  // end
  stands();
}

TEST_F(SceneExamples, OfContactsThatOpenAndClose) {
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), theta = scene.coordinate("theta", "rad");
  const FrameHandle slide = scene.prismatic("slide", "ground", axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  const FrameHandle ball = scene.revolute("ball", lift, axis::y, theta);
  scene.body("ball", ball, Inertia::solid_sphere(m, r));
  scene.initial(z, h);
  // example: contact
  scene.contact("floor", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = "ground"}, {.restitution = 0.8_r});
  // end
  // example: stop
  scene.stop(x, -l, l);
  // end
  // example: dry_friction
  scene.dry_friction("bearing", theta, {.bound = scene.parameter("bound", "N m", 0.01_r)});
  // end
  stands();
}

TEST_F(SceneExamples, OfConstraints) {
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const Expression u = scene.coordinate("u", "m"), w = scene.coordinate("w", "m"), phi = scene.coordinate("phi", "rad");
  const FrameHandle ball = scene.free("ball", "ground", {x, y, z}, scene.attitude("e"));
  scene.body("ball", ball, Inertia::solid_sphere(m, r));
  scene.initial(z, r);
  scene.body("a", scene.prismatic("a", "ground", axis::x, u), Inertia::point(m));
  scene.body("b", scene.prismatic("b", "ground", axis::y, w), Inertia::point(m));
  scene.body("c", scene.revolute("c", "ground", axis::z, phi, {.origin = {l, 0, 0}}), Inertia::rod(m, l, 0));
  // example: point_in_plane rolling
  const PointHandle touch = scene.sphere_contact("touch", ball, r, "ground");
  scene.point_in_plane("floor", touch, "ground");
  scene.rolling("rolls", {.body = ball, .on = "ground", .contact = touch, .tangents = "ground"});
  // end
  // example: holonomic
  const ConstraintHandle belt = scene.holonomic("belt", u - w);
  // end
  static_cast<void>(belt);
  // example: nonholonomic
  scene.nonholonomic("gear", rate(phi) - rate(u) / r);
  // end
  // example: independent
  scene.independent({u});
  // end
  stands();
}

TEST_F(SceneExamples, OfLoopsAndReactions) {
  const Expression alpha = scene.coordinate("alpha", "rad"), beta = scene.coordinate("beta", "rad"),
                   s = scene.coordinate("s", "m");
  const FrameHandle crank = scene.revolute("crank", "ground", axis::y, alpha);
  const FrameHandle rod = scene.revolute("rod", crank, axis::y, beta, {.origin = {r, 0, 0}});
  const FrameHandle slider = scene.prismatic("slider", "ground", axis::x, s);
  scene.body("crank", crank, Inertia::rod(m, r, 0).at({r / 2, 0, 0}));
  scene.body("rod", rod, Inertia::rod(m, l, 0).at({l / 2, 0, 0}));
  scene.body("slider", slider, Inertia::point(m));
  scene.initial(s, r + l);
  // example: closure
  const PointHandle end = scene.point("end", rod, {l, 0, 0}), pin = scene.point("pin", slider, {0, 0, 0});
  scene.closure("closed_x", end, pin, axis::x);
  const ConstraintHandle closed_z = scene.closure("closed_z", end, pin, axis::z);
  // end
  // example: reaction
  scene.reaction(closed_z, "guide",
                 {.body = "slider", .contact = end, .direction = axis::z, .axes = "ground", .other = "rod"});
  // end
  stands();
}

TEST_F(SceneExamples, OfJointsThatCloseLoops) {
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle left = scene.revolute("left", "ground", axis::y, a);
  const FrameHandle middle = scene.revolute("middle", left, axis::y, b, {.origin = {0, 0, l}});
  const FrameHandle right = scene.revolute("right", "ground", axis::y, c, {.origin = {2 * l, 0, 0}});
  scene.body("left", left, Inertia::rod(m, l, 2).at({0, 0, l / 2}));
  scene.body("middle", middle, Inertia::rod(m, 2 * l, 0).at({l, 0, 0}));
  scene.body("right", right, Inertia::rod(m, l, 2).at({0, 0, l / 2}));
  // example: loop_joint
  const FrameHandle end = scene.weld("end", middle, {.origin = {2 * l, 0, 0}});
  const FrameHandle top = scene.weld("top", right, {.origin = {0, 0, l}});
  scene.loop_joint("pin", {.type = JointType::spherical, .a = end, .b = top});
  // end
  stands();
}

TEST_F(SceneExamples, OfNoSlip) {
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"),
                   heading = scene.coordinate("heading", "rad");
  const FrameHandle sleigh = scene.planar("sleigh", "ground", {.x = x, .y = y, .angle = heading});
  // example: no_slip
  const PointHandle blade = scene.point("blade", sleigh, {-l, 0, 0});
  scene.no_slip("knife_edge", {.body = sleigh, .contact = blade, .direction = axis::y, .axes = sleigh});
  // end
  // example: keep_massless
  scene.keep_massless();
  // end
  stands();
}

}  // namespace
}  // namespace torsor::scene_examples
