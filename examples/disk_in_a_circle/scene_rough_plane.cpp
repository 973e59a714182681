// SPDX-License-Identifier: MIT
#include "examples/disk_in_a_circle/disk.hpp"

/// The disk on a plane of friction f, and nothing assumed of the contact: it rolls round its circle while f suffices,
/// slips where it does not, and leaves the plane where that does not press.
torsor::Scene disk_in_a_circle_rough_plane_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("disk_in_a_circle_rough_plane", "Disk in a circle on a plane whose friction may not suffice");

  const Expression rho = scene.parameter("rho", "m", 2);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression f = scene.run_time_parameter("f", "1", 1.2_r);
  const FrameHandle disk = disk_scenes::add_disk(scene, {rho, m, g});
  scene.contact("plane", shape::Disc{.frame = disk, .axis = axis::z, .radius = rho}, shape::Plane{.frame = scene.ground()},
                {.friction = f});
  return scene;
}

TORSOR_SCENE(disk_in_a_circle_rough_plane_scene)
