// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "torsor/generator/torsor.hpp"

/// Half an aircraft in symmetric flight (Pommier, §1, example 1): the fuselage heaves by z; the wing is four rigid
/// panels in a row along y, joined to it and to one another by elastic hinges about x, beta_1 to beta_4 from panel to
/// panel; the engine hangs by an elastic hinge, too, under the end of the first panel, turned by gamma from it.
/// Everything is counted from steady flight: weight and the lift that bears it are left out, and a gust adds a force at
/// the middle of each panel.
torsor::Scene elastic_wing_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("elastic_wing", "Half an aircraft with an elastic wing and an engine");
  constexpr int panels = 4;

  const Expression m_fuselage = scene.parameter("m_fuselage", "kg", 15700);
  const Expression m_engine = scene.parameter("m_engine", "kg", 2000);
  const Expression length = scene.parameter("length", "m", 4);  // of a panel
  const Expression hang = scene.parameter("hang", "m", 1.2_r);  // of the engine below its hinge
  const Expression J_engine = scene.parameter("J_engine", "kg m^2", 700);
  const Expression k_engine = scene.parameter("k_engine", "N m", 600000);
  const Expression delay = scene.parameter("delay", "s", Expression::quantity("0.002", "s"));  // c = delay k
  const Expression gust = scene.run_time_parameter("gust", "N", 10000);  // more lift of each panel
  std::vector<Expression> mass, stiffness;
  constexpr int masses[panels] = {1300, 800, 450, 250};
  constexpr int stiffnesses[panels] = {30000000, 14000000, 6000000, 2500000};
  for (int i = 0; i < panels; ++i) {
    const std::string number = std::to_string(i + 1);
    mass.push_back(scene.parameter("m_" + number, "kg", masses[i]));
    stiffness.push_back(scene.parameter("k_" + number, "N m", stiffnesses[i]));
  }

  const Expression z = scene.coordinate("z", "m");
  std::vector<Expression> beta;
  for (int i = 0; i < panels; ++i) beta.push_back(scene.coordinate("beta_" + std::to_string(i + 1), "rad"));
  const Expression gamma = scene.coordinate("gamma", "rad");

  const FrameHandle fuselage = scene.prismatic("fuselage", scene.ground(), axis::z, z);
  scene.body("fuselage", fuselage, Inertia::point(m_fuselage));
  std::vector<FrameHandle> wing;
  FrameHandle before = fuselage;
  for (int i = 0; i < panels; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const std::string number = std::to_string(i + 1);
    const Placement end{.origin = {0, i == 0 ? Expression(0) : length, 0}};
    const FrameHandle panel = scene.revolute("panel_" + number, before, axis::x, beta[at], end);
    // A thin panel in a plane motion: a rod along y.
    scene.body("panel_" + number, panel, Inertia::rod(mass[at], length, 1).at({0, length / 2, 0}));
    const PointHandle middle = scene.point("middle_" + number, panel, {0, length / 2, 0});
    scene.force("gust_" + number, {.body = panel, .point = middle, .components = {0, 0, gust}, .axes = scene.ground()});
    scene.spring("hinge_" + number, beta[at], stiffness[at]);
    scene.damper("friction_" + number, beta[at], delay * stiffness[at]);
    wing.push_back(panel);
    before = panel;
  }
  scene.point("tip", before, {0, length, 0});
  const FrameHandle engine = scene.revolute("engine", wing[0], axis::x, gamma, {.origin = {0, length, 0}});
  scene.body("engine", engine, Inertia::general({.mass = m_engine, .xx = J_engine}).at({0, 0, -hang}));
  scene.spring("pylon", gamma, k_engine);
  scene.damper("pylon_friction", gamma, delay * k_engine);
  return scene;
}

TORSOR_SCENE(elastic_wing_scene)
