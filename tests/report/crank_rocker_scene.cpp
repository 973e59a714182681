// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/torsor.hpp"

/// Rods of 1, 3 and 2.5 m between pivots 3 m apart, which hang: absolute angles, closed by the pin of the last two.
torsor::Scene crank_rocker_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("crank_rocker", "A crank and a rocker");
  const Expression m_1 = scene.parameter("m_1", "kg", 1), m_2 = scene.parameter("m_2", "kg", 2);
  const Expression m_3 = scene.parameter("m_3", "kg", 1.5_r);
  const Expression a = scene.parameter("a", "m", 1), b = scene.parameter("b", "m", 3), c = scene.parameter("c", "m", 2.5_r);
  const Expression d = scene.parameter("d", "m", 3), g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression turn = scene.coordinate("turn", "rad"), across = scene.coordinate("across", "rad");
  const Expression swing = scene.coordinate("swing", "rad");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::y, -turn);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::y, turn - across, {.origin = {a, 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::y, -swing, {.origin = {d, 0, 0}});
  scene.body("crank", crank, Inertia::rod(m_1, a, 0).at({a / 2, 0, 0}));
  scene.body("coupler", coupler, Inertia::rod(m_2, b, 0).at({b / 2, 0, 0}));
  scene.body("rocker", rocker, Inertia::rod(m_3, c, 0).at({c / 2, 0, 0}));
  scene.gravity({0, 0, -g});
  const FrameHandle end = scene.weld("end", coupler, {.origin = {b, 0, 0}});
  const FrameHandle pin = scene.weld("pin", rocker, {.origin = {c, 0, 0}});
  scene.loop_joint("pin", {.type = JointType::spherical, .a = end, .b = pin});
  scene.initial(turn, Expression::quantity("-1.6090349196807352", "rad"));
  scene.initial(across, Expression::quantity("-0.5102327484786364", "rad"));
  scene.initial(swing, Expression::quantity("-1.7397334273131217", "rad"));
  return scene;
}

TORSOR_SCENE(crank_rocker_scene)
