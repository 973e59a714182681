// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Radar on the nose of an aircraft in straight level flight along x (Pommier, 8.1 exercise 5). Unit (1) turns about
/// (P, z) by alpha; unit (2), the antenna, about (H, y1) by beta, PH = h x1. Its centre of mass G is at a x2 from H.
/// The released coordinates let the antenna slide along x and along x2: the forces against them are those that
/// its acceleration takes, m Gamma.x and m Gamma.x2.
torsor::Scene nose_radar_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("nose_radar", "Radar on the nose of an aircraft");

  const Expression h = scene.parameter("h", "m", 0.4_r);
  const Expression a = scene.parameter("a", "m", 0.25_r);
  const Expression m = scene.parameter("m", "kg", 12);                   // of the antenna
  const Expression across = scene.parameter("across", "kg m^2", 0.5_r);  // its moments about G
  const Expression along = scene.parameter("along", "kg m^2", 0.9_r);
  const Expression C1 = scene.parameter("C1", "kg m^2", 0.3_r);  // of unit (1) about (P, z)
  const Expression M = scene.parameter("M", "kg", 9000);         // of aircraft and unit (1)

  const Expression x = scene.coordinate("x", "m");
  const Expression alpha = scene.coordinate("alpha", "rad");
  const Expression beta = scene.coordinate("beta", "rad");
  const Expression F_x = scene.released_coordinate("F_x", "m");
  const Expression F_x2 = scene.released_coordinate("F_x2", "m");
  scene.initial(x, 0, Expression::quantity("200", "m/s"));
  scene.initial(alpha, 0.3_r, Expression::quantity("1.5", "rad/s"));
  scene.initial(beta, -0.4_r, Expression::quantity("2", "rad/s"));

  const FrameHandle aircraft = scene.prismatic("aircraft", scene.ground(), axis::x, x);
  const FrameHandle carriage = scene.prismatic("carriage", aircraft, axis::x, F_x);
  const FrameHandle unit_1 = scene.revolute("unit_1", carriage, axis::z, alpha);
  const FrameHandle hinge = scene.revolute("hinge", unit_1, axis::y, beta, {.origin = {h, 0, 0}});
  const FrameHandle antenna = scene.prismatic("antenna", hinge, axis::x, F_x2);
  scene.body("aircraft", aircraft, Inertia::point(M));
  scene.body("unit_1", unit_1, Inertia::general({.mass = 0, .zz = C1}));
  scene.body("antenna", antenna, Inertia::general({.mass = m, .xx = along, .yy = across, .zz = across}).at({a, 0, 0}));
  scene.motor("thrust", x);
  scene.motor("azimuth", alpha);
  scene.motor("elevation", beta);
  return scene;
}

TORSOR_SCENE(nose_radar_scene)
