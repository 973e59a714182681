// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Deployment of the two arms of a satellite (Pommier, 8.3.2 exercise 5), z0 up. The body S1 turns freely about
/// (O, z0) by psi; the arms S2 and S3 turn about y1 by theta_2 and theta_3 (from z1 to z2 and z3), hinged at a2 x1 and
/// -a3 x1, with a torsion spring, a viscous torque and a motor each. Centres at b1 z1, b2 z2, b3 z3; Ai, Bi, Ci are the
/// principal moments about xi, yi, zi at the centres. The springs are at rest when the arms point outwards.
torsor::Scene satellite_arms_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("satellite_arms", "Deployment of the arms of a satellite");

  const Expression a2 = scene.parameter("a2", "m", 0.3_r);
  const Expression a3 = scene.parameter("a3", "m", 0.35_r);
  const Expression b1 = scene.parameter("b1", "m", 0.1_r);
  const Expression b2 = scene.parameter("b2", "m", 0.5_r);
  const Expression b3 = scene.parameter("b3", "m", 0.45_r);
  const Expression m1 = scene.parameter("m1", "kg", 20);
  const Expression m2 = scene.parameter("m2", "kg", 2);
  const Expression m3 = scene.parameter("m3", "kg", 2.5_r);
  const Expression A1 = scene.parameter("A1", "kg m^2", 0.8_r);
  const Expression B1 = scene.parameter("B1", "kg m^2", 0.7_r);
  const Expression C1 = scene.parameter("C1", "kg m^2", 0.9_r);
  const Expression A2 = scene.parameter("A2", "kg m^2", 0.17_r);
  const Expression B2 = scene.parameter("B2", "kg m^2", 0.168_r);
  const Expression C2 = scene.parameter("C2", "kg m^2", 0.004_r);
  const Expression A3 = scene.parameter("A3", "kg m^2", 0.18_r);
  const Expression B3 = scene.parameter("B3", "kg m^2", 0.176_r);
  const Expression C3 = scene.parameter("C3", "kg m^2", 0.005_r);
  const Expression K2 = scene.parameter("K2", "N m", 30);
  const Expression K3 = scene.parameter("K3", "N m", 35);
  const Expression v2 = scene.parameter("v2", "N m s", 5);
  const Expression v3 = scene.parameter("v3", "N m s", 6);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta_2 = scene.coordinate("theta_2", "rad");
  const Expression theta_3 = scene.coordinate("theta_3", "rad");
  // Arms folded upwards on a spinning body.
  scene.initial(psi, 0, Expression::quantity("3", "rad/s"));
  scene.initial(theta_2, 0.05_r);
  scene.initial(theta_3, -0.05_r);

  const FrameHandle S1 = scene.revolute("S1", scene.ground(), axis::z, psi);
  const FrameHandle S2 = scene.revolute("S2", S1, axis::y, theta_2, {.origin = {a2, 0, 0}});
  const FrameHandle S3 = scene.revolute("S3", S1, axis::y, theta_3, {.origin = {-a3, 0, 0}});
  // Where moments are taken to find one motion at a time.
  scene.point("O", scene.ground(), {0, 0, 0});
  scene.point("O2", S2, {0, 0, 0});
  scene.point("O3", S3, {0, 0, 0});
  scene.body("S1", S1, Inertia::general({.mass = m1, .xx = A1, .yy = B1, .zz = C1}).at({0, 0, b1}));
  scene.body("S2", S2, Inertia::general({.mass = m2, .xx = A2, .yy = B2, .zz = C2}).at({0, 0, b2}));
  scene.body("S3", S3, Inertia::general({.mass = m3, .xx = A3, .yy = B3, .zz = C3}).at({0, 0, b3}));

  scene.gravity({0, 0, -g});
  scene.spring("hinge_spring_2", theta_2, K2, pi() / 2);
  scene.spring("hinge_spring_3", theta_3, K3, -pi() / 2);
  scene.damper("hinge_friction_2", theta_2, v2);
  scene.damper("hinge_friction_3", theta_3, v3);
  scene.motor("Cm2", theta_2);
  scene.motor("Cm3", theta_3);
  return scene;
}

TORSOR_SCENE(satellite_arms_scene)
