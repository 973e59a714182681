// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Model-making press (Pommier, §3.5.5) reduced to three bodies and three joints: the traverse slides along z, the
/// screw turns and advances in the frame, and the screw's end touches the traverse at a point.
torsor::Scene model_making_press_reduced_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("model_making_press_reduced",
              "Model-making press, reduced: one prismatic, one helical, one point contact");

  const Expression m10 = scene.parameter("m10", "kg", 0.84_r);  // both cups included
  const Expression m20 = scene.parameter("m20", "kg", 0.3_r);
  const Expression C20 = scene.parameter("C20", "kg m^2", 0.0001_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression p = scene.parameter("p", "m", 0.004_r / (2 * pi()));  // 4 mm a turn
  const Expression K = scene.parameter("K", "N/m", 20000);               // of what is pressed
  const Expression c = scene.parameter("c", "N m s/rad", 0.0005_r);      // of the thread

  const Expression a_z = scene.coordinate("a_z", "m"), omega_z = scene.coordinate("omega_z", "rad");
  const FrameHandle traverse = scene.prismatic("traverse", scene.ground(), axis::z, a_z);
  const FrameHandle screw = scene.helical("screw", scene.ground(), {.axis = axis::z, .angle = omega_z, .pitch = p});
  scene.name_joint(traverse, "LA");
  scene.name_joint(screw, "LC");
  scene.loop_joint("LB", {.type = JointType::point_contact, .a = traverse, .b = screw});
  scene.body("traverse", traverse, Inertia::point(m10));
  scene.body("screw", screw, Inertia::general({.mass = m20, .xx = C20, .yy = C20, .zz = C20}));

  scene.gravity({0, 0, -g});
  scene.spring("pressed", a_z, K);
  scene.damper("thread", omega_z, c);
  scene.motor("C", omega_z);
  return scene;
}

TORSOR_SCENE(model_making_press_reduced_scene)
