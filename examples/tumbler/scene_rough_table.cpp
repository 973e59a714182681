// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// The tumbler on a table of friction f, and nothing assumed of the contact: it rolls while f suffices, slips where it
/// does not, and jumps where the table does not press.
torsor::Scene tumbler_rough_table_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("tumbler_rough_table", "Tumbler on a table whose friction may not suffice");

  const Expression R = scene.parameter("R", "m", 0.05_r);
  const Expression a = scene.parameter("a", "m", 0.02_r);
  const Expression m = scene.parameter("m", "kg", 0.2_r);
  const Expression A = scene.parameter("A", "kg m^2", 0.0002_r);
  const Expression B = scene.parameter("B", "kg m^2", 0.00015_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.5_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

  const Expression lean = 1;
  const Expression psi_rate = Expression::quantity("5", "rad/s");
  const Expression phi_rate = Expression::quantity("3", "rad/s");
  // x, y and z are the centre of mass: about the centre of the sphere gravity would have a moment that inertia takes away
  // again in free flight, to rounding only. The sphere's centre stands above it by a along the tumbler's axis.
  scene.initial(x, 0, -R * sin(lean) * phi_rate - a * sin(lean) * psi_rate);
  scene.initial(y, a * sin(lean));
  scene.initial(z, R - a * cos(lean));
  scene.initial(psi, 0, psi_rate);
  scene.initial(theta, lean);
  scene.initial(phi, 0, phi_rate);

  const FrameHandle tumbler =
      scene.free("tumbler", scene.ground(), {x, y, z}, {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  scene.body("tumbler", tumbler, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = B}));
  scene.gravity({0, 0, -g});
  const FrameHandle sphere = scene.weld("sphere", tumbler, {.origin = {0, 0, a}});
  scene.contact("table", shape::Sphere{.frame = sphere, .radius = R}, shape::Plane{.frame = scene.ground()},
                {.friction = f});
  return scene;
}

TORSOR_SCENE(tumbler_rough_table_scene)
