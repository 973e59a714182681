// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "torsor/generator/torsor.hpp"

/// Four rods, the first hinged 0.35 m above a floor, fall from a line a little below the horizontal and come to rest on
/// it.
torsor::Scene chain_on_floor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("chain_on_floor", "A chain that falls on a floor");
  const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 0.25_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.3_r);
  const FrameHandle hinge = scene.weld("hinge", scene.ground(), {.origin = {0, 0, Expression::quantity("0.35", "m")}});
  FrameReference parent = hinge;
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    const Expression angle = scene.coordinate("a" + number, "rad");
    if (i == 1) scene.initial(angle, 0.1_r);
    const FrameHandle rod = scene.revolute("rod" + number, parent, axis::y, angle);
    scene.body("rod" + number, rod, Inertia::rod(m, l, 0).at({l / 2, 0, 0}));
    const FrameHandle end = scene.weld("end" + number, rod, {.origin = {l, 0, 0}});
    scene.contact("floor" + number, shape::Sphere{.frame = end, .radius = Expression::quantity("0.02", "m")},
                  shape::Plane{.frame = scene.ground()}, {.friction = f});
    parent = end;
  }
  scene.gravity({0, 0, -scene.parameter("g", "m/s^2", 9.81_r)});
  return scene;
}

TORSOR_SCENE(chain_on_floor_scene)
