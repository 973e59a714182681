// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// A woodpecker on a sleeve that a spring joins it to slides down a pole. The sleeve is wider than the pole: it jams by
/// friction where it tilts, and the nods of the bird free it. Numbers of Glocker (1995), who takes the tilt as small.
torsor::Scene woodpecker_toy_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("woodpecker_toy", "A woodpecker slides down its pole in jerks");

  const Expression m_sleeve = scene.parameter("m_sleeve", "kg", 0.0003_r);
  const Expression J_sleeve = scene.parameter("J_sleeve", "kg m^2", 5e-9_r);
  const Expression m_bird = scene.parameter("m_bird", "kg", 0.0045_r);
  const Expression J_bird = scene.parameter("J_bird", "kg m^2", 7e-7_r);
  const Expression c = scene.parameter("c", "N m/rad", 0.0056_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression r_pole = scene.parameter("r_pole", "m", 0.0025_r);
  const Expression r_sleeve = scene.parameter("r_sleeve", "m", 0.0031_r);
  const Expression h_sleeve = scene.parameter("h_sleeve", "m", 0.0058_r);
  const Expression l_spring = scene.parameter("l_spring", "m", 0.010_r);
  const Expression l_bird = scene.parameter("l_bird", "m", 0.015_r);
  const Expression l_beak = scene.parameter("l_beak", "m", 0.0201_r);
  const Expression h_beak = scene.parameter("h_beak", "m", 0.02_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.3_r);
  const Expression e = scene.run_time_parameter("e", "1", 0.5_r);

  // The sleeve's centre stays on the pole's axis; both angles are from the level, the bird is on the side of x.
  const Expression z = scene.coordinate("z", "m");
  const Expression phi = scene.coordinate("phi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  scene.initial(z, 0, Expression::quantity("-0.34", "m/s"));
  scene.initial(theta, -0.28_r, Expression::quantity("-7.4", "rad/s"));

  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::z, z);
  const FrameHandle sleeve = scene.revolute("sleeve", slide, {0, -1, 0}, phi);
  const FrameHandle bird = scene.revolute("bird", sleeve, {0, -1, 0}, theta - phi, {.origin = {l_spring, 0, 0}});
  scene.body("sleeve", sleeve, Inertia::general({.mass = m_sleeve, .xx = J_sleeve, .yy = J_sleeve, .zz = J_sleeve}));
  scene.body("bird", bird, Inertia::general({.mass = m_bird, .xx = J_bird, .yy = J_bird, .zz = J_bird}).at({l_bird, 0, 0}));
  scene.spring("spring", theta - phi, c);
  scene.gravity({0, 0, -g});

  // The side of the pole towards the bird; of the sleeve the edges on that side, as the others are as far from the pole.
  const FrameHandle pole = scene.weld("pole", scene.ground(), {.origin = {r_pole, 0, 0}, .rotation = Rotation::about(1, 6)});
  const PointHandle beak = scene.point("beak", bird, {l_bird - l_beak, 0, h_beak});
  const PointHandle lower = scene.point("lower_edge", sleeve, {r_sleeve, 0, -h_sleeve});
  const PointHandle upper = scene.point("upper_edge", sleeve, {r_sleeve, 0, h_sleeve});
  scene.contact("peck", shape::Point{.point = beak}, shape::Plane{.frame = pole}, {.friction = f, .restitution = e});
  scene.contact("low", shape::Point{.point = lower}, shape::Plane{.frame = pole}, {.friction = f});
  scene.contact("high", shape::Point{.point = upper}, shape::Plane{.frame = pole}, {.friction = f});

  const Expression thin = r_pole / 4;
  scene.show({.frame = scene.ground(), .form = form::Cylinder{r_pole, 14 * h_sleeve}, .placement = {{0, 0, -4 * h_sleeve}}});
  scene.show({.frame = sleeve, .form = form::Cylinder{r_sleeve, 2 * h_sleeve}});
  scene.show({.frame = bird, .form = form::Segment{{0, 0, 0}, {l_bird, 0, 0}, thin}});
  scene.show({.frame = bird, .form = form::Sphere{l_bird / 2}, .placement = {{l_bird, 0, 0}}});
  scene.show({.frame = bird, .form = form::Segment{{l_bird, 0, 0}, {l_bird - l_beak, 0, h_beak}, 2 * thin}});
  return scene;
}

TORSOR_SCENE(woodpecker_toy_scene)
