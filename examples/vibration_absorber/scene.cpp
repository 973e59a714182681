// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Vibration absorber (Pommier, §6.2.4 and §7.2.2). A machine support slides along x on a spring; its rotor carries an
/// unbalance and turns at constant speed; a simple pendulum hangs from the support. z points down, y completes the
/// frame. The pendulum's centre is d z2 from the pivot, the unbalance R z3.
torsor::Scene vibration_absorber_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("vibration_absorber", "Vibration absorber: unbalanced machine on a spring, with a pendulum");

  const Expression M1 = scene.parameter("M1", "kg", 10);
  const Expression M2 = scene.parameter("M2", "kg", 1);
  const Expression M3 = scene.parameter("M3", "kg", 0.1_r);
  const Expression R = scene.parameter("R", "m", 0.02_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression K = scene.parameter("K", "N/m", 1000);
  const Expression X0 = scene.parameter("X0", "m", 0.1_r);
  // Tuned as they stand: omega^2 = g / d.
  const Expression d = scene.run_time_parameter("d", "m", 0.0981_r);
  const Expression omega = scene.run_time_parameter("omega", "rad/s", 10);

  const Expression X = scene.coordinate("X", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.drive(phi, omega * scene.time());
  scene.initial(X, 0.11_r);
  scene.initial(theta, 0.3_r);

  const FrameHandle support = scene.prismatic("support", scene.ground(), axis::x, X);
  const FrameHandle pendulum = scene.revolute("pendulum", support, axis::y, theta);
  const FrameHandle rotor = scene.revolute("rotor", support, axis::y, phi);
  scene.point("G1", support, {0, 0, 0});
  scene.body("support", support, Inertia::point(M1));
  scene.body("pendulum", pendulum, Inertia::point(M2).at({0, 0, d}));
  scene.body("unbalance", rotor, Inertia::point(M3).at({0, 0, R}));

  scene.gravity({0, 0, g});
  scene.spring("support_spring", X, K, X0);
  return scene;
}

TORSOR_SCENE(vibration_absorber_scene)
