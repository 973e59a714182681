// SPDX-License-Identifier: MIT
#include <string>

#include "torsor/generator/torsor.hpp"

/// A wheel of six spokes and no rim walks down a slope: each spoke in turn strikes the ground with its foot, without
/// restitution, and the wheel turns about it until the next one strikes (McGeer 1990).
torsor::Scene rimless_wheel_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("rimless_wheel", "Rimless wheel that walks down a slope");
  constexpr int spokes = 6;

  const Expression l = scene.parameter("l", "m", 1);
  const Expression m = scene.parameter("m", "kg", 2);
  const Expression J = scene.parameter("J", "kg m^2", 0.5_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression slope = scene.run_time_parameter("slope", "rad", 0.15_r);
  const Expression f = scene.run_time_parameter("f", "1", 1);

  const Expression x = scene.coordinate("x", "m");
  const Expression z = scene.coordinate("z", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  // Both lowest feet are on the ground; it turns about the one ahead.
  const Expression rate = Expression::quantity("1", "rad/s");
  scene.initial(x, 0, l * cos(pi() / spokes) * rate);
  scene.initial(z, l * cos(pi() / spokes), l * sin(pi() / spokes) * rate);
  scene.initial(phi, 0, rate);

  // x runs down the slope, z is its normal, and the wheel turns from z to x.
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  const FrameHandle wheel = scene.revolute("wheel", lift, axis::y, phi);
  scene.body("wheel", wheel, Inertia::general({.mass = m, .xx = J, .yy = J, .zz = J}));
  scene.gravity({g * sin(slope), 0, -g * cos(slope)});
  for (int i = 0; i < spokes; ++i) {
    const Expression angle = pi() * (2 * i + 1) / spokes;
    const PointHandle foot = scene.point("foot" + std::to_string(i + 1), wheel, {-l * sin(angle), 0, -l * cos(angle)});
    scene.contact("step" + std::to_string(i + 1), shape::Point{.point = foot}, shape::Plane{.frame = scene.ground()},
                  {.friction = f});
    scene.show({.frame = wheel, .form = form::Segment{{0, 0, 0}, {-l * sin(angle), 0, -l * cos(angle)}, l / 50}});
  }
  return scene;
}

TORSOR_SCENE(rimless_wheel_scene)
