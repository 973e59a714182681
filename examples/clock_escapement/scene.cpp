// SPDX-License-Identifier: MIT
#include <string>

#include "torsor/generator/torsor.hpp"

/// A clock with a recoil escapement. A weight on a cord drives a wheel with round pins, and an anchor on the pendulum
/// carries two round pallets. Each pin that pushes a pallet out of its way gives the pendulum some energy, until it
/// comes free and another pin falls onto the other pallet, without restitution. The cord counts as tight.
torsor::Scene clock_escapement_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("clock_escapement", "A weight, a wheel of pins, an anchor and a pendulum: a clock");
  constexpr int pins = 10;

  const Expression R = scene.parameter("R", "m", 0.03_r);
  const Expression r_pin = scene.parameter("r_pin", "m", 0.0016_r);
  const Expression r_pallet = scene.parameter("r_pallet", "m", 0.005_r);
  // How far the pallets' centres are outside the circle of the pins' while the pendulum is upright.
  const Expression clear = scene.parameter("clear", "m", 0.0046_r);
  const Expression r_drum = scene.parameter("r_drum", "m", 0.0015_r);
  const Expression m_wheel = scene.parameter("m_wheel", "kg", 0.01_r);
  const Expression J_wheel = scene.parameter("J_wheel", "kg m^2", 5e-6_r);
  const Expression l = scene.parameter("l", "m", 0.25_r);
  const Expression m_bob = scene.parameter("m_bob", "kg", 0.2_r);
  const Expression d = scene.parameter("d", "N m s/rad", 0.0015_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression weight = scene.run_time_parameter("weight", "kg", 0.1_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.1_r);

  // Both turn clockwise for who looks along y, as hands of a clock do.
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  scene.initial(psi, -pi() / 36);
  scene.initial(theta, 0.12_r);

  const FrameHandle wheel = scene.revolute("wheel", scene.ground(), axis::y, psi);
  const FrameHandle hung =
      scene.prismatic("hung", scene.ground(), axis::z, -r_drum * psi, {.origin = {r_drum, 0, -2 * R}});
  // The pivot is where tangents at 45 degrees on both sides of the wheel's top meet, so that pallets move along its
  // radii.
  const FrameHandle anchor = scene.revolute("anchor", scene.ground(), axis::y, theta, {.origin = {0, 0, sqrt(2) * R}});
  scene.body("wheel", wheel, Inertia::general({.mass = m_wheel, .xx = J_wheel, .yy = J_wheel, .zz = J_wheel}));
  scene.body("weight", hung, Inertia::point(weight));
  scene.body("bob", anchor, Inertia::point(m_bob).at({0, 0, -l}));
  scene.damper("air", theta, d);
  scene.gravity({0, 0, -g});

  const Expression aside = (R + clear) / sqrt(2), above = aside - sqrt(2) * R;
  const FrameHandle entry = scene.weld("entry", anchor, {.origin = {-aside, 0, above}});
  const FrameHandle exit = scene.weld("exit", anchor, {.origin = {aside, 0, above}});
  for (int i = 0; i < pins; ++i) {
    const std::string number = std::to_string(i + 1);
    const Expression angle = 2 * pi() * i / pins;
    const FrameHandle pin = scene.weld("pin" + number, wheel, {.origin = {R * sin(angle), 0, R * cos(angle)}});
    scene.contact("entry" + number, shape::Sphere{.frame = pin, .radius = r_pin},
                  shape::Sphere{.frame = entry, .radius = r_pallet}, {.friction = f});
    scene.contact("exit" + number, shape::Sphere{.frame = pin, .radius = r_pin},
                  shape::Sphere{.frame = exit, .radius = r_pallet}, {.friction = f});
    scene.show({.frame = wheel, .form = form::Segment{{0, 0, 0}, {R * sin(angle), 0, R * cos(angle)}, r_pin / 2}});
    scene.show({.frame = pin, .form = form::Sphere{r_pin}});
  }
  scene.show({.frame = entry, .form = form::Sphere{r_pallet}});
  scene.show({.frame = exit, .form = form::Sphere{r_pallet}});
  scene.show({.frame = anchor, .form = form::Segment{{0, 0, 0}, {-aside, 0, above}, r_pin}});
  scene.show({.frame = anchor, .form = form::Segment{{0, 0, 0}, {aside, 0, above}, r_pin}});
  scene.show({.frame = anchor, .form = form::Segment{{0, 0, 0}, {0, 0, -l}, r_pin / 2}});
  scene.show({.frame = anchor, .form = form::Sphere{4 * r_pallet}, .placement = {{0, 0, -l}}});
  scene.show({.frame = hung, .form = form::Cylinder{2 * r_pallet, 4 * r_pallet}});
  return scene;
}

TORSOR_SCENE(clock_escapement_scene)
