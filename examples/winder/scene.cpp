// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Winder (Pommier, 8.3.2 exercise 4; w upwards). The arm Sigma turns about (O, w) at a constant rate, driven by a
/// motor. A cylindrical joint lets the bobbin S slide and turn freely on the axis (B, z) of the arm, OB = b i, its
/// centre G at BG = lambda z, its own turn phi. The thread pulls G towards the point A of the axis w, OA = a w, with
/// the force m k GA. The figure is lost: z is taken normal to i, turned by `slope` from w about i, so that 0 is an
/// upright axis and pi/2 a level one.
torsor::Scene winder_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("winder", "Winder: a bobbin on a turning arm");

  const Expression m = scene.parameter("m", "kg", 0.5_r);
  const Expression A = scene.parameter("A", "kg m^2", 0.0008_r);  // of the bobbin, across its axis and about it
  const Expression C = scene.parameter("C", "kg m^2", 0.0005_r);
  const Expression arm = scene.parameter("arm", "kg m^2", 0.02_r);  // of Sigma about (O, w)
  const Expression b = scene.parameter("b", "m", 0.2_r);
  const Expression a = scene.parameter("a", "m", 0.3_r);
  const Expression k = scene.parameter("k", "s^-2", 400);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 10);
  const Expression slope = scene.run_time_parameter("slope", "rad", pi() / 3);

  const Expression theta = scene.coordinate("theta", "rad");
  const Expression lambda = scene.coordinate("lambda", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  const Expression motor = scene.released_coordinate("motor", "rad");
  scene.drive(theta, omega * scene.time());
  scene.initial(lambda, 0.05_r);
  scene.initial(phi, 0, Expression::quantity("5", "rad/s"));

  const FrameHandle axle = scene.revolute("axle", scene.ground(), axis::z, motor);
  const FrameHandle sigma = scene.revolute("Sigma", axle, axis::z, theta);
  scene.name_joint(sigma, "pivot_with_motor");
  const FrameHandle holder = scene.revolute("holder", sigma, axis::x, slope, {.origin = {b, 0, 0}});
  const FrameHandle bobbin = scene.cylindrical("S", holder, {.axis = axis::z, .displacement = lambda, .angle = phi});
  scene.body("Sigma", sigma, Inertia::general({.mass = 0, .zz = arm}));
  scene.body("S", bobbin, Inertia::general({.mass = m, .xx = A, .yy = A, .zz = C}));
  const PointHandle G = scene.point("G", bobbin, {0, 0, 0});
  const PointHandle fixed = scene.point("fixed", sigma, {0, 0, a});
  scene.spring("thread", {.a = G, .b = fixed, .stiffness = m * k});
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(winder_scene)
