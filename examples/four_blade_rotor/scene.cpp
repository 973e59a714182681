// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Rotor of four blades (Pommier, 8.2 exercise 2): thin homogeneous rectangles of mass m, at right angles around z,
/// each turned by alpha about its span out of the plane A, x, y. A blade reaches from s to s + l from A, its chord is
/// w. The rotor turns in any way about A, placed by the unit quaternion e: its mass matrix is its inertia operator in
/// A.
torsor::Scene four_blade_rotor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("four_blade_rotor", "Rotor of four blades set at a pitch, turning about its centre");

  const Expression m = scene.parameter("m", "kg", 30);
  const Expression s = scene.parameter("s", "m", 0.5_r);
  const Expression l = scene.parameter("l", "m", 5);
  const Expression w = scene.parameter("w", "m", 0.4_r);
  const Expression alpha = scene.run_time_parameter("alpha", "rad", 0.2_r);

  const AttitudeHandle e = scene.attitude("e");
  scene.initial(
      e, {1, 0, 0, 0},
      {Expression::quantity("0.4", "rad/s"), Expression::quantity("0.3", "rad/s"), Expression::quantity("5", "rad/s")});

  const FrameHandle rotor = scene.spherical("rotor", scene.ground(), e);
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i + 1);
    const FrameHandle arm = scene.weld("arm_" + number, rotor, {.rotation = Rotation::about(2, 6 * i)});
    const FrameHandle blade = scene.revolute("blade_" + number, arm, axis::x, alpha);
    scene.body("blade_" + number, blade, Inertia::plate(m, l, w).at({s + l / 2, 0, 0}));
  }
  return scene;
}

TORSOR_SCENE(four_blade_rotor_scene)
