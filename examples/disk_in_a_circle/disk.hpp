// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/generator/torsor.hpp"

namespace disk_scenes {

struct Weight {
  torsor::Expression rho, m, g;
};

/// Thin heavy disk of radius rho whose centre G goes round a circle of radius R at the height h (Pommier, 8.3.2 exercise
/// 2). Euler's angles psi, theta, phi about z, x1, z2; the axis of the disk is z2. Six coordinates, so that nothing is
/// assumed of the plane.
inline torsor::FrameHandle add_disk(torsor::Scene& scene, const Weight& disk) {
  using namespace torsor;
  const auto& [rho, m, g] = disk;
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

  const FrameHandle frame =
      scene.free("disk", scene.ground(), {x, y, z}, {.sequence = AngleSequence::euler, .angles = {psi, theta, phi}});
  scene.body("disk", frame, Inertia::disk(m, rho, 2));
  scene.gravity({0, 0, -g});
  return frame;
}

}  // namespace disk_scenes
