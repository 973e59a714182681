// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "torsor/generator/torsor.hpp"

/// Five point masses on massless rods, one below the other, in the plane x, y; absolute angles from the downward
/// vertical.
torsor::Scene chain5_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("work_precision_chain5", "Five point masses on massless rods");
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression l = scene.parameter("l", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression starts[] = {1, 1.2_r, 1.4_r, 1.6_r, 1.8_r};
  FrameHandle above = scene.ground();
  Expression angle_above = 0;
  for (int i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i + 1);
    const Expression angle = scene.coordinate("theta_" + number, "rad");
    scene.initial(angle, starts[i]);
    const FrameHandle rod =
        i == 0 ? scene.revolute("rod_1", above, axis::z, angle)
               : scene.revolute("rod_" + number, above, axis::z, angle - angle_above, {.origin = {0, -l, 0}});
    scene.body("mass_" + number, rod, Inertia::point(m).at({0, -l, 0}));
    above = rod;
    angle_above = angle;
  }
  scene.gravity({0, -g, 0});
  return scene;
}

TORSOR_SCENE(chain5_scene)
