// SPDX-License-Identifier: MIT
#include "ball_on_cloth.hpp"

/// The same ball on a cloth that gives way: moments up to h N resist its rolling, up to k N its spinning.
torsor::Scene billiard_soft_cloth_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  return ball_on_cloth("billiard_soft_cloth", "Billiard ball that slides, rolls, and comes to rest", [](Scene& scene) {
    const Expression f = scene.run_time_parameter("f", "1", 0.2_r);
    const Expression e = scene.run_time_parameter("e", "1", 0);
    const Expression h = scene.run_time_parameter("h", "m", 0.0005_r);
    const Expression k = scene.run_time_parameter("k", "m", 0.0002_r);
    return SurfaceLaw{.friction = f, .restitution = e, .rolling = h, .spinning = k};
  });
}

TORSOR_SCENE(billiard_soft_cloth_scene)
