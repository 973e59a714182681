// SPDX-License-Identifier: MIT
#include "examples/four_wheel_vehicle/vehicle.hpp"

/// The vehicle in motion. Where the axes meet, the wheels' eight conditions have rank six; these are imposed: all of
/// wheels 1 and 3, and rolling forwards of the other two. Motors turn the rear wheels; every wheel turns against a
/// viscous torque.
torsor::Scene four_wheel_vehicle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("four_wheel_vehicle", "Four-wheel vehicle whose wheels roll without slipping");
  const auto vehicle = four_wheel_vehicle_scenes::add_vehicle(scene, false);
  const Expression c = scene.parameter("c", "N m s", 3);
  const auto& [alpha, phi, steered, wheel, P] = vehicle;
  scene.rolling("wheel_1", wheel[0], scene.ground(), P[0], steered[0]);
  scene.rolling("wheel_3", wheel[2], scene.ground(), P[2], steered[2]);
  scene.no_slip("wheel_2_y", wheel[1], P[1], axis::y, steered[1]);
  scene.no_slip("wheel_4_y", wheel[3], P[3], axis::y, steered[3]);
  scene.motor("C3", phi[2]);
  scene.motor("C4", phi[3]);
  for (std::size_t i = 0; i < 4; ++i) scene.damper("bearing_" + std::to_string(i + 1), phi[i], c);
  return scene;
}

TORSOR_SCENE(four_wheel_vehicle_scene)
