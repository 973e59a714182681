// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A ball dropped from 1 m that keeps 0.8 of its speed at an impact.
torsor::Scene bouncing_ball_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("bouncing_ball", "A ball that bounces");
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(scene.parameter("m", "kg", 1)));
  scene.gravity({0, 0, -scene.parameter("g", "m/s^2", 9.81_r)});
  scene.initial(z, 1);
  scene.contact("floor", shape::Point{scene.point("lowest", ball, {0, 0, 0})}, shape::Plane{.frame = scene.ground()},
                {.restitution = scene.parameter("e", "1", 0.8_r)});
  return scene;
}

TORSOR_SCENE(bouncing_ball_scene)
