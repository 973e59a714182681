// SPDX-License-Identifier: GPL-3.0-or-later
// Examples of docs/scene.md: scripts/scene_reference takes what stands between "// example: NAMES" and "// end".
#include "tests/documentation/scene_examples.hpp"

namespace torsor::scene_examples {
namespace {

TEST_F(SceneExamples, OfQuantities) {
  // example: parameter run_time_parameter coordinate
  const Expression M = scene.parameter("M", "kg", 2);
  const Expression half_M = scene.parameter("half_M", "kg", M / 2);
  const Expression L = scene.run_time_parameter("L", "m", 0.5_r);
  const Expression theta = scene.coordinate("theta", "rad");
  // end
  const Expression phi = scene.coordinate("phi", "rad");
  // example: set_parameter
  scene.set_parameter(M, 3);  // half_M is 1.5 kg now
  // end
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
  scene.spherical("top", "ground", {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
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
  all.push_back(Inertia::general({.mass = m, .xx = J, .yy = J, .zz = 2 * J}));
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
  all.push_back(Inertia::hollow_cylinder({.mass = m, .outer_radius = 2 * r, .inner_radius = r, .height = l, .axis = 2}));
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

}  // namespace
}  // namespace torsor::scene_examples
