// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A physical pendulum whose attitude is a quaternion: it hangs by its point at the origin.
torsor::Scene floating_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("floating", "A body that hangs by a point");
  const Expression m = scene.parameter("m", "kg", 2), l = scene.parameter("l", "m", 0.5_r), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression A = scene.parameter("A", "kg m^2", 0.3_r), B = scene.parameter("B", "kg m^2", 0.2_r), C = scene.parameter("C", "kg m^2", 0.1_r);
  const FrameHandle body = scene.spherical("body", scene.ground(), scene.attitude("body"));
  scene.body("body", body, Inertia::general({.mass = m, .xx = A, .yy = B, .zz = C}).at({0, 0, -l}));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(floating_scene)
