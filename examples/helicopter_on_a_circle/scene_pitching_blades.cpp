// SPDX-License-Identifier: MIT
#include "examples/helicopter_on_a_circle/helicopter.hpp"

/// Question 4: the rotor as a system of bodies. Each blade turns about its span by a pitch of its own, alpha_1 to
/// alpha_4, which a link (spring and damper) holds near what the pilot commands, alpha + alpha_c cos(phi + (i - 1)
/// pi/2): once a turn the blades swing.
torsor::Scene helicopter_on_a_circle_pitching_blades_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("helicopter_on_a_circle_pitching_blades", "The helicopter's rotor with blades of variable pitch");
  const auto helicopter = helicopter_scenes::add_helicopter(scene);
  const Expression alpha_c = scene.run_time_parameter("alpha_c", "rad", 0.1_r);
  const Expression k = scene.run_time_parameter("k", "N m", 4000);
  const Expression c = scene.run_time_parameter("c", "N m s", 8);
  const Expression rate = Expression::quantity("30", "rad/s");
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    const Expression pitch = scene.coordinate("alpha_" + number, "rad");
    const Expression place = (i - 1) * pi() / 2;
    scene.initial(pitch, helicopter.alpha + alpha_c * cos(place), -alpha_c * sin(place) * rate);
    helicopter_scenes::add_blade(scene, helicopter, i, pitch);
    const Expression swing = pitch - alpha_c * cos(helicopter.phi + place);
    scene.spring("link_" + number, swing, k, helicopter.alpha);
    scene.damper("link_damping_" + number, swing, c);
  }
  return scene;
}

TORSOR_SCENE(helicopter_on_a_circle_pitching_blades_scene)
