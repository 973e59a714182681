// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Plate of any shape with its straight edge AB on a smooth level plane (Pommier, 8.3.2 exercise 1). alpha turns it
/// about the vertical, beta about its edge: beta is the angle of its plane with the ground (of its normal z with z_g);
/// the centre of mass is at HG = b y from the edge, at the height b sin(beta). x and y are the horizontal coordinates
/// of G. The released coordinates lift the edge off the plane, and tilt it: the reactions are the force N of the plane
/// and its moment about the horizontal through H normal to AB. As it stands, a right-angled triangle, its right angle
/// at A.
torsor::Scene falling_plate_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("falling_plate", "A plate falls with its edge on a smooth plane");

  const Expression M = scene.parameter("M", "kg", 1);
  const Expression edge = scene.parameter("edge", "m", 0.6_r);      // AB
  const Expression height = scene.parameter("height", "m", 0.9_r);  // of the triangle
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression b = scene.run_time_parameter("b", "m", height / 3);
  // Inertia operator at G in the plate's axes: [A F 0; F B 0; 0 0 A+B], A and B the integrals of y² and x², F that of
  // -x y, counted from G.
  const Expression A = scene.run_time_parameter("A", "kg m^2", M * height * height / 18);
  const Expression B = scene.run_time_parameter("B", "kg m^2", M * edge * edge / 18);
  const Expression F = scene.run_time_parameter("F", "kg m^2", M * edge * height / 36);

  const Expression x = scene.coordinate("x", "m");
  const Expression y = scene.coordinate("y", "m");
  const Expression alpha = scene.coordinate("alpha", "rad");
  const Expression beta = scene.coordinate("beta", "rad");
  const Expression N = scene.released_coordinate("N", "m");
  const Expression moment = scene.released_coordinate("moment", "rad");
  scene.initial(beta, 1.4_r);

  const FrameHandle along_x = scene.prismatic("along_x", scene.ground(), axis::x, x);
  const FrameHandle along_y = scene.prismatic("along_y", along_x, axis::y, y);
  const FrameHandle lift = scene.prismatic("lift", along_y, axis::z, N);
  const FrameHandle turned = scene.revolute("turned", lift, axis::z, alpha);
  // The foot H of G on the plane's edge: -b cos(beta) along the horizontal normal to the edge.
  const FrameHandle foot = scene.prismatic("foot", turned, axis::y, -b * cos(beta));
  const FrameHandle tilted = scene.revolute("tilted", foot, axis::y, moment);
  const FrameHandle plate = scene.revolute("plate", tilted, axis::x, beta);
  scene.body("plate", plate, Inertia::general({.mass = M, .xx = A, .yy = B, .zz = A + B, .xy = F}).at({0, b, 0}));
  scene.gravity({0, 0, -g});
  // For pictures: the plate's edges. The right angle is at A.
  const Triple at_A{-edge / 3, 0, 0}, at_B{2 * edge / 3, 0, 0}, top{-edge / 3, height, 0};
  for (const auto& [from, to] : {std::pair{at_A, at_B}, std::pair{at_B, top}, std::pair{top, at_A}}) {
    scene.show({.frame = plate, .form = form::Segment{from, to, edge / 60}});
  }
  return scene;
}

TORSOR_SCENE(falling_plate_scene)
