// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Stiff flyball governor (IFToMM benchmark A05). The shaft turns freely about the vertical z0 by psi; a slider runs on
/// it, its centre s above the base. Two rods are hinged about the shaft's y at +-x from its top and hang outwards,
/// beta_1 and beta_2 below the horizontal, a ball at the end of each. A spring and a damper, both stiff, tie the middle
/// of each rod to the slider.
torsor::Scene flyball_governor_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("flyball_governor", "Stiff flyball governor (IFToMM benchmark A05)");

  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);
  const Expression density = scene.parameter("density", "kg/m^3", 3000);
  const Expression length = scene.parameter("length", "m", 1);     // of the shaft and of each rod
  const Expression width = scene.parameter("width", "m", 0.01_r);  // of their square sections
  const Expression edge = scene.parameter("edge", "m", 0.1_r);     // of the slider, a cube
  const Expression m_ball = scene.parameter("m_ball", "kg", 5);
  const Expression k = scene.parameter("k", "N/m", 800000);
  const Expression c = scene.parameter("c", "N s/m", 40000);
  const Expression rest = scene.parameter("rest", "m", 0.5_r);
  const Expression m_rod = density * length * width * width;  // and of the shaft
  const Expression m_slider = density * pow(edge, 3);

  const Expression psi = scene.coordinate("psi", "rad");
  const Expression s = scene.coordinate("s", "m");
  const Expression beta_1 = scene.coordinate("beta_1", "rad");
  const Expression beta_2 = scene.coordinate("beta_2", "rad");
  scene.initial(psi, 0, 2 * pi() * Expression::quantity("1", "rad/s"));
  scene.initial(s, length / 2);
  scene.initial(beta_1, pi() / 6);
  scene.initial(beta_2, pi() / 6);

  const FrameHandle shaft = scene.revolute("shaft", scene.ground(), axis::z, psi);
  const FrameHandle slider = scene.prismatic("slider", shaft, axis::z, s);
  scene.body("shaft", shaft, Inertia::box(m_rod, width, width, length).at({0, 0, length / 2}));
  scene.body("slider", slider, Inertia::box(m_slider, edge, edge, edge));
  // Rod 1 points along +x of its frame, rod 2 along -x: a positive angle lowers the end of either.
  const auto arm = [&](const std::string& number, const Expression& side, const Triple& hinge, const Expression& beta) {
    const FrameHandle rod =
        scene.revolute("rod_" + number, shaft, hinge, beta, {.origin = {side * edge / 2, 0, length}});
    scene.body("rod_" + number, rod, Inertia::box(m_rod, length, width, width).at({side * length / 2, 0, 0}));
    scene.body("ball_" + number, rod, Inertia::point(m_ball).at({side * length, 0, 0}));
    const PointHandle middle = scene.point("middle_" + number, rod, {side * length / 2, 0, 0});
    const PointHandle ear = scene.point("ear_" + number, slider, {side * edge / 2, 0, 0});
    scene.spring("spring_" + number, {.a = middle, .b = ear, .stiffness = k, .rest = rest});
    scene.damper("damper_" + number, middle, ear, c);
  };
  arm("1", 1, axis::y, beta_1);
  arm("2", -1, {0, -1, 0}, beta_2);
  scene.gravity({0, 0, -g});
  return scene;
}

TORSOR_SCENE(flyball_governor_scene)
