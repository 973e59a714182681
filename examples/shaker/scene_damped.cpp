// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Not in the course: the same mass with a damper beside the spring. Their action has no force function for another
/// reason than that of scene_free_support.cpp: it depends on the velocity.
torsor::Scene shaker_damped_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("shaker_damped", "Mass on a spring and a damper from a shaken support");

  const Expression M = scene.parameter("M", "kg", 1);
  const Expression k = scene.parameter("k", "N/m", 400);
  const Expression c = scene.run_time_parameter("c", "N s/m", 4);
  const Expression l0 = scene.parameter("l0", "m", 0.2_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression h = scene.parameter("h", "m", 0.01_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 15);

  const Expression y = scene.coordinate("y", "m");
  scene.initial(y, l0 - M * g / k);

  scene.body("mass", scene.prismatic("mass", scene.ground(), axis::y, y), Inertia::point(M));
  scene.gravity({0, -g, 0});
  const Expression length = y - h * sin(omega * scene.time());
  scene.spring("spring", length, k, l0);
  scene.damper("damper", length, c);
  return scene;
}

TORSOR_SCENE(shaker_damped_scene)
