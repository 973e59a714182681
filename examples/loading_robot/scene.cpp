// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Press-loading robot (Pommier, 8.3.2 exercise 7), plane x0, y0 with y0 up. S1 turns about (Oo, z0) by alpha, driven
/// by the torque C01; S2 slides along (O1, x1) by x, driven by the force F12; S3 turns about (O2, z0) by beta relative
/// to S2, driven by the torque C23. Oo O1 = h y1, O1 G1 = L1 x1, O2 G2 = L2 x1, O2 G3 = -L3 x3. I1, I2, I3 are moments
/// of inertia about (Oo, z0), (O2, z0), (O2, z0), as the exercise gives them.
torsor::Scene loading_robot_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("loading_robot", "Press-loading robot: motor actions and the transverse reaction Y12");

  const Expression h = scene.parameter("h", "m", 0.5_r);
  const Expression L1 = scene.parameter("L1", "m", 0.3_r);
  const Expression L2 = scene.parameter("L2", "m", 0.4_r);
  const Expression L3 = scene.parameter("L3", "m", 0.2_r);
  const Expression m1 = scene.parameter("m1", "kg", 60);
  const Expression m2 = scene.parameter("m2", "kg", 25);
  const Expression m3 = scene.parameter("m3", "kg", 8);
  const Expression I1 = scene.parameter("I1", "kg m^2", 30);
  const Expression I2 = scene.parameter("I2", "kg m^2", 6);
  const Expression I3 = scene.parameter("I3", "kg m^2", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression alpha = scene.coordinate("alpha", "rad");
  const Expression x = scene.coordinate("x", "m");
  const Expression beta = scene.coordinate("beta", "rad");
  // The slide does not move along y1: this coordinate is held at zero, and the reaction against it is Y12.
  const Expression Y12 = scene.released_coordinate("Y12", "m");
  scene.initial(alpha, 0.4_r, Expression::quantity("0.2", "rad/s"));
  scene.initial(x, 0.6_r, Expression::quantity("-0.1", "m/s"));
  scene.initial(beta, 0.7_r);

  const FrameHandle S1 = scene.revolute("S1", scene.ground(), axis::z, alpha);
  const FrameHandle guide = scene.prismatic("guide", S1, axis::y, Y12, {.origin = {0, h, 0}});
  const FrameHandle S2 = scene.prismatic("S2", guide, axis::x, x);
  const FrameHandle S3 = scene.revolute("S3", S2, axis::z, beta);
  // Where moments are taken to find one unknown at a time.
  scene.point("Oo", scene.ground(), {0, 0, 0});
  scene.point("O2", S2, {0, 0, 0});
  // In a plane motion nothing but the moment about z matters, here moved to the centres of mass (Huygens).
  const auto plane = [](const Expression& mass, const Expression& about_z) {
    return Inertia::general({.mass = mass, .zz = about_z});
  };
  scene.body("S1", S1, plane(m1, I1 - m1 * (L1 * L1 + h * h)).at({L1, h, 0}));
  scene.body("S2", S2, plane(m2, I2 - m2 * L2 * L2).at({L2, 0, 0}));
  scene.body("S3", S3, plane(m3, I3 - m3 * L3 * L3).at({-L3, 0, 0}));

  scene.gravity({0, -g, 0});
  scene.motor("C01", alpha);
  scene.motor("F12", x);
  scene.motor("C23", beta);
  // For pictures: the column with its rail, the slide, the arm.
  scene.show({.frame = S1, .form = form::Segment{{0, 0, 0}, {0, h, 0}, h / 12}});
  scene.show({.frame = S1, .form = form::Segment{{-L1 / 2, h, 0}, {2 * L1, h, 0}, h / 30}});
  scene.show({.frame = S2, .form = form::Segment{{0, 0, 0}, {2 * L2, 0, 0}, h / 20}});
  scene.show({.frame = S3, .form = form::Segment{{0, 0, 0}, {-2 * L3, 0, 0}, h / 25}});
  scene.show({.frame = S3, .form = form::Sphere{h / 12}});
  return scene;
}

TORSOR_SCENE(loading_robot_scene)
