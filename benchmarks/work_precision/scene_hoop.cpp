// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// Thin hoop m = 1, r = 0.5 rolling without slipping on a plane, its centre at (x, y, r sin theta): Euler's angles psi
/// (heading), theta (lean), phi (roll), and two multipliers in the contact, as in examples/rolling_hoop.
torsor::Scene hoop_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("work_precision_hoop", "Thin hoop rolling without slipping");
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression r = scene.parameter("r", "m", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression A = m * r * r / 2;
  const Expression C = m * r * r;
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  // The contact begins at the origin; omega about the axis is -6, about the diameter through the contact 0.5.
  const Expression lean = 1.2_r;
  const Expression psi_rate = Expression::quantity("0.5", "rad/s") / sin(lean);
  const Expression spin = Expression::quantity("-6", "rad/s");
  scene.initial(x, 0, -r * spin);
  scene.initial(y, r * cos(lean));
  scene.initial(psi, 0, psi_rate);
  scene.initial(theta, lean);
  scene.initial(phi, 0, spin - psi_rate * cos(lean));
  const FrameHandle hoop = scene.free("hoop", scene.ground(), {x, y, r * sin(theta)},
                                      {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  const PointHandle contact = scene.point("I", "hoop.2", {0, -r, 0});
  scene.body("hoop", hoop, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}));
  scene.gravity({0, 0, -g});
  scene.no_slip("along_x1", {.body = hoop, .contact = contact, .direction = axis::x, .axes = "hoop.1"});
  scene.no_slip("along_y1", {.body = hoop, .contact = contact, .direction = axis::y, .axes = "hoop.1"});
  return scene;
}

TORSOR_SCENE(hoop_scene)
