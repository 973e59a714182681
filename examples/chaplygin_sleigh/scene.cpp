// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Chaplygin's sleigh: a body slides on a horizontal plane without friction, on a knife edge at C that lets it run
/// along the blade x1 but not across it. The centre of mass lies a x1 ahead of C.
torsor::Scene chaplygin_sleigh_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("chaplygin_sleigh", "Chaplygin's sleigh: a knife edge on a smooth plane");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression J = scene.parameter("J", "kg m^2", 0.5_r);  // about the vertical through the centre of mass
  const Expression a = scene.parameter("a", "m", 0.5_r);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.initial(phi, 0, Expression::quantity("2", "rad/s"));

  const FrameHandle along_x = scene.prismatic("along_x", scene.ground(), axis::x, x);
  const FrameHandle along_y = scene.prismatic("along_y", along_x, axis::y, y);
  const FrameHandle sleigh = scene.revolute("sleigh", along_y, axis::z, phi);
  const PointHandle C = scene.point("C", sleigh, {0, 0, 0});
  // In a plane motion nothing but the moment about z matters.
  scene.body("sleigh", sleigh, Inertia::general({.mass = m, .zz = J}).at({a, 0, 0}));
  const ConstraintHandle edge =
      scene.no_slip("knife_edge", {.body = sleigh, .contact = C, .direction = axis::y, .axes = sleigh});
  scene.reaction(edge, "N", {.body = sleigh, .contact = C, .direction = axis::y, .axes = sleigh});
  // For pictures: the sleigh, and the blade below its end.
  scene.show({.frame = sleigh, .form = form::Box{{2 * a, a, a / 6}}, .placement = {{3 * a / 4, 0, a / 4}}});
  scene.show({.frame = sleigh, .form = form::Box{{a / 2, a / 40, a / 5}}, .placement = {{0, 0, a / 10}}});
  return scene;
}

TORSOR_SCENE(chaplygin_sleigh_scene)
