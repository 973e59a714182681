// SPDX-License-Identifier: GPL-3.0-or-later
// A lamp hangs by a ball joint from a trolley that a motor pushes along a rail. The rail shakes, and the lamp's foot slides on
// an inclined plane. What the rail carries is asked for. All that outputs may depend on is here: a quaternion, a law of
// time, a constraint, an input, a released coordinate.
#include "torsor/generator/torsor.hpp"

torsor::Scene lamp_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("lamp", "A lamp on a trolley, its foot on an inclined plane");
  const Expression M = scene.run_time_parameter("M", "kg", 3), m = scene.run_time_parameter("m", "kg", 2);
  const Expression l = scene.run_time_parameter("l", "m", 0.4_r), a = scene.run_time_parameter("a", "m", 0.05_r);
  const Expression I = scene.parameter("I", "kg m^2", 0.1_r), J = scene.parameter("J", "kg m^2", 0.03_r);
  const Expression omega = scene.parameter("omega", "rad/s", 3), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression x = scene.coordinate("x", "m"), lift = scene.released_coordinate("lift", "m");
  const AttitudeHandle e = scene.attitude("e");
  scene.initial(e, {1, 0, 0, 0}, {0, 0, Expression::quantity("2", "rad/s")});

  const FrameHandle shaken = scene.prismatic("shaken", scene.ground(), axis::y, a * sin(omega * scene.time()));
  const FrameHandle rail = scene.prismatic("rail", shaken, axis::z, lift);
  const FrameHandle trolley = scene.prismatic("trolley", rail, axis::x, x);
  const FrameHandle lamp = scene.spherical("lamp", trolley, e);
  const FrameHandle plane =
      scene.weld("plane", scene.ground(), {.origin = {0, 0, -l}, .rotation = Rotation::about(1, 1)});
  scene.point("foot", lamp, {0, 0, -l});
  scene.point("bulb", lamp, {l / 3, 0, -l / 2});
  scene.body("trolley", trolley, Inertia::point(M));
  scene.body("lamp", lamp, Inertia::general({.mass = m, .xx = I, .yy = I, .zz = J}).at({0, l / 8, -l / 2}));
  scene.gravity({0, 0, -g});
  scene.motor("push", x);
  scene.point_in_plane("slope", scene.point("foot"), plane);
  return scene;
}

TORSOR_SCENE(lamp_scene)
