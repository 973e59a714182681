// SPDX-License-Identifier: GPL-3.0-or-later
// A bead on an upright ring of radius l, which slides along the ring's axis too. It starts where sine and cosine are 3/5 and 4/5,
// on the ring whatever its radius; where the ring is stretched, it starts off it.
#include "torsor/generator/torsor.hpp"

torsor::Scene ring_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("ring", "A bead on a ring");
  const Expression m = scene.run_time_parameter("m", "kg", 2), l = scene.run_time_parameter("l", "m", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r), stretch = scene.run_time_parameter("stretch", "1", 1);
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  const FrameHandle along = scene.prismatic("along", across, axis::y, y);
  const FrameHandle bead = scene.prismatic("bead", along, axis::z, z);
  scene.body("bead", bead, Inertia::point(m));
  scene.holonomic("ring", x * x + z * z - stretch * stretch * l * l);
  scene.gravity({0, 0, -g});
  scene.initial(x, 3 * l / 5);
  scene.initial(z, -4 * l / 5);
  scene.initial(y, 1);
  return scene;
}

TORSOR_SCENE(ring_scene)
