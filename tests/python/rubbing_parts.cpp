// SPDX-License-Identifier: GPL-3.0-or-later
// Four mechanisms side by side, each of which has states where accelerations change beyond bounds or in no one way: a block on a
// spring whose friction has no slope at p = 0; a plate on two feet, which share its weight; an eccentric rotor, whose journal
// carries nothing where it is balanced; and an arm with its tip on a belt, which jams where its tangent is the friction.
#include "torsor/generator/torsor.hpp"

torsor::Scene rubbing_parts_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("rubbing_parts", "Parts that rub");
  const Expression m = scene.parameter("m", "kg", 2), g = scene.parameter("g", "m/s^2", 10);
  scene.gravity({0, 0, -g});
  const auto metres = [](const char* length) { return Expression::quantity(length, "m"); };

  const Expression p = scene.run_time_parameter("p", "1", 0);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  scene.initial(x, 0, 1);
  const FrameHandle block = scene.prismatic("block", scene.prismatic("rail", scene.ground(), axis::x, x), axis::z, z);
  scene.body("block", block, Inertia::point(m));
  scene.contact("floor", shape::Point{scene.point("P", block, {0, 0, 0})}, shape::Plane{.frame = scene.ground()},
                {.friction = sqrt(p) / 2});
  scene.spring("spring", x, Expression::quantity("3", "N/m"));

  const Expression height = scene.coordinate("height", "m");
  scene.initial(height, 1, 0);
  const FrameHandle plate = scene.prismatic("plate", scene.ground(), axis::z, height);
  scene.body("plate", plate, Inertia::point(m));
  for (const char* foot : {"left", "right"}) {
    const PointHandle tip = scene.point(foot, plate, {foot[0] == 'l' ? -metres("1") : metres("1"), 0, 0});
    scene.contact(foot, shape::Point{tip}, shape::Plane{.frame = scene.ground()}, {});
  }

  const Expression e = scene.run_time_parameter("e", "m", 0.1_r), turn = scene.coordinate("turn", "rad");
  scene.initial(turn, 0, 2);
  const FrameHandle rotor = scene.revolute("rotor", scene.ground(), axis::z, turn);
  scene.body("rotor", scene.weld("centre", rotor, {.origin = {e, 0, 0}}), Inertia::disk(m, metres("0.5"), 2));
  scene.joint_friction("journal", rotor, {.friction = Expression::quantity("0.1", "1"), .radius = metres("0.05")});

  const Expression f = scene.run_time_parameter("f", "1", 0), swing = scene.coordinate("swing", "rad");
  const FrameHandle pivot = scene.weld("pivot", scene.ground(), {.origin = {0, 0, metres("0.5")}});
  const FrameHandle arm = scene.revolute("arm", pivot, axis::y, swing);
  const FrameHandle end = scene.weld("end", arm, {.origin = {metres("0.375"), 0, -metres("0.5")}});
  scene.body("arm", end, Inertia::point(m));
  const shape::Plane belt{.frame = scene.ground(), .belt = {Expression::quantity("-1", "m/s"), Expression(0)}};
  scene.contact("belt", shape::Point{scene.point("tip", end, {0, 0, 0})}, belt, {.friction = f});
  return scene;
}

TORSOR_SCENE(rubbing_parts_scene)
