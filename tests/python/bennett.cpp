// SPDX-License-Identifier: GPL-3.0-or-later
// Bennett's linkage with masses: all along its motion one condition of its loop vanishes, and others repeat each other.
#include "torsor/generator/torsor.hpp"

torsor::Scene bennett_scene() {
  using namespace torsor;
  Scene scene("bennett", "A loop of four hinges in space");
  const Expression a = Expression::quantity("1", "m"), b = 2 * a, kg = Expression::quantity("1", "kg");
  // Links a and b long, between axes that are 30 and 90 degrees apart: tan(first/2) tan(second/2) = sqrt(3).
  const Placement along_a{{a, 0, 0}, Rotation::about(0, 2)}, along_b{{b, 0, 0}, Rotation::about(0, 6)};
  const Expression first = scene.coordinate("first", "rad"), second = scene.coordinate("second", "rad");
  const Expression third = scene.coordinate("third", "rad");
  scene.initial(first, Expression::quantity("0.7", "rad"));
  scene.initial(second, Expression::quantity("2.7261731790164174", "rad"));
  scene.initial(third, Expression::quantity("-0.7", "rad"));
  const FrameHandle one = scene.revolute("one", scene.ground(), axis::z, first);
  const FrameHandle two = scene.revolute("two", one, axis::z, second, along_a);
  const FrameHandle three = scene.revolute("three", two, axis::z, third, along_b);
  for (const char* link : {"one", "two", "three"}) scene.body(link, link, Inertia::solid_sphere(kg, a / 5).at({a / 2, 0, 0}));
  const FrameHandle end = scene.weld("end", three, along_a);
  const FrameHandle back = scene.weld("back", scene.ground(), {{-b, 0, 0}, Rotation::about(0, 6).transpose()});
  // The axes of the last hinge are z of both; a loop joint turns about x.
  const Placement x_along_z{{0, 0, 0}, Rotation::about(1, -6)};
  const FrameHandle end_x = scene.weld("end_x", end, x_along_z), back_x = scene.weld("back_x", back, x_along_z);
  scene.loop_joint("last", {.type = JointType::revolute, .a = back_x, .b = end_x});
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

TORSOR_SCENE(bennett_scene)
