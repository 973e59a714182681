// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A cart that follows a speed which rises from 0 to 1 m/s within some w, at 0.5 s.
torsor::Scene rising_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("rising", "A cart that follows a law of time");
  const Expression x = scene.coordinate("x", "m"), w = scene.run_time_parameter("w", "s", 0.002_r);
  scene.body("cart", scene.prismatic("cart", scene.ground(), axis::x, x), Inertia::point(scene.parameter("m", "kg", 1)));
  const Expression since = scene.time() - Expression::quantity("0.5", "s");
  scene.nonholonomic("law", rate(x) - Expression::quantity("1", "m/s") / (1 + exp(-since / w)));
  return scene;
}

TORSOR_SCENE(rising_scene)
