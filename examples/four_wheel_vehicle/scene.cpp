// SPDX-License-Identifier: MIT
#include "examples/four_wheel_vehicle/vehicle.hpp"

/// The vehicle in motion, its four wheels rolling. Where their axes meet, the eight conditions have rank six: two
/// repeat the others (those across wheels 3 and 4 are left out, which only holds for these angles: they are constants
/// here), and the forces across the wheels are not determined one by one. Motors turn the rear wheels; every wheel turns
/// against a viscous torque.
torsor::Scene four_wheel_vehicle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("four_wheel_vehicle", "Four-wheel vehicle whose wheels roll without slipping");
  const auto vehicle = four_wheel_vehicle_scenes::add_vehicle(scene, false);
  const Expression c = scene.parameter("c", "N m s", 3);
  const auto& [alpha, phi, steered, wheel, P] = vehicle;
  for (std::size_t i = 0; i < 4; ++i) {
    scene.rolling("wheel_" + std::to_string(i + 1),
                  {.body = wheel[i], .on = scene.ground(), .contact = P[i], .tangents = steered[i]});
  }
  scene.motor("C3", phi[2]);
  scene.motor("C4", phi[3]);
  for (std::size_t i = 0; i < 4; ++i) scene.damper("bearing_" + std::to_string(i + 1), phi[i], c);
  return scene;
}

TORSOR_SCENE(four_wheel_vehicle_scene)
