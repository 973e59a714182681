// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Watt's governor, turned at a constant rate: four massless arms of length L make a rhombus, hinged to the shaft at
/// its upper corner and to a sleeve on the shaft at its lower one; the balls are at the other two. theta is the angle
/// of the upper arms with the vertical. Without a sleeve's mass the balls hang as on two simple arms.
torsor::Scene watt_governor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("watt_governor", "Watt's governor at a given speed");

  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression m = scene.run_time_parameter("m", "kg", 1);  // of each ball
  const Expression M = scene.run_time_parameter("M", "kg", 2);  // of the sleeve
  const Expression L = scene.run_time_parameter("L", "m", 0.5_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 12);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression motor = scene.released_coordinate("motor", "rad");
  scene.drive(psi, omega * scene.time());
  scene.initial(theta, 1);

  const FrameHandle axle = scene.revolute("axle", scene.ground(), axis::z, motor);
  const FrameHandle shaft = scene.revolute("shaft", axle, axis::z, psi);
  const FrameHandle arm_1 = scene.revolute("arm_1", shaft, axis::y, theta);
  const FrameHandle arm_2 = scene.revolute("arm_2", shaft, axis::y, -theta);
  const FrameHandle sleeve = scene.prismatic("sleeve", shaft, axis::z, -2 * L * cos(theta));
  scene.body("ball_1", arm_1, Inertia::point(m).at({0, 0, -L}));
  scene.body("ball_2", arm_2, Inertia::point(m).at({0, 0, -L}));
  scene.body("sleeve", sleeve, Inertia::point(M));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(watt_governor_scene)
