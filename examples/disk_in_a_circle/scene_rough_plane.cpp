// SPDX-License-Identifier: MIT
#include "generator/torsor.hpp"

/// The disk of disk_in_a_circle on a plane of friction f, and nothing assumed of the contact: it rolls round its circle
/// while f suffices, slips where it does not, and leaves the plane where that does not press.
torsor::Scene disk_in_a_circle_rough_plane_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("disk_in_a_circle_rough_plane", "Disk in a circle on a plane whose friction may not suffice");

  const Expression rho = scene.parameter("rho", "m", 2);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression f = scene.run_time_parameter("f", "1", 1.2_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");

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
  scene.body("disk", disk, Inertia::disk(m, rho, 2));
  scene.gravity({0, 0, -g});
  scene.contact("plane", shape::Disc{.frame = disk, .axis = axis::z, .radius = rho}, shape::Plane{.frame = scene.ground()},
                {.friction = f});
  return scene;
}

TORSOR_SCENE(disk_in_a_circle_rough_plane_scene)
