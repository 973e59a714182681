// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Model-making press (Pommier, §3.5.5), with every joint: a traverse slides on two columns; a screw in the summit,
/// which is fixed to the frame, moves it through a cup above and a cup below. z is the axis of the screw, O its end;
/// A and B are on the columns. The frame is the ground.
torsor::Scene model_making_press_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("model_making_press", "Model-making press: two columns, a screw and two cups");

  const Expression m10 = scene.parameter("m10", "kg", 0.8_r);
  const Expression C10 = scene.parameter("C10", "kg m^2", 0.002_r);
  const Expression m20 = scene.parameter("m20", "kg", 0.3_r);
  const Expression C20 = scene.parameter("C20", "kg m^2", 0.0001_r);
  const Expression m30 = scene.parameter("m30", "kg", 0.02_r);
  const Expression C30 = scene.parameter("C30", "kg m^2", 0.00001_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression p = scene.parameter("p", "m", 0.004_r / (2 * pi()));  // 4 mm a turn
  const Expression K = scene.parameter("K", "N/m", 20000);               // of what is pressed
  const Expression c = scene.parameter("c", "N m s/rad", 0.0005_r);      // of the thread
  const Expression e = scene.parameter("e", "m", 0.1_r);                 // of the columns
  const Expression h = scene.parameter("h", "m", 0.15_r);                // of the summit

  const auto angle = [&scene](const char* name) { return scene.coordinate(name, "rad"); };

  const Expression a_z = scene.coordinate("a_z", "m"), a = angle("a");
  const FrameHandle column = scene.weld("column_A", scene.ground(), {{-e, 0, 0}, {}});
  const FrameHandle ring = scene.cylindrical("ring_A", column, {.axis = axis::z, .displacement = a_z, .angle = a});
  const FrameHandle traverse = scene.weld("traverse", ring, {{e, 0, 0}, {}});

  const FrameHandle lower_cup = scene.spherical("lower_cup", traverse, scene.attitude("lower"));
  const FrameHandle upper_cup = scene.spherical("upper_cup", traverse, scene.attitude("upper"));

  const FrameHandle summit = scene.weld("summit", scene.ground(), {{0, 0, h}, {}});
  const Expression omega_z = angle("omega_z");
  const FrameHandle screw =
      scene.helical("screw", summit, {.axis = axis::z, .angle = omega_z, .pitch = p}, {{0, 0, -h}, {}});

  scene.name_joint(ring, "L1");
  scene.name_joint(lower_cup, "L4");
  scene.name_joint(upper_cup, "L6");
  scene.name_joint(screw, "L7");
  scene.name_joint(summit, "L8");
  // The axis of a cylindrical joint that closes a loop is x of both frames: here along the old z.
  const Rotation x_along_z = Rotation::about(1, -6);
  const FrameHandle column_B = scene.weld("column_B", scene.ground(), {{e, 0, 0}, x_along_z});
  const FrameHandle ring_B = scene.weld("ring_B", traverse, {{e, 0, 0}, x_along_z});
  scene.loop_joint("L2", {.type = JointType::cylindrical, .a = column_B, .b = ring_B});
  scene.loop_joint("L3", {.type = JointType::planar, .a = lower_cup, .b = screw});
  scene.loop_joint("L5", {.type = JointType::planar, .a = upper_cup, .b = screw});

  scene.body("traverse", traverse, Inertia::general({.mass = m10, .xx = C10, .yy = C10, .zz = C10}));
  scene.body("screw", screw, Inertia::general({.mass = m20, .xx = C20, .yy = C20, .zz = C20}));
  scene.body("lower_cup", lower_cup, Inertia::general({.mass = m30, .xx = C30, .yy = C30, .zz = C30}));
  scene.body("upper_cup", upper_cup, Inertia::general({.mass = m30, .xx = C30, .yy = C30, .zz = C30}));

  scene.gravity({0, 0, -g});
  scene.spring("pressed", a_z, K);
  scene.damper("thread", omega_z, c);
  scene.motor("C", omega_z);
  return scene;
}

TORSOR_SCENE(model_making_press_scene)
