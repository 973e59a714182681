// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// The rolling hoop of scene.cpp with a parametrisation that the contact does not allow (Pommier, §6.5.5, second
/// illustration): six coordinates, z among them. The hoop may slip and leave the plane virtually, so the contact force
/// X_F x1 + Y_F y1 + N z works, and its three components are unknowns beside the accelerations.
torsor::Scene rolling_hoop_contact_forces_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("rolling_hoop_contact_forces",
              "Hoop rolling without slipping: six coordinates, the three contact forces");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression R = scene.parameter("R", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression A = scene.run_time_parameter("A", "kg m^2", m * R * R / 2);
  const Expression C = scene.run_time_parameter("C", "kg m^2", m * R * R);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

  const Expression lean = 1.2_r;
  const Expression psi_rate = Expression::quantity("0.5", "rad/s");
  const Expression theta_rate = Expression::quantity("-0.3", "rad/s");
  const Expression phi_rate = Expression::quantity("-4", "rad/s");
  scene.initial(x, 0, -R * (phi_rate + psi_rate * cos(lean)));
  scene.initial(y, R * cos(lean), -R * theta_rate * sin(lean));
  scene.initial(z, R * sin(lean), R * theta_rate * cos(lean));
  scene.initial(psi, 0, psi_rate);
  scene.initial(theta, lean, theta_rate);
  scene.initial(phi, 0, phi_rate);

  const FrameHandle hoop =
      scene.free("hoop", scene.ground(), {x, y, z}, {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  const PointHandle contact = scene.point("I", "hoop.2", {0, -R, 0});
  scene.body("hoop", hoop, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}));
  scene.gravity({0, 0, -g});
  const ConstraintHandle along_x1 =
      scene.no_slip("along_x1", {.body = hoop, .contact = contact, .direction = axis::x, .axes = "hoop.1"});
  const ConstraintHandle along_y1 =
      scene.no_slip("along_y1", {.body = hoop, .contact = contact, .direction = axis::y, .axes = "hoop.1"});
  const ConstraintHandle touching = scene.holonomic("touching", z - R * sin(theta));
  scene.reaction(along_x1, "X_F", {.body = hoop, .contact = contact, .direction = axis::x, .axes = "hoop.1"});
  scene.reaction(along_y1, "Y_F", {.body = hoop, .contact = contact, .direction = axis::y, .axes = "hoop.1"});
  scene.reaction(touching, "N", {.body = hoop, .contact = contact, .direction = axis::z, .axes = scene.ground()});
  // For pictures: the hoop with two diameters, which show how it turns.
  scene.show({.frame = hoop, .form = form::Torus{R, R / 30}});
  scene.show({.frame = hoop, .form = form::Segment{{-R, 0, 0}, {R, 0, 0}, R / 80}});
  scene.show({.frame = hoop, .form = form::Segment{{0, -R, 0}, {0, R, 0}, R / 80}});
  return scene;
}

TORSOR_SCENE(rolling_hoop_contact_forces_scene)
