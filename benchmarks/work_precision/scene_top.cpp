// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// Heavy symmetric top about a fixed point in Euler's angles phi about z, theta about x, psi about z:
/// about the point I1 = 5/16, I3 = 1/8, and m g l = 4.905.
torsor::Scene top_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("work_precision_top", "Heavy symmetric top in Euler's angles");
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression l = scene.parameter("l", "m", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression A = scene.parameter("A", "kg m^2", 0.0625_r);  // about the centre of mass: 5/16 - m l^2
  const Expression C = scene.parameter("C", "kg m^2", 0.125_r);
  const Expression phi = scene.coordinate("phi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression psi = scene.coordinate("psi", "rad");
  scene.initial(theta, 0.5_r);
  scene.initial(psi, 0, Expression::quantity("24", "rad/s"));
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, phi);
  const FrameHandle second = scene.revolute("second", first, axis::x, theta);
  const FrameHandle top = scene.revolute("top", second, axis::z, psi);
  scene.body("top", top, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}).at({0, 0, l}));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(top_scene)
