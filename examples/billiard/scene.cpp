// SPDX-License-Identifier: MIT
#include "ball_on_cloth.hpp"

/// A ball on a hard cloth, which resists neither rolling nor spinning.
torsor::Scene billiard_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  return ball_on_cloth("billiard", "Billiard ball that slides, then rolls", [](Scene& scene) {
    const Expression f = scene.run_time_parameter("f", "1", 0.2_r);
    const Expression e = scene.run_time_parameter("e", "1", 0);
    return SurfaceLaw{.friction = f, .restitution = e};
  });
}

TORSOR_SCENE(billiard_scene)
