// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// The bicycle of Whipple (1899) with the parameters of the benchmark of Meijaard, Papadopoulos, Ruina and Schwab
/// (Proc. R. Soc. A 463:1955-1982, 2007): rear wheel, rear frame with rider, front frame and front wheel; knife-edge
/// wheels that roll on a plane without slipping. Axes x forward, y to the right, z down; upright the rear wheel touches
/// the origin. Nothing is linear here, and the contacts are found by the generator.
torsor::Scene whipple_bicycle_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("whipple_bicycle", "Whipple's bicycle: two rolling wheels, benchmark of 2007");

  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression w = scene.parameter("w", "m", 1.02_r);  // wheel base
  const Expression c = scene.parameter("c", "m", 0.08_r);  // trail
  const Expression tilt = pi() / 10;                       // of the steer axis, back from the vertical
  const Expression r_R = scene.parameter("r_R", "m", 0.3_r);
  const Expression r_F = scene.parameter("r_F", "m", 0.35_r);
  const auto mass = [&](const char* name, const Expression& value) { return scene.parameter(name, "kg", value); };
  const auto moment = [&](const char* name, const Expression& value) { return scene.parameter(name, "kg m^2", value); };
  const auto length = [&](const char* name, const Expression& value) { return scene.parameter(name, "m", value); };

  const Expression x = scene.coordinate("x", "m");  // centre of the rear wheel
  const Expression y = scene.coordinate("y", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression yaw = scene.coordinate("yaw", "rad");
  const Expression roll = scene.coordinate("roll", "rad");
  const Expression pitch = scene.coordinate("pitch", "rad");
  const Expression steer = scene.coordinate("steer", "rad");
  const Expression rear = scene.coordinate("rear", "rad");
  const Expression front = scene.coordinate("front", "rad");

  // Upright, straight ahead, begins to fall to the right.
  const Expression v = Expression::quantity("4.6", "m/s");
  const Expression falls = Expression::quantity("0.5", "rad/s");
  scene.initial(x, 0, v);
  scene.initial(y, 0, r_R * falls);
  scene.initial(z, -r_R);
  scene.initial(roll, 0, falls);
  scene.initial(rear, 0, -v / r_R);
  scene.initial(front, 0, -v / r_F);

  const FrameHandle road = scene.weld("road", scene.ground(), {{0, 0, 0}, Rotation::about(0, 12)});  // its z is up
  const FrameHandle frame = scene.free("frame", scene.ground(), {x, y, z},
                                       {.sequence = AngleSequence{{2, 0, 1}}, .angles = {yaw, roll, pitch}});
  const FrameHandle rear_wheel = scene.revolute("rear_wheel", frame, axis::y, rear);
  // The steer axis meets the road a trail ahead of the front contact.
  const FrameHandle fork = scene.revolute("fork", frame, {sin(tilt), 0, cos(tilt)}, steer, {{w + c, 0, r_R}});
  const FrameHandle hub = scene.weld("hub", fork, {{-c, 0, -r_F}});
  const FrameHandle front_wheel = scene.revolute("front_wheel", hub, axis::y, front);

  const Expression I_Rx = moment("I_Rxx", 0.0603_r), I_Fx = moment("I_Fxx", 0.1405_r);
  const Expression m_R = mass("m_R", 2), I_Ry = moment("I_Ryy", 0.12_r);
  scene.body("R", rear_wheel, Inertia::general({.mass = m_R, .xx = I_Rx, .yy = I_Ry, .zz = I_Rx}));
  const Expression x_B = length("x_B", 0.3_r), z_B = length("z_B", -0.9_r);
  const Expression m_B = mass("m_B", 85), I_Bx = moment("I_Bxx", 9.2_r), I_By = moment("I_Byy", 11);
  const Expression I_Bz = moment("I_Bzz", 2.8_r), I_Bxz = moment("I_Bxz", 2.4_r);
  scene.body("B", frame,
             Inertia::general({.mass = m_B, .xx = I_Bx, .yy = I_By, .zz = I_Bz, .xz = I_Bxz}).at({x_B, 0, z_B + r_R}));
  const Expression x_H = length("x_H", 0.9_r), z_H = length("z_H", -0.7_r);
  const Expression m_H = mass("m_H", 4), I_Hx = moment("I_Hxx", 0.05892_r), I_Hy = moment("I_Hyy", 0.06_r);
  const Expression I_Hz = moment("I_Hzz", 0.00708_r), I_Hxz = moment("I_Hxz", -0.00756_r);
  scene.body(
      "H", fork,
      Inertia::general({.mass = m_H, .xx = I_Hx, .yy = I_Hy, .zz = I_Hz, .xz = I_Hxz}).at({x_H - w - c, 0, z_H}));
  const Expression m_F = mass("m_F", 3), I_Fy = moment("I_Fyy", 0.28_r);
  scene.body("F", front_wheel, Inertia::general({.mass = m_F, .xx = I_Fx, .yy = I_Fy, .zz = I_Fx}));
  scene.gravity({0, 0, g});

  const PointHandle P = scene.disc_contact("P", {.frame = frame, .axis = axis::y, .radius = r_R, .plane = road});
  const PointHandle Q = scene.disc_contact("Q", {.frame = hub, .axis = axis::y, .radius = r_F, .plane = road});
  scene.point_in_plane("rear_touches", P, road);
  scene.point_in_plane("front_touches", Q, road);
  scene.rolling("rear_rolls", {.body = rear_wheel, .on = scene.ground(), .contact = P, .tangents = road});
  scene.rolling("front_rolls", {.body = front_wheel, .on = scene.ground(), .contact = Q, .tangents = road});
  scene.independent({roll, steer, rear});
  return scene;
}

TORSOR_SCENE(whipple_bicycle_scene)
