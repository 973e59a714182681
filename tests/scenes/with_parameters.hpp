// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/scenes/pendulums.hpp"

// Mechanisms whose every quantity is a parameter, as equations are printed.
namespace torsor::test {

using testing_mechanisms::Angle;
using testing_mechanisms::double_pendulum;

/// Machine on a spring with a pendulum and a rotor of imposed speed; z points down.
inline Scene absorber() {
  Scene s("vibration_absorber");
  const Expression M1 = s.parameter("M1", "kg", 10);
  const Expression M2 = s.parameter("M2", "kg", 1);
  const Expression M3 = s.parameter("M3", "kg", 0.5);
  const Expression d = s.parameter("d", "m", 0.25);
  const Expression R = s.parameter("R", "m", 0.05);
  const Expression omega = s.parameter("omega", "rad/s", 6);
  const Expression K = s.parameter("K", "N/m", 1000);
  const Expression X0 = s.parameter("X0", "m", 0.1);
  const Expression g = s.parameter("g", "m/s^2", 9.81);
  const Expression X = s.coordinate("X", "m");
  const Expression theta = s.coordinate("theta", "rad");
  const Expression phi = s.coordinate("phi", "rad");
  s.drive(phi, omega * s.time());
  s.initial(X, 0.11);
  const FrameHandle support = s.prismatic("support", s.ground(), axis::x, X);
  const FrameHandle pendulum = s.revolute("pendulum", support, axis::y, theta);
  const FrameHandle rotor = s.revolute("rotor", support, axis::y, phi);
  s.body("machine", support, Inertia::point(M1));
  s.body("absorber", pendulum, Inertia::point(M2).at({0, 0, d}));
  s.body("unbalance", rotor, Inertia::point(M3).at({0, 0, R}));
  s.gravity({0, 0, g});
  s.spring("spring", X, K, X0);
  return s;
}

/// A body that turns freely about the vertical and one hinged arm with spring, friction and motor.
inline Scene satellite() {
  Scene s("satellite");
  const Expression a = s.parameter("a", "m", 0.3);
  const Expression b = s.parameter("b", "m", 0.5);
  const Expression m = s.parameter("m", "kg", 2);
  const Expression A = s.parameter("A", "kg m^2", 0.17);
  const Expression B = s.parameter("B", "kg m^2", 0.168);
  const Expression C = s.parameter("C", "kg m^2", 0.9);
  const Expression k = s.parameter("k", "N m", 3);
  const Expression c = s.parameter("c", "N m s", 0.6);
  const Expression psi = s.coordinate("psi", "rad");
  const Expression theta = s.coordinate("theta", "rad");
  const FrameHandle hub = s.revolute("hub", s.ground(), axis::z, psi);
  const FrameHandle arm = s.revolute("arm", hub, axis::y, theta, {.origin = {a, 0, 0}});
  s.body("hub", hub, Inertia::general({.mass = m, .xx = C, .yy = C, .zz = C}));
  s.body("arm", arm, Inertia::general({.mass = m, .xx = A, .yy = B}).at({0, 0, b}));
  s.spring("hinge_spring", theta, k, pi() / 2);
  s.damper("hinge_friction", theta, c);
  s.motor("tau", theta);
  return s;
}

/// Mass hung on a spring between two points: the length of the spring is a square root.
inline Scene elastic_pendulum() {
  Scene s("elastic_pendulum");
  const Expression m = s.parameter("m", "kg", 1);
  const Expression k = s.parameter("k", "N/m", 100);
  const Expression l = s.parameter("l", "m", 1);
  const Expression g = s.parameter("g", "m/s^2", 9.81);
  const Expression x = s.coordinate("x", "m");
  const Expression y = s.coordinate("y", "m");
  s.initial(y, -1);
  const FrameHandle slider = s.prismatic("slider", s.ground(), axis::x, x);
  const FrameHandle bob = s.prismatic("bob", slider, axis::y, y);
  s.body("bob", bob, Inertia::point(m));
  s.gravity({0, -g, 0});
  const PointHandle top = s.point("top", s.ground(), {0, 0, 0});
  const PointHandle end = s.point("end", bob, {0, 0, 0});
  s.spring("spring", {.a = top, .b = end, .stiffness = k, .rest = l});
  return s;
}

/// Block on an incline whose normal motion is released; a force pushes it, the plane's slope is a number.
inline Scene released_block() {
  Scene s("released_block");
  const Expression m = s.parameter("m", "kg", 2);
  const Expression g = s.parameter("g", "m/s^2", 9.81);
  const Expression F = s.parameter("F", "N", 3);
  const Expression x = s.coordinate("x", "m");
  const Expression N = s.released_coordinate("N", "m");
  const FrameHandle incline = s.weld("incline", s.ground(), {.rotation = Rotation::about(1, 2)});
  const FrameHandle normal = s.prismatic("normal", incline, axis::z, N);
  const FrameHandle block = s.prismatic("block", normal, axis::x, x);
  s.body("block", block, Inertia::point(m));
  s.gravity({0, 0, -g});
  const PointHandle middle = s.point("middle", block, {0, 0, 0});
  s.force("push", {.body = block, .point = middle, .components = {F, 0, 0}, .axes = incline});
  return s;
}

/// Sled on a knife edge: one non-holonomic constraint.
inline Scene sled() {
  Scene s("sled");
  const Expression m = s.parameter("m", "kg", 2);
  const Expression I = s.parameter("I", "kg m^2", 0.5);
  const Expression x = s.coordinate("x", "m");
  const Expression y = s.coordinate("y", "m");
  const Expression psi = s.coordinate("psi", "rad");
  const FrameHandle along = s.prismatic("along", s.ground(), axis::x, x);
  const FrameHandle across = s.prismatic("across", along, axis::y, y);
  const FrameHandle body = s.revolute("body", across, axis::z, psi);
  s.body("sled", body, Inertia::general({.mass = m, .zz = I}));
  s.nonholonomic("edge", cos(psi) * rate(y) - sin(psi) * rate(x));
  return s;
}

/// Spatial chain with alternating axes; every length and mass is a parameter.
inline Scene chain(int joints) {
  Scene s("chain");
  const Expression g = s.parameter("g", "m/s^2", 9.81);
  FrameHandle parent = s.ground();
  for (int i = 1; i <= joints; ++i) {
    const std::string k = std::to_string(i);
    const Expression q = s.coordinate("q" + k, "rad");
    const Expression l = s.parameter("l_" + k, "m", 0.5);
    const Expression m = s.parameter("m_" + k, "kg", 1);
    const Placement placement = i == 1 ? Placement{} : Placement{.origin = {0, -l, 0}};
    parent = s.revolute("link" + k, parent, i % 2 == 0 ? axis::x : axis::z, q, placement);
    s.body("link" + k, parent,
           Inertia::general({.mass = m, .xx = m * l * l / 12, .yy = m * l * l / 100, .zz = m * l * l / 12})
               .at({0, -l / 2, 0}));
  }
  s.gravity({0, -g, 0});
  return s;
}

}  // namespace torsor::test
