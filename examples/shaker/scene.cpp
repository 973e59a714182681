// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Mass M on a spring from a support that a shaker moves along the vertical by h sin(omega t) (Pommier, §6.5.3). The
/// coordinate x is the height of the mass above the support: both ends of the spring are seen and -k (x - l0)²/2 is a
/// force function with a potential energy. The force of the shaker is asked for by releasing the motion it imposes.
torsor::Scene shaker_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("shaker", "Mass on a spring from a shaken support");

  const Expression M = scene.parameter("M", "kg", 1);
  const Expression k = scene.parameter("k", "N/m", 400);
  const Expression l0 = scene.parameter("l0", "m", 0.2_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression h = scene.parameter("h", "m", 0.01_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 15);

  const Expression height = scene.coordinate("height", "m");
  const Expression x = scene.coordinate("x", "m");
  const Expression drive = scene.released_coordinate("drive", "m");
  scene.drive(height, h * sin(omega * scene.time()));
  // At rest in the ground, where the spring carries the weight: the support starts at h omega below the mass.
  scene.initial(x, l0 - M * g / k, -h * omega);

  const FrameHandle table = scene.prismatic("table", scene.ground(), axis::y, drive);
  const FrameHandle support = scene.prismatic("support", table, axis::y, height);
  scene.body("mass", scene.prismatic("mass", support, axis::y, x), Inertia::point(M));
  scene.gravity({0, -g, 0});
  scene.spring("spring", x, k, l0);
  return scene;
}

TORSOR_SCENE(shaker_scene)
