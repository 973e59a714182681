// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Two equal uniform rods AB and BC, jointed at B and free in the plane x, z, lie in one line along x. A ball that moves
/// along z strikes A. Both rods are free bodies: B is a joint that closes a loop, so that its impulse is known.
torsor::Scene struck_mechanism_two_rods_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("struck_mechanism_two_rods", "Two jointed rods struck by a ball");

  const Expression l = scene.parameter("l", "m", 1);
  const Expression m = scene.parameter("m", "kg", 1);
  const Expression m_ball = scene.parameter("m_ball", "kg", 0.5_r);
  const Expression r = scene.parameter("r", "m", 0.05_r);
  const Expression e = scene.run_time_parameter("e", "1", 0.5_r);

  const Expression x1 = scene.coordinate("x1", "m");
  const Expression z1 = scene.coordinate("z1", "m");
  const Expression w1 = scene.coordinate("w1", "rad");
  const Expression x2 = scene.coordinate("x2", "m");
  const Expression z2 = scene.coordinate("z2", "m");
  const Expression w2 = scene.coordinate("w2", "rad");
  const Expression z = scene.coordinate("z", "m");
  scene.initial(x1, l / 2);
  scene.initial(x2, 3 * l / 2);
  scene.initial(z, -r, 1);

  // Turns are counted from x to z, that is about -y.
  const auto free_rod = [&](const std::string& name, const Expression& x, const Expression& z_of, const Expression& w) {
    const FrameHandle slide = scene.prismatic(name + "_slide", scene.ground(), axis::x, x);
    const FrameHandle lift = scene.prismatic(name + "_lift", slide, axis::z, z_of);
    const FrameHandle rod = scene.revolute(name, lift, -axis::y, w);
    scene.body(name, rod, Inertia::rod(m, l, 0));
    return rod;
  };
  const FrameHandle ab = free_rod("ab", x1, z1, w1), bc = free_rod("bc", x2, z2, w2);
  const PointHandle b1 = scene.point("B1", ab, {l / 2, 0, 0});
  const PointHandle b2 = scene.point("B2", bc, {-l / 2, 0, 0});
  scene.closure("B_x", b1, b2, axis::x);
  scene.closure("B_z", b1, b2, axis::z);

  // The ball comes from below: the normal of the rod's lower side is -z.
  const FrameHandle lower = scene.weld("lower", ab, {.rotation = Rotation::about(0, 12)});
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(m_ball));
  scene.contact("blow", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = lower}, {.restitution = e});
  return scene;
}

TORSOR_SCENE(struck_mechanism_two_rods_scene)
