// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A motion with a contact that ends before its second sample: a mass falls on a centre of attraction from nearby.
torsor::Scene short_motion_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("short_motion", "Fall on a centre of attraction");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle mass = scene.prismatic("mass", scene.ground(), axis::x, x);
  scene.body("mass", mass, Inertia::point(Expression::quantity("1", "kg")));
  scene.force_function("attraction", Expression::quantity("1", "J m") / x);
  scene.stop(x, std::nullopt, Expression::quantity("5", "m"));
  scene.initial(x, Expression::quantity("1/10000", "m"));
  return scene;
}

TORSOR_SCENE(short_motion_scene)
