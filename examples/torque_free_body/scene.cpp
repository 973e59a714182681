// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Rigid body left to itself, its centre of mass at rest (Euler and Poinsot). Its orientation is a unit quaternion, its
/// velocities are the components of the angular velocity along its own axes: no orientation is singular.
torsor::Scene torque_free_body_scene() {
  using namespace torsor;
  Scene scene("torque_free_body", "Rigid body without any torque");

  const Expression m = scene.parameter("m", "kg", 1);
  const Expression I1 = scene.run_time_parameter("I1", "kg m^2", 1);
  const Expression I2 = scene.run_time_parameter("I2", "kg m^2", 2);
  const Expression I3 = scene.run_time_parameter("I3", "kg m^2", 3);

  const AttitudeHandle e = scene.attitude("e");
  const Expression rate = Expression::quantity("1", "rad/s");
  scene.initial(e, {1, 0, 0, 0}, {rate, 0, rate});

  const FrameHandle body = scene.spherical("body", scene.ground(), e);
  scene.body("body", body, Inertia::general({.mass = m, .xx = I1, .yy = I2, .zz = I3}));
  return scene;
}

TORSOR_SCENE(torque_free_body_scene)
