// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Plumb line on the turning earth (Pommier, §6.3.4). The earth, a sphere, turns at omega about z_g; at the latitude,
/// at the distance r from its centre O, n points upwards and t to the north (the pole), east completes them. A bob of
/// mass m hangs on a thread of length l from r n + l n: delta turns it towards the north in the meridian plane, epsilon
/// sideways. The thread's tension is asked for by releasing its length. The earth attracts with m K M_e / OG^2.
torsor::Scene plumb_line_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("plumb_line", "Plumb line on the turning earth");

  const Expression K = scene.parameter("K", "N m^2/kg^2", Expression::quantity("6.67e-11", "N m^2/kg^2"));
  const Expression earth = scene.parameter("M_e", "kg", Expression::quantity("5.9742e24", "kg"));
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression l = scene.parameter("l", "m", 1);
  const Expression omega = scene.parameter("omega", "rad/s", 2 * pi() / Expression::quantity("86400", "s"));
  const Expression r = scene.run_time_parameter("r", "m", 6371000);
  const Expression latitude = scene.run_time_parameter("latitude", "rad", pi() / 4);

  const Expression theta = scene.coordinate("theta", "rad");
  const Expression delta = scene.coordinate("delta", "rad");
  const Expression epsilon = scene.coordinate("epsilon", "rad");
  const Expression tension = scene.released_coordinate("tension", "m");
  scene.drive(theta, omega * scene.time());
  scene.initial(delta, 0.1_r);

  // Axes of the place: x is n, y points east, z is t.
  const FrameHandle globe = scene.revolute("globe", scene.ground(), axis::z, theta);
  const FrameHandle place = scene.revolute("place", globe, {0, -1, 0}, latitude);
  const FrameHandle meridian = scene.revolute("meridian", place, axis::y, delta, {.origin = {r + l, 0, 0}});
  const FrameHandle thread = scene.revolute("thread", meridian, axis::z, epsilon);
  const FrameHandle bob = scene.prismatic("bob", thread, axis::x, tension);
  scene.body("bob", bob, Inertia::point(m).at({-l, 0, 0}));
  const PointHandle O = scene.point("O", scene.ground(), {0, 0, 0});
  const PointHandle G = scene.point("G", bob, {-l, 0, 0});
  scene.gravitation("attraction", O, G, K * earth * m);
  return scene;
}

TORSOR_SCENE(plumb_line_scene)
