// SPDX-License-Identifier: MIT
#include "examples/four_wheel_vehicle/vehicle.hpp"

/// All eight conditions of rolling without slipping, for any steering. The wheels may slide along their axes; the rank
/// of the conditions in the other seven rates says whether the vehicle can move while they do not.
torsor::Scene four_wheel_vehicle_all_wheels_scene() {
  using namespace torsor;
  Scene scene("four_wheel_vehicle_all_wheels", "Four-wheel vehicle: the eight conditions of its four wheels");
  const auto vehicle = four_wheel_vehicle_scenes::add_vehicle(scene, true);
  const auto& [alpha, phi, steered, wheel, P] = vehicle;
  for (std::size_t i = 0; i < 4; ++i) {
    scene.rolling("wheel_" + std::to_string(i + 1),
                  {.body = wheel[i], .on = scene.ground(), .contact = P[i], .tangents = steered[i]});
  }
  return scene;
}

TORSOR_SCENE(four_wheel_vehicle_all_wheels_scene)
