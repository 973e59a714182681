// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// A bead slides without friction on a hoop that a motor turns about its vertical diameter at a constant rate. theta is
/// measured from the lowest point. The motor's torque is asked for by releasing the motion it imposes.
torsor::Scene bead_on_hoop_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("bead_on_hoop", "Bead on a hoop that turns about its vertical diameter");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression R = scene.parameter("R", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 5);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression motor = scene.released_coordinate("motor", "rad");
  scene.drive(psi, omega * scene.time());
  scene.initial(theta, 0.1_r);

  const FrameHandle axle = scene.revolute("axle", scene.ground(), axis::z, motor);
  const FrameHandle hoop = scene.revolute("hoop", axle, axis::z, psi);
  const FrameHandle bead = scene.revolute("bead", hoop, axis::y, theta);
  scene.body("bead", bead, Inertia::point(m).at({0, 0, -R}));
  scene.gravity({0, 0, -g});
  scene.show({.frame = hoop, .form = form::Torus{R, R / 60}, .placement = {{0, 0, 0}, Rotation::about(0, 6)}});
  scene.show({.frame = hoop, .form = form::Segment{{0, 0, -6 * R / 5}, {0, 0, 6 * R / 5}, R / 90}});
  return scene;
}

TORSOR_SCENE(bead_on_hoop_scene)
