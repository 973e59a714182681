// SPDX-License-Identifier: MIT
#include "generator/torsor.hpp"

/// Thin heavy disk of radius rho that rolls without slipping on a horizontal plane while its centre G goes round a
/// circle of radius R at the height h (Pommier, 8.3.2 exercise 2). Euler's angles psi, theta, phi about z, x1, z2; the
/// axis of the disk is z2 and it touches the plane at I = G - rho y2. Six coordinates, so that the plane's whole
/// reaction is known: the normal force N, and X along x1, the way it rolls, and Y along y1, towards the centre of the
/// circle.
torsor::Scene disk_in_a_circle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("disk_in_a_circle", "Disk rolling without slipping while its centre goes round a circle");

  const Expression rho = scene.run_time_parameter("rho", "m", 2);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

  // The exercise's numbers: R = 10 m and h = 1 m = rho sin(theta). Question 1 of the page derives the rate of psi.
  const Expression R = Expression::quantity("10", "m");
  const Expression lean = pi() / 6;
  const Expression h = rho * sin(lean), d = rho * cos(lean);
  const Expression turning = sqrt(4 * g * d / (h * (6 * R + d)));
  scene.initial(x, 0, R * turning);
  scene.initial(y, -R);
  scene.initial(z, h);
  scene.initial(psi, 0, turning);
  scene.initial(theta, lean);
  scene.initial(phi, 0, -turning * (R + d) / rho);

  const FrameHandle disk = scene.free("disk", scene.ground(), AngleSequence::euler, {x, y, z}, {psi, theta, phi});
  const PointHandle I = scene.point("I", "disk.2", {0, -rho, 0});
  scene.body("disk", disk, Inertia::disk(m, rho, 2));
  scene.gravity({0, 0, -g});

  const ConstraintHandle contact = scene.point_in_plane("contact", I, scene.ground());
  scene.reaction(contact, "N", {.body = disk, .contact = I, .direction = axis::z, .axes = "disk.1"});
  const std::vector<ConstraintHandle> rolling =
      scene.rolling("rolling", {.body = disk, .on = scene.ground(), .contact = I, .tangents = "disk.1"});
  scene.reaction(rolling[0], "X", {.body = disk, .contact = I, .direction = axis::x, .axes = "disk.1"});
  scene.reaction(rolling[1], "Y", {.body = disk, .contact = I, .direction = axis::y, .axes = "disk.1"});
  return scene;
}

TORSOR_SCENE(disk_in_a_circle_scene)
