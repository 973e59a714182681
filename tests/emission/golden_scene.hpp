// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_scenes {

/// A pendulum on a pivot that is moved by a law of time, with a motor: small, and yet it has a run-time parameter with
/// and one without a value, folded ones, a driven coordinate, a constant that no exact number is (sin 0.3) and an
/// initial state that depends on a parameter.
inline Scene golden_pendulum() {
  using Q = Expression;
  Scene scene("golden_pendulum", "Pendulum on a moving pivot");
  const Q length = scene.run_time_parameter("length", "m", Q::quantity("0.5", "m"));
  const Q friction = scene.parameter("friction", "N m s");
  const Q mass = scene.parameter("mass", "kg", Q::quantity("2", "kg"));
  const Q gravity = scene.parameter("gravity", "m/s^2", Q::quantity("9.81", "m/s^2"));
  const Q theta = scene.coordinate("theta", "rad");
  const Q pivot = scene.coordinate("pivot", "m");
  const Q frequency = Q::quantity("3", "rad/s");
  scene.drive(pivot, Q::quantity("0.1", "m") * sin(Q(0.3)) * sin(frequency * scene.time()));
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, pivot);
  const FrameHandle arm = scene.revolute("arm", slider, axis::z, theta);
  scene.body("bob", arm, Inertia::point(mass).at({Q(0), -length, Q(0)}));
  scene.gravity({Q(0), -gravity, Q(0)});
  scene.damper("bearing", theta, friction);
  scene.motor("torque", theta);
  scene.initial(theta, length / Q::quantity("2", "m"));
  return scene;
}

}  // namespace torsor::testing_scenes
