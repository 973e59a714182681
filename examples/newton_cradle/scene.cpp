// SPDX-License-Identifier: MIT
#include <string>

#include "torsor/generator/torsor.hpp"

/// Five equal balls hang side by side and touch without a force; the first is drawn aside and let go. Its threads stay
/// tight and count as rods. What the others do depends on the law of impact, of which the scene says nothing but e.
torsor::Scene newton_cradle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("newton_cradle", "Newton's cradle of five balls");
  constexpr int balls = 5;

  const Expression l = scene.parameter("l", "m", 1);
  const Expression R = scene.parameter("R", "m", 0.05_r);
  const Expression m = scene.parameter("m", "kg", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression e = scene.run_time_parameter("e", "1", 1);
  scene.gravity({0, 0, -g});

  FrameHandle before = scene.ground();
  for (int i = 0; i < balls; ++i) {
    const std::string number = std::to_string(i + 1);
    const Expression a = scene.coordinate("a" + number, "rad");
    if (i == 0) scene.initial(a, 0.3_r);
    const FrameHandle hook = scene.weld("hook" + number, scene.ground(), {.origin = {2 * i * R, 0, 0}});
    // A positive angle draws the ball back, to -x.
    const FrameHandle thread = scene.revolute("thread" + number, hook, axis::y, a);
    const FrameHandle ball = scene.weld("ball" + number, thread, {.origin = {0, 0, -l}});
    scene.body("ball" + number, ball, Inertia::point(m));
    if (i > 0) {
      scene.contact("touch" + std::to_string(i), shape::Sphere{.frame = ball, .radius = R},
                    shape::Sphere{.frame = before, .radius = R}, {.restitution = e});
    }
    before = ball;
  }
  return scene;
}

TORSOR_SCENE(newton_cradle_scene)
