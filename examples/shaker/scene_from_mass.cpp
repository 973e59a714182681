// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// The same mass alone, in the absolute frame: y is its height, and the spring is an outside action on it with the
/// force function U = -k (y - h sin(omega t) - l0)²/2 (Pommier, §6.5.3, where the square is lost in dU/dy). U is no
/// potential energy: its part dU/dt at constant y is no power of anything that acts on the mass.
torsor::Scene shaker_from_mass_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("shaker_from_mass", "Mass on a spring from a shaken support, seen from the mass alone");

  const Expression M = scene.parameter("M", "kg", 1);
  const Expression k = scene.parameter("k", "N/m", 400);
  const Expression l0 = scene.parameter("l0", "m", 0.2_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression h = scene.parameter("h", "m", 0.01_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 15);

  const Expression y = scene.coordinate("y", "m");
  scene.initial(y, l0 - M * g / k);

  scene.body("mass", scene.prismatic("mass", scene.ground(), axis::y, y), Inertia::point(M));
  scene.gravity({0, -g, 0});
  scene.force_function("spring", -k / 2 * pow(y - h * sin(omega * scene.time()) - l0, 2));
  return scene;
}

TORSOR_SCENE(shaker_from_mass_scene)
