// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Vibration absorber made of a spring and a mass: m1 stands on k1 and is shaken by f cos(omega t); m2 hangs on it by
/// k2 and a damper c2. Both move along x and are at rest at zero.
torsor::Scene sprung_absorber_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("sprung_absorber", "Mass on a spring, shaken, with a smaller one as its absorber");

  const Expression m1 = scene.parameter("m1", "kg", 1);
  const Expression m2 = scene.parameter("m2", "kg", 0.1_r);
  const Expression k1 = scene.parameter("k1", "N/m", 100);
  const Expression k2 = scene.run_time_parameter("k2", "N/m", 10);
  const Expression c2 = scene.run_time_parameter("c2", "N s/m", 0);
  const Expression f = scene.run_time_parameter("f", "N", 1);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 10);

  const Expression x1 = scene.coordinate("x1", "m");
  const Expression x2 = scene.coordinate("x2", "m");
  // On the steady motion of the values as they stand: x1 = 0, x2 = -(f/k2) cos(omega t).
  scene.initial(x2, -f / k2);

  const FrameHandle machine = scene.prismatic("machine", scene.ground(), axis::x, x1);
  const FrameHandle absorber = scene.prismatic("absorber", scene.ground(), axis::x, x2);
  const PointHandle A = scene.point("A", machine, {0, 0, 0});
  scene.body("machine", machine, Inertia::point(m1));
  scene.body("absorber", absorber, Inertia::point(m2));
  scene.spring("foundation", x1, k1);
  scene.spring("coupling", x2 - x1, k2);
  scene.damper("friction", x2 - x1, c2);
  scene.force(
      "shaking",
      {.body = machine, .point = A, .components = {f * cos(omega * scene.time()), 0, 0}, .axes = scene.ground()});
  return scene;
}

TORSOR_SCENE(sprung_absorber_scene)
