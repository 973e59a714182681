// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Fast symmetric top about a fixed point (Lagrange's top; data of Terze, Mueller and Zlatar, 2016). Its axis is y3;
/// the centre of mass lies l y3 from the fixed point O. Three plane rotations place it: alpha about x1, beta about z
/// and the spin gamma about y. That order is singular where the axis lies along x1; Euler's angles about the vertical
/// would be singular upside down, where this top passes within 1e-6 rad again and again, so x1 is slanted to where it
/// never comes: x0 turned by pi/6 about y0.
torsor::Scene heavy_top_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("heavy_top", "Fast symmetric top about a fixed point");

  const Expression m = scene.parameter("m", "kg", 15);
  const Expression l = scene.parameter("l", "m", 1);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  // About the centre of mass: across the axis, and about it.
  const Expression A = scene.parameter("A", "kg m^2", 0.234375_r);
  const Expression C = scene.parameter("C", "kg m^2", 0.46875_r);

  const Expression alpha = scene.coordinate("alpha", "rad");
  const Expression beta = scene.coordinate("beta", "rad");
  const Expression gamma = scene.coordinate("gamma", "rad");
  // The body's axes begin along the ground's; it turns at 150 y0 - 4.61538 z0.
  const Expression turning = Expression::quantity("-4.61538", "rad/s");
  scene.initial(alpha, 0, -turning * sin(pi() / 6));
  scene.initial(beta, 0, turning * cos(pi() / 6));
  scene.initial(gamma, -pi() / 6, Expression::quantity("150", "rad/s"));

  const FrameHandle slanted = scene.weld("slanted", scene.ground(), {.rotation = Rotation::about(1, 2)});
  const FrameHandle first = scene.revolute("first", slanted, axis::x, alpha);
  const FrameHandle second = scene.revolute("second", first, axis::z, beta);
  const FrameHandle top = scene.revolute("top", second, axis::y, gamma);
  scene.body("top", top, Inertia::general({.mass = m, .xx = A, .yy = C, .zz = A}).at({0, l, 0}));
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(heavy_top_scene)
