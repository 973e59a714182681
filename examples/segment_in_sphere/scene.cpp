// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Segment AB of length l whose ends stay on a sphere of radius R > l/2 about O (Pommier, 8.1 exercise 1). Its middle I
/// stays at the distance d = sqrt(R^2 - l^2/4) from O and AB is normal to OI, so three angles place it: psi and theta
/// for the direction z3 of OI, phi for that of AB = l x3 about it (Euler's angles). Here AB is a heavy rod that slides
/// inside the sphere without friction, z0 upwards.
torsor::Scene segment_in_sphere_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("segment_in_sphere", "A rod slides inside a sphere");

  const Expression R = scene.parameter("R", "m", 1);
  const Expression l = scene.parameter("l", "m", 1.2_r);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression d = sqrt(R * R - l * l / 4);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.initial(psi, 0, Expression::quantity("1", "rad/s"));
  scene.initial(theta, 2);
  scene.initial(phi, 0.5_r, Expression::quantity("3", "rad/s"));

  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, psi);
  const FrameHandle second = scene.revolute("second", first, axis::x, theta);
  const FrameHandle rod = scene.revolute("rod", second, axis::z, phi);
  scene.body("rod", rod, Inertia::rod(m, l, 0).at({0, 0, d}));
  scene.point("A", rod, {-l / 2, 0, d});
  scene.point("B", rod, {l / 2, 0, d});
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(segment_in_sphere_scene)
