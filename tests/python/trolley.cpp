// SPDX-License-Identifier: GPL-3.0-or-later
// A trolley on a level rail, from which a load hangs by a rod. The rail rubs in proportion to what it carries, the hinge in
// proportion to what it transmits.
#include "torsor/generator/torsor.hpp"

torsor::Scene trolley_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("trolley", "A trolley whose joints rub");
  const Expression x = scene.coordinate("x", "m"), a = scene.coordinate("a", "rad");
  scene.initial(x, 0, 2);
  scene.initial(a, 1, 0.5_r);
  const FrameHandle car = scene.prismatic("car", scene.ground(), axis::x, x);
  const FrameHandle rod = scene.revolute("rod", car, -axis::y, a);
  scene.body("car", car, Inertia::point(scene.parameter("M", "kg", 3)));
  scene.body("rod", rod, Inertia::point(scene.parameter("m", "kg", 1)).at({0, 0, -scene.parameter("l", "m", 1)}));
  scene.gravity({0, 0, -scene.parameter("g", "m/s^2", 9.81_r)});
  scene.joint_friction("rail", car, {.friction = 0.2_r});
  scene.joint_friction("hinge", rod, {.friction = 0.1_r, .radius = scene.parameter("journal_radius", "m", 0.2_r)});
  return scene;
}

TORSOR_SCENE(trolley_scene)
