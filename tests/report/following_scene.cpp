// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A stiffness that follows another one, b = k^2 / (2 N/m), and a mass without a value: m x'' = (b - k) x - c x'.
torsor::Scene following_scene() {
  using namespace torsor;
  Scene scene("following", "A parameter follows another");
  const Expression m = scene.parameter("m", "kg"), k = scene.parameter("k", "N/m", 1), c = scene.parameter("c", "N s/m", 1);
  const Expression b = scene.parameter("b", "N/m", k * k / Expression::quantity("2", "N/m"));
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle block = scene.prismatic("block", scene.ground(), axis::x, x);
  scene.body("block", block, Inertia::point(m));
  scene.spring("pulls", x, k);
  scene.spring("pushes", x, -b);
  scene.damper("brakes", x, c);
  scene.initial(x, 1);
  return scene;
}

TORSOR_SCENE(following_scene)
