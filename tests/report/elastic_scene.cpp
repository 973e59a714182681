// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A pendulum of 1 m on a rod that is a stiff spring, 2e9 N/m, with names that all objects of JavaScript have.
torsor::Scene elastic_scene() {
  using namespace torsor;
  Scene scene("elastic", "A pendulum on a stiff rod");
  const Expression m = scene.parameter("valueOf", "kg", 1), k = scene.parameter("k", "N/m", 2'000'000'000);
  const Expression l = scene.parameter("l", "m", 1), g = scene.parameter("g", "m/s^2", Expression::quantity("9.81", "m/s^2"));
  const Expression angle = scene.coordinate("constructor", "rad"), longer = scene.coordinate("toString", "m");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::y, angle);
  const FrameHandle end = scene.prismatic("end", arm, axis::z, -l - longer);
  scene.body("bob", end, Inertia::point(m));
  scene.gravity({0, 0, -g});
  scene.spring("rod", longer, k);
  scene.initial(angle, Expression::quantity("0.5", "rad"));
  return scene;
}

TORSOR_SCENE(elastic_scene)
