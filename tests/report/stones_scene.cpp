// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// Every round body, and a box, dropped on the ground: what touches must be drawn as it is.
torsor::Scene stones_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("stones", "A box, a pebble, an egg and a tyre");
  const Expression m = scene.parameter("m", "kg", 1), r = scene.parameter("r", "m", 0.1_r), g = scene.parameter("g", "m/s^2", 9.81_r);
  const shape::Plane floor{.frame = scene.ground()};
  int count = 0;
  const auto loose = [&](const std::string& name) {
    const auto place = [&](const char* axis) { return scene.coordinate(name + axis, "m"); };
    const Expression x = place("_x"), y = place("_y"), z = place("_z");
    const AttitudeHandle e = scene.attitude(name + "_e");
    const FrameHandle frame = scene.free(name, scene.ground(), {x, y, z}, e);
    scene.body(name, frame, Inertia::solid_sphere(m, r));
    scene.initial(x, 6 * r * count++);
    scene.initial(z, 5 * r);
    scene.initial(e, {Expression(1), Expression(1) / 4, Expression(1) / 9, Expression(0)}, {Expression(1), Expression(2), Expression(1)});
    return frame;
  };
  scene.contact("edges", shape::Box{.frame = loose("box"), .half_edges = {2 * r, 3 * r / 2, r}}, floor);
  scene.contact("pebble", shape::Ellipsoid{.frame = loose("stone"), .semi_axes = {2 * r, 3 * r / 2, r}}, floor);
  const auto support = [r](const Triple& u) {  // of a ball around another place
    const Expression size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    return 3 * r / 2 * size + r * u[2] / 2;
  };
  scene.contact("shell", shape::Convex{.frame = loose("egg"), .support = support}, floor);
  scene.contact("tread", shape::Torus{.frame = loose("tyre"), .axis = axis::y, .circle_radius = 2 * r, .tube_radius = r / 2}, floor);
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(stones_scene)
