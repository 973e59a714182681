// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Passenger in a vehicle (Pommier, 8.1 exercise 2). The vehicle S0 runs along x at the constant speed V. The trunk S1
/// turns by theta_1 about (I, z) of the vehicle, the head S2 by theta_2 about (K, z) of the trunk; z is across the
/// vehicle and y points up, so that the passenger nods. I = a x + b y in the vehicle, IK = l y1. Springs and dampers
/// stand for the back and the neck.
torsor::Scene passenger_in_vehicle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("passenger_in_vehicle", "Passenger in a vehicle: trunk and head");

  const Expression V = scene.run_time_parameter("V", "m/s", 15);
  const Expression a = scene.parameter("a", "m", 0.8_r);
  const Expression b = scene.parameter("b", "m", 0.5_r);
  const Expression l = scene.parameter("l", "m", 0.6_r);
  const Expression m1 = scene.parameter("m1", "kg", 40);
  const Expression m2 = scene.parameter("m2", "kg", 5);
  // Places of the centres of mass: I G1 = c1 y1, K G2 = c2 y2; moments about z through them.
  const Expression c1 = scene.parameter("c1", "m", 0.35_r);
  const Expression c2 = scene.parameter("c2", "m", 0.15_r);
  const Expression J1 = scene.parameter("J1", "kg m^2", 1.5_r);
  const Expression J2 = scene.parameter("J2", "kg m^2", 0.03_r);
  const Expression k1 = scene.parameter("k1", "N m", 600);
  const Expression k2 = scene.parameter("k2", "N m", 40);
  const Expression d1 = scene.parameter("d1", "N m s", 25);
  const Expression d2 = scene.parameter("d2", "N m s", 0.6_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression theta_1 = scene.coordinate("theta_1", "rad");
  const Expression theta_2 = scene.coordinate("theta_2", "rad");
  scene.drive(x, V * scene.time());
  // Just after the brakes are let go.
  scene.initial(theta_1, -0.3_r);
  scene.initial(theta_2, -0.4_r);

  const FrameHandle S0 = scene.prismatic("S0", scene.ground(), axis::x, x);
  const FrameHandle S1 = scene.revolute("S1", S0, axis::z, theta_1, {.origin = {a, b, 0}});
  const FrameHandle S2 = scene.revolute("S2", S1, axis::z, theta_2, {.origin = {0, l, 0}});
  // In a plane motion nothing but the moment about z matters.
  scene.body("trunk", S1, Inertia::general({.mass = m1, .zz = J1}).at({0, c1, 0}));
  scene.body("head", S2, Inertia::general({.mass = m2, .zz = J2}).at({0, c2, 0}));
  scene.point("I", S1, {0, 0, 0});
  scene.point("K", S2, {0, 0, 0});

  scene.gravity({0, -g, 0});
  scene.spring("back", theta_1, k1);
  scene.damper("back_damping", theta_1, d1);
  scene.spring("neck", theta_2, k2);
  scene.damper("neck_damping", theta_2, d2);
  return scene;
}

TORSOR_SCENE(passenger_in_vehicle_scene)
