// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>

#include "torsor/generator/torsor.hpp"

namespace four_wheel_vehicle_scenes {

/// Four-wheel vehicle (Pommier, 8.1 exercise 4). The chassis S moves in the plane, its centre C at (x, y), turned by
/// psi; O1 = (a, b), O2 = (-a, b), O3 = (-a, -b), O4 = (a, -b) in its axes: it drives along its y. The wheel i is
/// steered by the constant angle alpha_i about the vertical, turns by phi_i about its axis (Oi, x_i) and touches the
/// ground at Pi.
struct Vehicle {
  std::array<torsor::Expression, 4> alpha, phi;
  std::array<torsor::FrameHandle, 4> steered, wheel;
  std::array<torsor::PointHandle, 4> P;
};

/// As the angles stand, the axes of the wheels meet at (b + b sqrt(3), -b): pi/4 and pi/6 in front, rear wheels
/// straight, a = b (sqrt(3) - 1).
/// With `sliding` wheels each may slide by s_i along its axis, so that the vehicle moves whatever the steering.
inline Vehicle add_vehicle(torsor::Scene& scene, bool sliding) {
  using namespace torsor;
  using namespace torsor::literals;
  const Expression b = scene.parameter("b", "m", 1);
  const Expression a = scene.parameter("a", "m", b * (sqrt(Expression(3)) - 1));
  const Expression r = scene.parameter("r", "m", 0.3_r);
  const Expression M = scene.parameter("M", "kg", 800);
  const Expression J = scene.parameter("J", "kg m^2", 900);  // of the chassis about the vertical through C
  const Expression m = scene.parameter("m", "kg", 20);       // of a wheel, and its moments: A across, C about its axis
  const Expression A = scene.parameter("A", "kg m^2", 0.5_r);
  const Expression C = scene.parameter("C", "kg m^2", 0.9_r);

  Vehicle vehicle;
  const std::array<Expression, 4> angles{-pi() / 4, -pi() / 6, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string name = "alpha_" + std::to_string(i + 1);
    // Steered otherwise, wheels that do not slide leave no motion: two conditions would no longer repeat the others.
    vehicle.alpha[i] =
        sliding ? scene.run_time_parameter(name, "rad", angles[i]) : scene.parameter(name, "rad", angles[i]);
  }
  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression psi = scene.coordinate("psi", "rad");
  // Turns about the point where the axes meet, at 1 rad/s to the right.
  const Expression rate = Expression::quantity("-1", "rad/s");
  const Expression I_x = b * (1 + sqrt(Expression(3))), I_y = -b;
  scene.initial(x, 0, rate * I_y);
  scene.initial(y, 0, -rate * I_x);
  scene.initial(psi, 0, rate);

  const FrameHandle S = scene.planar("S", scene.ground(), {.x = x, .y = y, .angle = psi}, {.origin = {0, 0, r}});
  scene.body("chassis", S, Inertia::general({.mass = M, .zz = J}));
  const std::array<std::array<Expression, 2>, 4> O{{{a, b}, {-a, b}, {-a, -b}, {a, -b}}};
  for (std::size_t i = 0; i < 4; ++i) vehicle.phi[i] = scene.coordinate("phi_" + std::to_string(i + 1), "rad");
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i + 1);
    vehicle.steered[i] =
        scene.revolute("steered_" + number, S, axis::z, vehicle.alpha[i], {.origin = {O[i][0], O[i][1], 0}});
    if (sliding) {
      const Expression s = scene.coordinate("s_" + number, "m");
      vehicle.steered[i] = scene.prismatic("axle_" + number, vehicle.steered[i], axis::x, s);
    }
    vehicle.wheel[i] = scene.revolute("wheel_" + number, vehicle.steered[i], axis::x, vehicle.phi[i]);
    scene.body("wheel_" + number, vehicle.wheel[i], Inertia::general({.mass = m, .xx = C, .yy = A, .zz = A}));
    vehicle.P[i] = scene.point("P" + number, vehicle.steered[i], {0, 0, -r});
    // V(Pi) . y_i = V(Oi) . y_i + r phi_i' = 0.
    const Expression along_x = rate * (I_y - O[i][1]), along_y = rate * (O[i][0] - I_x);
    const Expression forwards = -sin(angles[i]) * along_x + cos(angles[i]) * along_y;
    scene.initial(vehicle.phi[i], 0, -forwards / r);
  }
  return vehicle;
}

}  // namespace four_wheel_vehicle_scenes
