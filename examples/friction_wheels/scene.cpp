// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Two friction wheels (Pommier, §3.4.4). S1 turns about (O, z), S2 about (A, z), OA = (r1 + r2) y; they roll on each
/// other without slipping at I, OI = r1 y. A motor turns S1, a viscous load holds S2 back. T is the force of S2 on S1
/// along x.
torsor::Scene friction_wheels_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("friction_wheels", "Two friction wheels rolling on each other without slipping");

  const Expression r1 = scene.parameter("r1", "m", 0.1_r);
  const Expression r2 = scene.parameter("r2", "m", 0.3_r);
  const Expression m1 = scene.parameter("m1", "kg", 2);
  const Expression m2 = scene.parameter("m2", "kg", 18);
  const Expression c = scene.parameter("c", "N m s", 0.9_r);

  const Expression theta_1 = scene.coordinate("theta_1", "rad");
  const Expression theta_2 = scene.coordinate("theta_2", "rad");
  const Expression rate = Expression::quantity("6", "rad/s");
  scene.initial(theta_1, 0, rate);
  scene.initial(theta_2, 0, -r1 / r2 * rate);

  const FrameHandle S1 = scene.revolute("S1", scene.ground(), axis::z, theta_1);
  const FrameHandle S2 = scene.revolute("S2", scene.ground(), axis::z, theta_2, {.origin = {0, r1 + r2, 0}});
  scene.body("S1", S1, Inertia::disk(m1, r1, 2));
  scene.body("S2", S2, Inertia::disk(m2, r2, 2));
  const PointHandle I = scene.point("I", scene.ground(), {0, r1, 0});
  // The same place seen from either wheel: its velocity is that of the wheel's own point there.
  scene.point("I1", S1, {r1 * sin(theta_1), r1 * cos(theta_1), 0});
  scene.point("I2", S2, {-r2 * sin(theta_2), -r2 * cos(theta_2), 0});
  // The normal at I is the line of centres. Along the axes z the wheels cannot slip: that condition is an identity.
  const FrameHandle contact = scene.weld("contact", scene.ground(), {.rotation = Rotation::about(0, -6)});
  const auto rolling = scene.rolling("rolling", {.body = S1, .on = S2, .contact = I, .tangents = contact});
  scene.reaction(rolling[0], "T",
                 {.body = S1, .contact = I, .direction = axis::x, .axes = scene.ground(), .other = S2});

  // For pictures: the wheels, each with a spoke.
  for (const auto& [wheel, radius] : {std::pair{S1, r1}, std::pair{S2, r2}}) {
    scene.show({.frame = wheel, .form = form::Cylinder{radius, r1 / 4}});
    scene.show({.frame = wheel,
                .form = form::Segment{{0, 0, r1 / 8}, {0, radius, r1 / 8}, r1 / 30},
                .colour = Colour{0.9, 0.9, 0.9}});
  }

  scene.motor("C1", theta_1);
  scene.rotational_drag("load", S2, c);
  return scene;
}

TORSOR_SCENE(friction_wheels_scene)
