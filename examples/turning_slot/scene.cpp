// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// A bead slides without friction in a straight slot that turns at a constant rate about a horizontal axis through it,
/// in the vertical plane x, y. The slot is no body: the bead has both coordinates, and a condition that depends on time
/// holds it in the line at the angle omega t from x. The slot's force N on the bead is across that line.
torsor::Scene turning_slot_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("turning_slot", "Bead in a slot that turns in a vertical plane");

  const Expression m = scene.parameter("m", "kg", 2);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 2);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  scene.initial(x, 0.5_r);
  scene.initial(y, 0, Expression::quantity("0.5", "m") * omega);  // at rest in the slot

  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  const FrameHandle bead = scene.prismatic("bead", across, axis::y, y);
  scene.body("bead", bead, Inertia::point(m));
  scene.gravity({0, -g, 0});

  const Expression turn = omega * scene.time();
  const PointHandle center = scene.point("center", bead, {0, 0, 0});
  const ConstraintHandle slot = scene.holonomic("slot", y * cos(turn) - x * sin(turn));
  scene.reaction(slot, "N",
                 {.body = bead, .contact = center, .direction = {-sin(turn), cos(turn), 0}, .axes = scene.ground()});
  const Expression end = Expression::quantity("1", "m");
  scene.show({.frame = scene.ground(),
              .form = form::Segment{{-end * cos(turn), -end * sin(turn), 0}, {end * cos(turn), end * sin(turn), 0}, end / 100}});
  return scene;
}

TORSOR_SCENE(turning_slot_scene)
