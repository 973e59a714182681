// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a floor whose friction is a formula of its wear: at some wear it is no number that a surface has, although it is not
// below zero.
#include "torsor/generator/torsor.hpp"

torsor::Scene worn_floor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("worn_floor", "A block on a worn floor");
  const Expression m = scene.parameter("m", "kg", 2), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression wear = scene.run_time_parameter("wear", "1", 1);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  scene.initial(x, 0, 1);
  const FrameHandle block = scene.prismatic("block", scene.prismatic("rail", scene.ground(), axis::x, x), axis::z, z);
  scene.body("block", block, Inertia::point(m));
  scene.gravity({0, 0, -g});
  scene.contact("floor", shape::Point{scene.point("P", block, {0, 0, 0})}, shape::Plane{.frame = scene.ground()},
                {.friction = 1 / (5 * wear)});
  return scene;
}

TORSOR_SCENE(worn_floor_scene)
