// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Graham variator (Pommier, 8.3.2 exercise 6; its figure is lost, so that the places below are a reading of the text).
/// The carrier S1 turns by alpha about (O, x0), y0 pointing up. The satellite S2, a cone of apex C and half angle
/// delta, turns by beta about its axis (C, x2) on S1, (x1, x2) = delta, FC = c y1 with F on (O, x0). Its outer
/// generatrix is parallel to x0: the ring S4, of radius c, can be slid along the frame and touches it at A, at d along
/// the axis: CD = -d x2, DA = d tan(delta) v, v perpendicular to x2 in the plane x1, y1. A pinion of radius p on S2, at
/// l along the axis, meets the internal rim of S3 at E: CE = -l x2 + p v (p < 0 would be a sun inside). S3 turns by
/// gamma about (O, x0). The slides of S4 set the ratio: d is a run-time parameter. Torques C1 and C3 act on S1 and S3.
torsor::Scene graham_variator_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("graham_variator", "Graham variator: a cone rolling in a ring drives a third body");

  const Expression c = scene.parameter("c", "m", 0.1_r);
  const Expression d = scene.run_time_parameter("d", "m", 0.1_r);
  const Expression delta = scene.parameter("delta", "rad", pi() / 12);
  const Expression l = scene.parameter("l", "m", 0.03_r);
  const Expression p = scene.parameter("p", "m", 0.02_r);
  const Expression b = scene.parameter("b", "m", 0.06_r);  // CG2 = -b x2
  const Expression m2 = scene.parameter("m2", "kg", 1);
  const Expression A1 = scene.parameter("A1", "kg m^2", 0.01_r);
  const Expression A2 = scene.parameter("A2", "kg m^2", 0.0003_r);
  const Expression B2 = scene.parameter("B2", "kg m^2", 0.0008_r);
  const Expression A3 = scene.parameter("A3", "kg m^2", 0.02_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression alpha = scene.coordinate("alpha", "rad");
  const Expression beta = scene.coordinate("beta", "rad");
  const Expression gamma = scene.coordinate("gamma", "rad");
  // What the contacts demand of the rates: question 1 of the page.
  const Expression rate = Expression::quantity("20", "rad/s");
  const Expression r3 = c - l * sin(delta) + p * cos(delta);
  const Expression beta_rate = -rate * c / (d * tan(delta));
  scene.initial(alpha, 0, rate);
  scene.initial(beta, 0, beta_rate);
  scene.initial(gamma, 0, rate + beta_rate * p / r3);

  const FrameHandle S1 = scene.revolute("S1", scene.ground(), axis::x, alpha);
  const FrameHandle inclined = scene.revolute("inclined", S1, axis::z, delta, {.origin = {0, c, 0}});
  const FrameHandle S2 = scene.revolute("S2", inclined, axis::x, beta);
  const FrameHandle S3 = scene.revolute("S3", scene.ground(), axis::x, gamma);
  const FrameHandle S4 = scene.weld("S4", scene.ground(), {});
  // S1 and S3 are balanced: only their moments about (O, x0) matter.
  const Expression m = Expression::quantity("1", "kg");
  scene.body("S1", S1, Inertia::general({.mass = m, .xx = A1, .yy = A1, .zz = A1}));
  scene.body("S2", S2, Inertia::general({.mass = m2, .xx = A2, .yy = B2, .zz = B2}).at({-b, 0, 0}));
  scene.body("S3", S3, Inertia::general({.mass = m, .xx = A3, .yy = A3, .zz = A3}));

  // At A and E the bodies move across the plane x1, y1 only: along x1 the condition of rolling is an identity.
  const FrameHandle contacts = scene.weld("contacts", S1, {.rotation = Rotation::about(0, 6)});
  const PointHandle A = scene.point("A", inclined, {-d, d * tan(delta), 0});
  const PointHandle E = scene.point("E", inclined, {-l, p, 0});
  const auto at_A = scene.rolling("rolling_A", {.body = S2, .on = S4, .contact = A, .tangents = contacts});
  const auto at_E = scene.rolling("rolling_E", {.body = S2, .on = S3, .contact = E, .tangents = contacts});
  scene.reaction(at_A[1], "T_A", {.body = S2, .contact = A, .direction = axis::z, .axes = S1, .other = S4});
  scene.reaction(at_E[1], "T_E", {.body = S2, .contact = E, .direction = axis::z, .axes = S1, .other = S3});

  // For pictures: the carrier, the cone with its pinion, spokes of S3 in the plane of E, the ring S4 in the plane of A.
  const Placement along_x{{0, 0, 0}, Rotation::about(1, 6)};  // z of a form along x
  const Expression length = 3 * d / 2, thin = c / 40;
  scene.show({.frame = S1, .form = form::Segment{{0, 0, 0}, {0, c, 0}, thin}});
  scene.show({.frame = S2,
              .form = form::Cone{length * tan(delta), length},
              .placement = {{-length, 0, 0}, along_x.rotation},
              .colour = Colour{0.85, 0.6, 0.2}});
  scene.show({.frame = S2, .form = form::Cylinder{p, p / 2}, .placement = {{-l, 0, 0}, along_x.rotation}});
  const Expression at_E_x = -l * cos(delta) - p * sin(delta), at_A_x = -d / cos(delta);
  for (int k = 0; k < 4; ++k) {
    const Expression angle = pi() / 4 * k;
    const Triple end{at_E_x, r3 * cos(angle), r3 * sin(angle)};
    scene.show({.frame = S3, .form = form::Segment{{at_E_x, -end[1], -end[2]}, end, thin}});
  }
  scene.show({.frame = S4, .form = form::Torus{c, thin}, .placement = {{at_A_x, 0, 0}, along_x.rotation}});

  scene.gravity({0, -g, 0});
  scene.motor("C1", alpha);
  scene.motor("C3", gamma);
  return scene;
}

TORSOR_SCENE(graham_variator_scene)
