// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Hoop (or disc) rolling without slipping on a horizontal plane (Pommier, §6.5.5), with coordinates compatible with
/// the contact: z = R sin(theta) is built in, and two multipliers hold the point of contact along x1 and y1. Euler's
/// angles psi, theta, phi about z, x1, z2; the axis of the hoop is z2, the contact lies at -R y2 from its centre G.
torsor::Scene rolling_hoop_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("rolling_hoop", "Hoop rolling without slipping: five coordinates, two multipliers");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression R = scene.parameter("R", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  // Moments of inertia about a diameter and about the axis: of a hoop as they stand; of a disc m R^2/4 and m R^2/2.
  const Expression A = scene.run_time_parameter("A", "kg m^2", m * R * R / 2);
  const Expression C = scene.run_time_parameter("C", "kg m^2", m * R * R);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

  // Touches the origin, rolls along x and begins to turn; x' and y' are what rolling demands.
  const Expression lean = 1.2_r;
  const Expression psi_rate = Expression::quantity("0.5", "rad/s");
  const Expression theta_rate = Expression::quantity("-0.3", "rad/s");
  const Expression phi_rate = Expression::quantity("-4", "rad/s");
  scene.initial(x, 0, -R * (phi_rate + psi_rate * cos(lean)));
  scene.initial(y, R * cos(lean), -R * theta_rate * sin(lean));
  scene.initial(psi, 0, psi_rate);
  scene.initial(theta, lean, theta_rate);
  scene.initial(phi, 0, phi_rate);

  const FrameHandle hoop = scene.free("hoop", scene.ground(), {x, y, R * sin(theta)},
                                      {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  const PointHandle contact = scene.point("I", "hoop.2", {0, -R, 0});
  scene.body("hoop", hoop, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}));
  scene.gravity({0, 0, -g});
  scene.no_slip("along_x1", {.body = hoop, .contact = contact, .direction = axis::x, .axes = "hoop.1"});
  scene.no_slip("along_y1", {.body = hoop, .contact = contact, .direction = axis::y, .axes = "hoop.1"});
  // For pictures: the hoop with two diameters, which show how it turns.
  scene.show({.frame = hoop, .form = form::Torus{R, R / 30}});
  scene.show({.frame = hoop, .form = form::Segment{{-R, 0, 0}, {R, 0, 0}, R / 80}});
  scene.show({.frame = hoop, .form = form::Segment{{0, -R, 0}, {0, R, 0}, R / 80}});
  return scene;
}

TORSOR_SCENE(rolling_hoop_scene)
