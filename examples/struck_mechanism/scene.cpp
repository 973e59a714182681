// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// A uniform rod OB that hangs from a hinge at O is struck across by a ball at the depth d below O (Pommier, 7.6.4). The
/// hinge's reaction has a coordinate of its own, held at zero, so that its impulse is known.
torsor::Scene struck_mechanism_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("struck_mechanism", "Hanging rod struck by a ball");

  const Expression L = scene.parameter("L", "m", 1.2_r);
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression m_ball = scene.parameter("m_ball", "kg", 0.3_r);
  const Expression r = scene.parameter("r", "m", 0.05_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression d = scene.run_time_parameter("d", "m", 0.9_r);
  const Expression e = scene.run_time_parameter("e", "1", 0.5_r);

  const Expression theta = scene.coordinate("theta", "rad");
  const Expression x = scene.coordinate("x", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression hinge_x = scene.coordinate("hinge_x", "m");
  scene.initial(x, -r, 4);
  scene.initial(z, -d);

  // The rod lies along -z of its frame, and the ball comes from x < 0: the line is the rod's side whose normal is -x.
  const FrameHandle hinge = scene.prismatic("hinge", scene.ground(), axis::x, hinge_x);
  const FrameHandle rod = scene.revolute("rod", hinge, -axis::y, theta);
  const FrameHandle side = scene.weld("side", rod, {.rotation = Rotation::about(1, -6)});
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle ball = scene.prismatic("ball", slide, axis::z, z);
  scene.body("rod", rod, Inertia::rod(m, L, 2).at({0, 0, -L / 2}));
  scene.body("ball", ball, Inertia::point(m_ball));
  scene.gravity({0, 0, -g});
  scene.holonomic("hinge_holds", hinge_x);
  scene.contact("blow", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = side}, {.restitution = e});
  return scene;
}

TORSOR_SCENE(struck_mechanism_scene)
