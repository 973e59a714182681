// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Weather vane (Pommier, 8.2 exercise 1): a thin quarter disk in the plane x, y1 of its axes turns by theta about
/// (O, x), one of the two radii that bound it; x is vertical. A wind along y turns it round and the hinge holds it back
/// a little. The other five directions of the hinge are released virtually: nothing else acts on the plate, so that the
/// hinge's reactions in them are the components of the dynamic screw in O.
torsor::Scene weather_vane_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("weather_vane", "Weather vane: a quarter disk turning about one of its radii");

  const Expression R = scene.parameter("R", "m", 0.3_r);
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression C = scene.parameter("C", "N m", 0.4_r);
  const Expression c = scene.parameter("c", "N m s", 0.02_r);

  const Expression theta = scene.coordinate("theta", "rad");
  scene.initial(theta, 2, Expression::quantity("1", "rad/s"));
  // Force of the ground on the hinge along x, y, z and its moment in O about y and z.
  const Expression X = scene.released_coordinate("X", "m");
  const Expression Y = scene.released_coordinate("Y", "m");
  const Expression Z = scene.released_coordinate("Z", "m");
  const Expression M_y = scene.released_coordinate("M_y", "rad");
  const Expression M_z = scene.released_coordinate("M_z", "rad");

  const FrameHandle along_x = scene.prismatic("along_x", scene.ground(), axis::x, X);
  const FrameHandle along_y = scene.prismatic("along_y", along_x, axis::y, Y);
  const FrameHandle along_z = scene.prismatic("along_z", along_y, axis::z, Z);
  const FrameHandle about_y = scene.revolute("about_y", along_z, axis::y, M_y);
  const FrameHandle about_z = scene.revolute("about_z", about_y, axis::z, M_z);
  const FrameHandle vane = scene.revolute("vane", about_z, axis::x, theta);

  scene.body("vane", vane, Inertia::quarter_disk(m, R, 2));
  // The wind would have the plate along y: U = C cos(theta).
  scene.force_function("wind", C * cos(theta));
  scene.damper("hinge", theta, c);
  return scene;
}

TORSOR_SCENE(weather_vane_scene)
