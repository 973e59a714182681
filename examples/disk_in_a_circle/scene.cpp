// SPDX-License-Identifier: MIT
#include "examples/disk_in_a_circle/disk.hpp"

/// The disk rolls without slipping on a horizontal plane, which it touches at I = G - rho y2. The plane's whole reaction
/// is known: the normal force N, and X along x1, the way it rolls, and Y along y1, towards the centre of the circle.
torsor::Scene disk_in_a_circle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("disk_in_a_circle", "Disk rolling without slipping while its centre goes round a circle");

  const Expression rho = scene.run_time_parameter("rho", "m", 2);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const FrameHandle disk = disk_scenes::add_disk(scene, {rho, m, g});
  const PointHandle I = scene.point("I", "disk.2", {0, -rho, 0});

  const ConstraintHandle contact = scene.point_in_plane("contact", I, scene.ground());
  scene.reaction(contact, "N", {.body = disk, .contact = I, .direction = axis::z, .axes = "disk.1"});
  const std::vector<ConstraintHandle> rolling =
      scene.rolling("rolling", {.body = disk, .on = scene.ground(), .contact = I, .tangents = "disk.1"});
  scene.reaction(rolling[0], "X", {.body = disk, .contact = I, .direction = axis::x, .axes = "disk.1"});
  scene.reaction(rolling[1], "Y", {.body = disk, .contact = I, .direction = axis::y, .axes = "disk.1"});
  return scene;
}

TORSOR_SCENE(disk_in_a_circle_scene)
