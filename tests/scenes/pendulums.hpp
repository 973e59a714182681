// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "tests/scenes/bodies.hpp"

namespace torsor::testing_mechanisms {

/// Point mass of 2 kg at the end of a rod of 3/2 m, theta from the downward vertical, gravity 981/100 along -y.
inline Scene pendulum() {
  Scene scene("pendulum");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, theta);
  scene.body("bob", arm, Inertia::point(kilograms("2")).at({0, metres("-1.5"), 0}));
  scene.gravity({0, quantity("-9.81", "m/s^2"), 0});
  return scene;
}

/// The same with parameters and a motor, let go at 1/2 rad.
inline Scene pendulum_with_motor() {
  Scene scene("pendulum", "Pendulum with a motor");
  const Expression mass = scene.parameter("mass", "kg", 2);
  const Expression length = scene.run_time_parameter("length", "m", metres("1.5"));
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, theta);
  scene.body("bob", arm, Inertia::point(mass).at({0, -length, 0}));
  scene.gravity({0, quantity("-9.81", "m/s^2"), 0});
  scene.motor("torque", theta);
  scene.initial(theta, Expression(Number::rational(1, 2)));
  return scene;
}

/// What the angle of the second rod is measured from.
enum class Angle { of_the_joint, absolute };

/// Two point masses on rods in a plane; angles from the downward vertical.
struct DoublePendulum {
  Angle second = Angle::absolute;
  std::array<Expression, 2> masses{1, 1}, lengths{1, 1};  ///< in kg and m
  bool at_run_time = false;                               ///< masses and lengths
};
inline Scene double_pendulum(const DoublePendulum& given) {
  Scene scene("double_pendulum");
  const auto parameter = [&](const char* name, const char* unit, const Expression& value) {
    return given.at_run_time ? scene.run_time_parameter(name, unit, value) : scene.parameter(name, unit, value);
  };
  const Expression m_1 = parameter("m_1", "kg", given.masses[0]), m_2 = parameter("m_2", "kg", given.masses[1]);
  const Expression l_1 = parameter("l_1", "m", given.lengths[0]), l_2 = parameter("l_2", "m", given.lengths[1]);
  const Expression g = scene.parameter("g", "m/s^2", 9.81);
  const Expression theta_1 = scene.coordinate("theta_1", "rad"), theta_2 = scene.coordinate("theta_2", "rad");
  const FrameHandle upper = scene.revolute("upper", scene.ground(), axis::z, theta_1);
  const Expression turn = given.second == Angle::absolute ? theta_2 - theta_1 : theta_2;
  const FrameHandle lower = scene.revolute("lower", upper, axis::z, turn, {.origin = {0, -l_1, 0}});
  scene.body("first", upper, Inertia::point(m_1).at({0, -l_1, 0}));
  scene.body("second", lower, Inertia::point(m_2).at({0, -l_2, 0}));
  scene.gravity({0, -g, 0});
  return scene;
}

}  // namespace torsor::testing_mechanisms
