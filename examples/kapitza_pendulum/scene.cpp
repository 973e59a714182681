// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Kapitza's pendulum: a simple pendulum whose pivot is shaken along the vertical by a cos(omega t). theta is measured
/// from the upward vertical. The force that shakes the pivot is asked for by releasing the motion it imposes.
torsor::Scene kapitza_pendulum_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("kapitza_pendulum", "Pendulum kept upside down by shaking its pivot");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression L = scene.parameter("L", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression a = scene.run_time_parameter("a", "m", 0.1_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 100);

  const Expression height = scene.coordinate("height", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression shaker = scene.released_coordinate("shaker", "m");
  scene.drive(height, a * cos(omega * scene.time()));
  scene.initial(theta, 0.2_r);

  const FrameHandle table = scene.prismatic("table", scene.ground(), axis::z, shaker);
  const FrameHandle pivot = scene.prismatic("pivot", table, axis::z, height);
  const FrameHandle pendulum = scene.revolute("pendulum", pivot, axis::y, theta);
  scene.body("pendulum", pendulum, Inertia::point(m).at({0, 0, L}));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(kapitza_pendulum_scene)
