// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mechanisms whose masses, lengths and angles between axes are parameters of the header, to be taken to extremes.

#include <array>
#include <string>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_mechanisms {

/// A chain of `joints` rods in space, m1, m2, … and l1, l2, …, the axis of each joint turned by the angle `tilt` from
/// the one before about the rod between them; motors in all joints.
inline Scene extreme_chain(int joints) {
  Scene scene("extreme_chain");
  const Expression tilt = scene.run_time_parameter("tilt", "rad", Expression(1));
  FrameHandle end = scene.ground();
  Triple origin{0, 0, 0};
  for (int i = 1; i <= joints; ++i) {
    const std::string number = std::to_string(i);
    const Expression m = scene.run_time_parameter("m" + number, "kg", Expression(1));
    const Expression l = scene.run_time_parameter("l" + number, "m", Expression(1));
    const Expression q = scene.coordinate("q" + number, "rad");
    const FrameHandle turned = i == 1 ? end : scene.revolute("tilted" + number, end, axis::x, tilt, {.origin = origin});
    end = scene.revolute("link" + number, turned, axis::z, q);
    scene.body("rod" + number, end, Inertia::box(m, l, l / 4, l / 8).at({l / 2, 0, 0}));
    scene.motor("u" + number, q);
    origin = {l, 0, 0};
  }
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

/// A body m2 with its centre off the axes on three that meet, z, x and z again: q2 is the angle between the first and
/// the last. The two rings between have the masses m1.
inline Scene extreme_gimbal() {
  Scene scene("extreme_gimbal");
  const Expression m1 = scene.run_time_parameter("m1", "kg", Expression(1));
  const Expression m2 = scene.run_time_parameter("m2", "kg", Expression(1));
  const Expression l = scene.run_time_parameter("l", "m", Expression(1));
  const std::array<Expression, 3> q{scene.coordinate("q1", "rad"), scene.coordinate("q2", "rad"),
                                    scene.coordinate("q3", "rad")};
  const FrameHandle outer = scene.revolute("outer", scene.ground(), axis::z, q[0]);
  const FrameHandle inner = scene.revolute("inner", outer, axis::x, q[1]);
  const FrameHandle body = scene.revolute("body", inner, axis::z, q[2]);
  scene.body("outer", outer, Inertia::ring(m1, l, 0));
  scene.body("inner", inner, Inertia::ring(m1, l, 1));
  scene.body("body", body, Inertia::box(m2, l, l / 2, l / 4).at({l / 8, 0, l / 2}));
  for (int i = 0; i < 3; ++i) scene.motor("u" + std::to_string(i + 1), q[static_cast<std::size_t>(i)]);
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

/// Crank l1, coupler l2 and rocker l3 on a ground of the length l4, of the masses m1, m2, m3.
inline Scene extreme_four_bar() {
  Scene scene("extreme_four_bar");
  const auto mass = [&scene](const char* name) { return scene.run_time_parameter(name, "kg", Expression(1)); };
  const auto length = [&scene](const char* name, int value) {
    return scene.run_time_parameter(name, "m", Expression(value));
  };
  const Expression m1 = mass("m1"), m2 = mass("m2"), m3 = mass("m3");
  const Expression l1 = length("l1", 1), l2 = length("l2", 3), l3 = length("l3", 2), l4 = length("l4", 3);
  const Expression q1 = scene.coordinate("q1", "rad"), q2 = scene.coordinate("q2", "rad");
  const Expression q3 = scene.coordinate("q3", "rad");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, q1);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, q2, {.origin = {l1, 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, q3, {.origin = {l4, 0, 0}});
  scene.body("crank", crank, Inertia::rod(m1, l1, 0).at({l1 / 2, 0, 0}));
  scene.body("coupler", coupler, Inertia::rod(m2, l2, 0).at({l2 / 2, 0, 0}));
  scene.body("rocker", rocker, Inertia::rod(m3, l3, 0).at({l3 / 2, 0, 0}));
  const PointHandle of_coupler = scene.point("of_coupler", coupler, {l2, 0, 0});
  const PointHandle of_rocker = scene.point("of_rocker", rocker, {l3, 0, 0});
  scene.closure("knee_x", of_coupler, of_rocker, axis::x);
  scene.closure("knee_y", of_coupler, of_rocker, axis::y);
  scene.motor("u", q1);
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  return scene;
}

}  // namespace torsor::testing_mechanisms
