// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A pendulum whose pivot is shaken: hanging, nothing accelerates it at any time, and its stiffness depends on time.
torsor::Scene shaken_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("shaken", "A pendulum that is shaken");
  const Expression l = scene.parameter("l", "m", 0.5_r), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression a = scene.parameter("a", "m", 0.02_r), omega = scene.parameter("omega", "rad/s", 40);
  const Expression z = scene.coordinate("z", "m"), theta = scene.coordinate("theta", "rad");
  scene.drive(z, a * cos(omega * scene.time()));
  const FrameHandle pivot = scene.prismatic("pivot", scene.ground(), axis::z, z);
  const FrameHandle rod = scene.revolute("rod", pivot, axis::y, theta);
  scene.body("rod", rod, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, -l}));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(shaken_scene)
