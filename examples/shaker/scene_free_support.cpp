// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// The third case of the spring (Pommier, §6.5.3): nothing holds the cylinder T, the support, any more. Its place H is
/// OH = lambda y, the mass P is at HP = l y, and the spring works between H and P. Seen from the mass alone it gives
/// Q_lambda = Q_l = -k (l - l0), hence dQ_lambda/dl = -k and dQ_l/dlambda = 0: no force function. Of both ends together
/// Q_lambda = 0, and -k (l - l0)²/2 is a force function with a potential energy. A spring between points has the length
/// sqrt(l²): the equations hold on either side of the support.
torsor::Scene shaker_free_support_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("shaker_free_support", "Mass on a spring from a support that moves freely");

  const Expression M = scene.parameter("M", "kg", 1);
  const Expression m_T = scene.parameter("m_T", "kg", 3);  // of the cylinder T
  const Expression k = scene.parameter("k", "N/m", 400);
  const Expression l0 = scene.parameter("l0", "m", 0.2_r);
  const Expression g = scene.parameter("g", "m/s^2", 9.81_r);

  const Expression lambda = scene.coordinate("lambda", "m");
  const Expression l = scene.coordinate("l", "m");
  // Thrown upwards, the spring stretched by 2 cm.
  scene.initial(lambda, 0, Expression::quantity("5", "m/s"));
  scene.initial(l, 0.22_r);

  const FrameHandle support = scene.prismatic("support", scene.ground(), axis::y, lambda);
  const FrameHandle mass = scene.prismatic("mass", support, axis::y, l);
  scene.body("support", support, Inertia::point(m_T));
  scene.body("mass", mass, Inertia::point(M));
  const PointHandle H = scene.point("H", support, {0, 0, 0});
  const PointHandle P = scene.point("P", mass, {0, 0, 0});
  scene.gravity({0, -g, 0});
  scene.spring("spring", {.a = H, .b = P, .stiffness = k, .rest = l0});
  return scene;
}

TORSOR_SCENE(shaker_free_support_scene)
