// SPDX-License-Identifier: GPL-3.0-or-later
// A pendulum on a rail, with frames whose names no identifier could be: of signs that XML and the standard of FMI treat apart.
#include "torsor/generator/torsor.hpp"

torsor::Scene odd_names_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("odd_names", "A \"pendulum\" & <its> frames");
  const Expression m = scene.parameter("m", "kg", 2), l = scene.parameter("l", "m", 0.4_r);
  const FrameHandle rod = scene.revolute("rod <&> \"it's\" \\n", scene.ground(), axis::y, scene.coordinate("theta", "rad"));
  scene.body("rod", rod, Inertia::point(m).at({0, 0, -l}));
  for (const char* name : {"a frame", "2.nd", "a..b", "c.", "d[1]", "e,f?"}) scene.weld(name, rod, {.origin = {0, 0, -l}});
  return scene;
}

TORSOR_SCENE(odd_names_scene)
