// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Tumbler (Pommier, 8.1 exercise 3): its base is a half sphere of radius R about C, which rolls without slipping on a
/// table. Euler's angles psi, theta, phi about z0, x1, z2; z2 is its axis of revolution and C G = -a z2, so that it
/// stands up again. Six coordinates: the contact z = R is a constraint, whose multiplier is the normal force.
/// These angles are singular upright, at theta = 0: the tumbler starts away from it.
torsor::Scene tumbler_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("tumbler", "Tumbler: a weighted half sphere rolling on a table");

  const Expression R = scene.parameter("R", "m", 0.05_r);
  const Expression a = scene.run_time_parameter("a", "m", 0.02_r);
  const Expression m = scene.parameter("m", "kg", 0.2_r);
  // About the centre of mass: across the axis, and about it.
  const Expression A = scene.parameter("A", "kg m^2", 0.0002_r);
  const Expression B = scene.parameter("B", "kg m^2", 0.00015_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

  // Pushed sideways from a lean of 1 rad; x' = R Omega_y and y' = -R Omega_x are what rolling demands.
  const Expression lean = 1;
  const Expression psi_rate = Expression::quantity("5", "rad/s");
  const Expression phi_rate = Expression::quantity("3", "rad/s");
  scene.initial(x, 0, -R * sin(lean) * phi_rate);
  scene.initial(z, R);
  scene.initial(psi, 0, psi_rate);
  scene.initial(theta, lean);
  scene.initial(phi, 0, phi_rate);

  const FrameHandle tumbler =
      scene.free("tumbler", scene.ground(), {x, y, z}, {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  const PointHandle I = scene.sphere_contact("I", tumbler, R, scene.ground());
  scene.body("tumbler", tumbler, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = B}).at({0, 0, -a}));
  scene.gravity({0, 0, -g});

  const ConstraintHandle contact = scene.point_in_plane("contact", I, scene.ground());
  scene.reaction(contact, "N", {.body = tumbler, .contact = I, .direction = axis::z, .axes = scene.ground()});
  const std::vector<ConstraintHandle> rolling =
      scene.rolling("rolling", {.body = tumbler, .on = scene.ground(), .contact = I, .tangents = scene.ground()});
  scene.reaction(rolling[0], "X", {.body = tumbler, .contact = I, .direction = axis::x, .axes = scene.ground()});
  scene.reaction(rolling[1], "Y", {.body = tumbler, .contact = I, .direction = axis::y, .axes = scene.ground()});
  return scene;
}

TORSOR_SCENE(tumbler_scene)
