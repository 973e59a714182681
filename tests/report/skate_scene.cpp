// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// A skate held by a spring and a damper along x and by a spring that turns it. Its edge, a distance a from the centre of mass,
/// does not slip across itself: y follows the heading, and the skate can rest at any y.
torsor::Scene skate_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("skate", "A skate on springs");
  const Expression m = scene.parameter("m", "kg", 2), J = scene.parameter("J", "kg m^2", 0.5_r), a = scene.parameter("a", "m", 0.5_r);
  const Expression k = scene.parameter("k", "N/m", 50), c = scene.parameter("c", "N s/m", 1), K = scene.parameter("K", "N m", 9);
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), heading = scene.coordinate("heading", "rad");
  const FrameHandle along_x = scene.prismatic("along_x", scene.ground(), axis::x, x);
  const FrameHandle along_y = scene.prismatic("along_y", along_x, axis::y, y);
  const FrameHandle skate = scene.revolute("skate", along_y, axis::z, heading);
  const PointHandle edge = scene.point("edge", skate, {-a, 0, 0});
  scene.body("skate", skate, Inertia::general({.mass = m, .zz = J}));
  scene.no_slip("edge", {.body = skate, .contact = edge, .direction = axis::y, .axes = skate});
  scene.spring("spring", x, k);
  scene.damper("damper", x, c);
  scene.spring("turning_spring", heading, K);
  scene.show({.frame = skate, .form = form::Box{{a / 5, a / 10, a / 10}}});
  scene.initial(x, 0.1_r);
  return scene;
}

TORSOR_SCENE(skate_scene)
