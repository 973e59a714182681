// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// A block on a spring lies on a belt that runs at the velocity v0. Friction holds more than it brakes.
torsor::Scene stick_slip_belt_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("stick_slip_belt", "Block on a spring, carried along by a belt until it slips");

  const Expression m = scene.parameter("m", "kg", 2);
  const Expression k = scene.parameter("k", "N/m", 50);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression v0 = scene.run_time_parameter("v0", "m/s", 0.2_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.35_r);
  const Expression f_static = scene.run_time_parameter("f_static", "1", 0.5_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression z = scene.coordinate("z", "m");

  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle block = scene.prismatic("block", slide, axis::z, z);
  scene.body("block", block, Inertia::point(m));
  scene.gravity({0, 0, -g});
  scene.spring("spring", x, k);
  scene.contact("belt", shape::Point{.point = scene.point("foot", block, {})},
                shape::Plane{.frame = scene.ground(), .belt = {v0, 0}}, {.friction = f, .static_friction = f_static});
  return scene;
}

TORSOR_SCENE(stick_slip_belt_scene)
