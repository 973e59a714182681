// SPDX-License-Identifier: GPL-3.0-or-later
// A pendulum of LINKS slender rods of 1 kg and 1 m, one below the other, in the plane x, y; each angle from the rod
// above, so that the articulated-body recursion fits.
#include <string>

#include "torsor/generator/torsor.hpp"

torsor::Scene links_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  const std::string count = std::to_string(LINKS);
  Scene scene("work_precision_links_" + count, "Pendulum of " + count + " rods");
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression l = scene.parameter("l", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  FrameHandle above = scene.ground();
  for (int i = 0; i < LINKS; ++i) {
    const std::string number = std::to_string(i + 1);
    const Expression angle = scene.coordinate("theta_" + number, "rad");
    const FrameHandle rod = i == 0 ? scene.revolute("rod_1", above, axis::z, angle)
                                   : scene.revolute("rod_" + number, above, axis::z, angle, {.origin = {0, -l, 0}});
    scene.body("mass_" + number, rod,
               Inertia::general({.mass = m, .xx = m * l * l / 12, .zz = m * l * l / 12}).at({0, -l / 2, 0}));
    above = rod;
  }
  scene.gravity({0, -g, 0});
  return scene;
}

TORSOR_SCENE(links_scene)
