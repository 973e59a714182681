// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Two point masses m1 = s m and m2 = (1 - s) m that attract each other, U = G m1 m2 / r (Pommier, §5.2.4), in the
/// plane of their motion. X and Y place their common centre of mass, r and phi the second as seen from the first:
/// coordinates in which momenta are cyclic. Units of its own: G = 1. They start at their closest on an ellipse of
/// semi-major axis 1 and eccentricity 0.6, while the centre of mass drifts.
torsor::Scene mutual_gravitation_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("mutual_gravitation", "Two masses under their mutual gravitation");

  const Expression G = scene.parameter("G", "m^3/(kg s^2)", 1);
  const Expression m = scene.parameter("m", "kg", 4);
  const Expression s = scene.parameter("s", "1", 0.75_r);

  const Expression X = scene.coordinate("X", "m");
  const Expression Y = scene.coordinate("Y", "m");
  const Expression r = scene.coordinate("r", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.initial(X, 0, Expression::quantity("0.25", "m/s"));
  scene.initial(Y, 0, Expression::quantity("-0.125", "m/s"));
  scene.initial(r, 0.4_r);
  scene.initial(phi, 0, Expression::quantity("10", "rad/s"));

  const FrameHandle drift = scene.prismatic("drift", scene.ground(), axis::x, X);
  const FrameHandle center = scene.prismatic("center", drift, axis::y, Y);
  const FrameHandle line = scene.revolute("line", center, axis::z, phi);
  const FrameHandle first = scene.prismatic("first", line, axis::x, -(1 - s) * r);
  const FrameHandle second = scene.prismatic("second", line, axis::x, s * r);
  scene.body("first", first, Inertia::point(s * m));
  scene.body("second", second, Inertia::point((1 - s) * m));
  const PointHandle P1 = scene.point("P1", first, {0, 0, 0});
  const PointHandle P2 = scene.point("P2", second, {0, 0, 0});
  scene.gravitation("attraction", P1, P2, G * s * m * (1 - s) * m);
  return scene;
}

TORSOR_SCENE(mutual_gravitation_scene)
