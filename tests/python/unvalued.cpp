// SPDX-License-Identifier: GPL-3.0-or-later
// A mass without a value on a spring.
#include "torsor/generator/torsor.hpp"

torsor::Scene unvalued_scene() {
  using namespace torsor;
  Scene scene("unvalued", "A mass without a value");
  const Expression m = scene.parameter("m", "kg"), k = scene.parameter("k", "N/m", 8);
  const Expression x = scene.coordinate("x", "m");
  scene.body("mass", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(m));
  scene.spring("spring", x, k);
  scene.initial(x, 1);
  return scene;
}

TORSOR_SCENE(unvalued_scene)
