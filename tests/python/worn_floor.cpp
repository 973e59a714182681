// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a floor whose friction is a formula of its wear: at some wear it is no number that a surface has, although it is not
// below zero. A crank, whose journal rubs in proportion to what it carries, has its pin in a slot of the block.
#include "torsor/generator/torsor.hpp"

torsor::Scene worn_floor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("worn_floor", "A block on a worn floor, and a crank");
  const Expression m = scene.parameter("m", "kg", 2), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression r = scene.parameter("r", "m", 0.5_r);
  const Expression wear = scene.run_time_parameter("wear", "1", 1), grease = scene.run_time_parameter("grease", "1", 0.1_r);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), turn = scene.coordinate("turn", "rad");
  scene.initial(x, 0, 1);
  scene.initial(turn, 0, 2);
  const FrameHandle block = scene.prismatic("block", scene.prismatic("rail", scene.ground(), axis::x, x), axis::z, z);
  scene.body("block", block, Inertia::point(m));
  scene.gravity({0, 0, -g});
  const PointHandle P = scene.point("P", block, {0, 0, 0});
  scene.contact("floor", shape::Point{P}, shape::Plane{.frame = scene.ground()},
                {.friction = 1 / (5 * wear)});
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::y, turn);
  const FrameHandle pin = scene.weld("pin", crank, {.origin = {0, 0, r}});
  scene.body("crank", pin, Inertia::point(m / 2));
  scene.joint_friction("journal", crank, {.friction = grease, .radius = r / 10});
  scene.closure("slot", scene.point("A", pin, {0, 0, 0}), P, {1, 0, 0});
  return scene;
}

TORSOR_SCENE(worn_floor_scene)
