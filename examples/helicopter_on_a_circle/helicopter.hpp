// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>

#include "torsor/generator/torsor.hpp"

namespace helicopter_scenes {

/// A helicopter goes round a circle at constant speed (Pommier, 8.2 exercise 3) and carries the rotor of
/// four_blade_rotor. The cell turns by psi = omega t about (O, z0); its x1 points outwards, y1 the way it flies; A lies
/// at R x1 and the rotor's axis leans by theta towards the centre. The rotor turns by phi about its axis (A, z), driven
/// by a motor.
/// Six directions are released virtually: A along x1, y1, z0, and turning of the whole rotor about x, y, z of the
/// tilted cell. Without gravity the reactions are the components of the rotor's dynamic screw in A.
struct Helicopter {
  torsor::Expression m, s, l, w;  ///< mass of a blade, where it begins, its length and its chord
  torsor::Expression alpha, phi;  ///< pitch of the blades, angle of the rotor
  std::array<torsor::FrameHandle, 4> arm;
};

inline Helicopter add_helicopter(torsor::Scene& scene) {
  using namespace torsor;
  using namespace torsor::literals;
  Helicopter helicopter;
  helicopter.m = scene.parameter("m", "kg", 30);
  helicopter.s = scene.parameter("s", "m", 0.5_r);
  helicopter.l = scene.parameter("l", "m", 5);
  helicopter.w = scene.parameter("w", "m", 0.4_r);
  const Expression R = scene.parameter("R", "m", 100);
  const Expression theta = scene.run_time_parameter("theta", "rad", 0.3_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 0.2_r);
  helicopter.alpha = scene.run_time_parameter("alpha", "rad", 0.2_r);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  helicopter.phi = phi;
  scene.drive(psi, omega * scene.time());
  scene.initial(phi, 0, Expression::quantity("30", "rad/s"));
  const Expression X = scene.released_coordinate("X", "m");
  const Expression Y = scene.released_coordinate("Y", "m");
  const Expression Z = scene.released_coordinate("Z", "m");
  const Expression M_x = scene.released_coordinate("M_x", "rad");
  const Expression M_y = scene.released_coordinate("M_y", "rad");
  const Expression M_z = scene.released_coordinate("M_z", "rad");

  const FrameHandle turning = scene.revolute("turning", scene.ground(), axis::z, psi);
  const FrameHandle outwards = scene.prismatic("outwards", turning, axis::x, X, {.origin = {R, 0, 0}});
  const FrameHandle forwards = scene.prismatic("forwards", outwards, axis::y, Y);
  const FrameHandle upwards = scene.prismatic("upwards", forwards, axis::z, Z);
  const FrameHandle cell = scene.revolute("cell", upwards, axis::y, -theta);
  const FrameHandle roll = scene.revolute("roll", cell, axis::x, M_x);
  const FrameHandle pitch = scene.revolute("pitch", roll, axis::y, M_y);
  const FrameHandle yaw = scene.revolute("yaw", pitch, axis::z, M_z);
  const FrameHandle rotor = scene.revolute("rotor", yaw, axis::z, phi);
  scene.point("A", rotor, {0, 0, 0});
  for (int i = 0; i < 4; ++i) {
    helicopter.arm[static_cast<std::size_t>(i)] =
        scene.weld("arm_" + std::to_string(i + 1), rotor, {.rotation = Rotation::about(2, 6 * i)});
  }
  scene.motor("C", phi);
  return helicopter;
}

/// Blade i = 1 to 4, a thin rectangle turned by `angle` about its span: its operator is the sum of a rod's along the
/// span, which does not feel the pitch and whose parts cancel exactly among the four, and of m w^2/12 across its chord.
inline void add_blade(torsor::Scene& scene, const Helicopter& helicopter, int i, const torsor::Expression& angle) {
  using namespace torsor;
  const auto& [m, s, l, w, alpha, phi, arm] = helicopter;
  const FrameHandle span = arm[static_cast<std::size_t>(i - 1)];
  scene.body("span_" + std::to_string(i), span, Inertia::rod(m, l, 0).at({s + l / 2, 0, 0}));
  const std::string name = "blade_" + std::to_string(i);
  const FrameHandle blade = scene.revolute(name, span, axis::x, angle);
  const Expression across = m * w * w / 12;
  scene.body(name, blade, Inertia::general({.mass = 0, .xx = across, .zz = across}));
}

}  // namespace helicopter_scenes
