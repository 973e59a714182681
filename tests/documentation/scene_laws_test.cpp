// SPDX-License-Identifier: GPL-3.0-or-later
// Examples of docs/scene.md, of actions, contacts and constraints: scripts/scene_reference takes what stands between "// example: NAMES" and "// end".
#include "tests/documentation/scene_examples.hpp"

namespace torsor::scene_examples {
namespace {

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
  // example: reflected_inertia
  scene.reflected_inertia("rotor", x, scene.parameter("rotor_mass", "kg", 3));
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
  // example: joint_friction
  scene.joint_friction("guide", slide, {.friction = 0.1_r});
  scene.joint_friction("journal", ball, {.friction = 0.2_r, .radius = scene.parameter("journal_radius", "m", 0.01_r)});
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
  // example: show
  scene.show({.frame = sleigh, .form = form::Box{{2 * l, l, l / 4}}, .colour = Colour{0.6, 0.4, 0.2}});
  scene.show({.frame = sleigh, .form = form::Segment{.from = {-l, 0, 0}, .to = {-l, 0, -l}, .radius = l / 50}});
  // end
  // example: keep_massless
  scene.keep_massless();
  // end
  stands();
}

}  // namespace
}  // namespace torsor::scene_examples
