// SPDX-License-Identifier: MIT
#include "generator/torsor.hpp"

/// A billiard ball on its cloth, z = 0 (Pommier, 8.3.2 exercise 3): a uniform sphere that flies, slides and rolls. Nothing
/// is assumed of the contact. It starts as the exercise's ball: struck in its middle, it slides.
torsor::Scene billiard_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("billiard", "Billiard ball that slides, then rolls");

  const Expression R = scene.parameter("R", "m", 0.028575_r);
  const Expression m = scene.parameter("m", "kg", 0.17_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.2_r);
  const Expression e = scene.run_time_parameter("e", "1", 0);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const AttitudeHandle turn = scene.attitude("turn");
  scene.initial(x, 0, 2);
  scene.initial(z, R);

  const FrameHandle ball = scene.free("ball", scene.ground(), {x, y, z}, turn);
  scene.body("ball", ball, Inertia::solid_sphere(m, R));
  scene.gravity({0, 0, -g});
  scene.contact("cloth", shape::Sphere{.frame = ball, .radius = R}, shape::Plane{.frame = scene.ground()},
                {.friction = f, .restitution = e});
  return scene;
}

TORSOR_SCENE(billiard_scene)
