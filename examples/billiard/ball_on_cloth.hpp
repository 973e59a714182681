// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "torsor/generator/torsor.hpp"

/// A uniform ball that flies, slides and rolls over its cloth, z = 0 (Pommier, 8.3.2 exercise 3), of which `law` says what
/// it is made of. Nothing is assumed of the contact. It starts as the exercise's ball: struck in its middle, it slides.
inline torsor::Scene ball_on_cloth(const char* name, const char* title,
                                   const std::function<torsor::SurfaceLaw(torsor::Scene&)>& law) {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene(name, title);

  const Expression R = scene.parameter("R", "m", 0.028575_r);
  const Expression m = scene.parameter("m", "kg", 0.17_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const SurfaceLaw cloth = law(scene);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const AttitudeHandle turn = scene.attitude("turn");
  scene.initial(x, 0, 2);
  scene.initial(z, R);

  const FrameHandle ball = scene.free("ball", scene.ground(), {x, y, z}, turn);
  scene.body("ball", ball, Inertia::solid_sphere(m, R));
  scene.gravity({0, 0, -g});
  scene.contact("cloth", shape::Sphere{.frame = ball, .radius = R}, shape::Plane{.frame = scene.ground()}, cloth);
  return scene;
}
