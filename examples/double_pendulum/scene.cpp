// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Planar double pendulum: two point masses on massless rods, both angles absolute, from the downward vertical. y
/// points up and the motion takes place in the plane x, y.
torsor::Scene double_pendulum_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("double_pendulum", "Planar double pendulum with absolute angles");

  const Expression m1 = scene.parameter("m1", "kg", 1);
  const Expression m2 = scene.parameter("m2", "kg", 1);
  const Expression l1 = scene.parameter("l1", "m", 1);
  const Expression l2 = scene.parameter("l2", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression theta_1 = scene.coordinate("theta_1", "rad");
  const Expression theta_2 = scene.coordinate("theta_2", "rad");
  scene.initial(theta_1, 2);
  scene.initial(theta_2, 2.5_r);

  const FrameHandle upper = scene.revolute("upper", scene.ground(), axis::z, theta_1);
  const FrameHandle lower = scene.revolute("lower", upper, axis::z, theta_2 - theta_1, {.origin = {0, -l1, 0}});
  scene.body("first_mass", upper, Inertia::point(m1).at({0, -l1, 0}));
  scene.body("second_mass", lower, Inertia::point(m2).at({0, -l2, 0}));
  scene.gravity({0, -g, 0});
  return scene;
}

TORSOR_SCENE(double_pendulum_scene)
