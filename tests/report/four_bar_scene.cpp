// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A parallelogram of bars l, 2 l, l that hang from two pivots: closed with b = -a, c = a. Its plane is tilted, and its weight in it, so
/// that the condition across the plane is rounding.
torsor::Scene four_bar_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("four_bar", "A four-bar linkage");
  const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 1), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle plane = scene.weld("plane", scene.ground(), {{0, 0, 0}, Rotation::about(0, 1)});
  const FrameHandle left = scene.revolute("left", plane, axis::y, a);
  const FrameHandle across = scene.revolute("across", left, axis::y, b, {.origin = {0, 0, -l}});
  const FrameHandle right = scene.revolute("right", plane, axis::y, c, {.origin = {2 * l, 0, 0}});
  const Inertia hanging = Inertia::rod(m, l, 2).at({0, 0, -l / 2});
  scene.body("left", left, hanging);
  scene.body("across", across, Inertia::rod(m, 2 * l, 0).at({l, 0, 0}));
  scene.body("right", right, hanging);
  const FrameHandle end = scene.weld("end", across, {.origin = {2 * l, 0, 0}}), pin = scene.weld("pin", right, {.origin = {0, 0, -l}});
  scene.loop_joint("pin", {.type = JointType::spherical, .a = end, .b = pin});
  scene.gravity({0, g * sin(pi() / 12), -g * cos(pi() / 12)});
  scene.initial(a, 0.3_r);
  scene.initial(b, -0.3_r);
  scene.initial(c, 0.3_r);
  return scene;
}

TORSOR_SCENE(four_bar_scene)
