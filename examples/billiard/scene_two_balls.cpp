// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Two equal billiard balls: the first, which slides or rolls along x at 2 m/s, strikes the second, at rest 30 degrees off
/// its way.
torsor::Scene billiard_two_balls_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("billiard_two_balls", "Billiard ball that strikes another one");

  const Expression R = scene.parameter("R", "m", 0.028575_r);
  const Expression m = scene.parameter("m", "kg", 0.17_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.2_r);
  const Expression e = scene.run_time_parameter("e", "1", 0.93_r);
  const Expression between = scene.run_time_parameter("f_between", "1", 0.06_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const AttitudeHandle turn = scene.attitude("turn");
  const Expression x2 = scene.coordinate("x2", "m");
  const Expression y2 = scene.coordinate("y2", "m");
  const Expression z2 = scene.coordinate("z2", "m");
  const AttitudeHandle turn2 = scene.attitude("turn2");
  scene.initial(x, -2 * R * cos(pi() / 6), 2);
  scene.initial(y, -2 * R * sin(pi() / 6));
  scene.initial(z, R);
  scene.initial(z2, R);

  const FrameHandle ball = scene.free("ball", scene.ground(), {x, y, z}, turn);
  const FrameHandle ball2 = scene.free("ball2", scene.ground(), {x2, y2, z2}, turn2);
  scene.body("ball", ball, Inertia::solid_sphere(m, R));
  scene.body("ball2", ball2, Inertia::solid_sphere(m, R));
  scene.gravity({0, 0, -g});
  scene.contact("cloth", shape::Sphere{.frame = ball, .radius = R}, shape::Plane{.frame = scene.ground()},
                {.friction = f});
  scene.contact("cloth2", shape::Sphere{.frame = ball2, .radius = R}, shape::Plane{.frame = scene.ground()},
                {.friction = f});
  scene.contact("balls", shape::Sphere{.frame = ball, .radius = R}, shape::Sphere{.frame = ball2, .radius = R},
                {.friction = between, .restitution = e});
  return scene;
}

TORSOR_SCENE(billiard_two_balls_scene)
