// SPDX-License-Identifier: MIT
#include "examples/helicopter_on_a_circle/helicopter.hpp"

/// Questions 1 to 3: the blades' pitch is constant, the rotor one rigid body.
torsor::Scene helicopter_on_a_circle_scene() {
  torsor::Scene scene("helicopter_on_a_circle", "Rotor of a helicopter that goes round a circle");
  const auto helicopter = helicopter_scenes::add_helicopter(scene);
  for (int i = 1; i <= 4; ++i) helicopter_scenes::add_blade(scene, helicopter, i, helicopter.alpha);
  return scene;
}

TORSOR_SCENE(helicopter_on_a_circle_scene)
