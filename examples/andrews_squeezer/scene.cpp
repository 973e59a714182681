// SPDX-License-Identifier: MIT
#include "torsor/generator/torsor.hpp"

/// Andrews' squeezing mechanism (IVP Test Set; Hairer & Wanner, Solving Ordinary Differential Equations II; IFToMM
/// benchmark A03): seven bodies in a plane, three loops that meet in E, one freedom, driven by a constant torque.
/// Coordinates as published: angles of three chains from the ground, and of the bodies they carry.
torsor::Scene andrews_squeezer_scene() {
  using namespace torsor;
  using namespace torsor::literals;
  Scene scene("andrews_squeezer", "Andrews' squeezing mechanism: seven bodies, three loops");

  const auto length = [&](const char* name, const Expression& value) { return scene.parameter(name, "m", value); };
  const Expression d = length("d", 0.028_r), da = length("da", 0.0115_r), e = length("e", 0.02_r);
  const Expression ea = length("ea", 0.01421_r), rr = length("rr", 0.007_r), ra = length("ra", 0.00092_r);
  const Expression ss = length("ss", 0.035_r), sa = length("sa", 0.01874_r), sb = length("sb", 0.01043_r);
  const Expression sc = length("sc", 0.018_r), sd = length("sd", 0.02_r), ta = length("ta", 0.02308_r);
  const Expression tb = length("tb", 0.00916_r), u = length("u", 0.04_r), ua = length("ua", 0.01228_r);
  const Expression ub = length("ub", 0.00449_r), zf = length("zf", 0.02_r), zt = length("zt", 0.04_r);
  const Expression fa = length("fa", 0.01421_r);
  const Expression mom = scene.parameter("mom", "N m", 0.033_r);

  const auto angle = [&](const char* name, const char* start) {
    const Expression q = scene.coordinate(name, "rad");
    scene.initial(q, Expression::quantity(start, "rad"));
    return q;
  };
  const Expression beta = angle("beta", "-0.06171389001427644963589484580009627");
  const Expression Theta = angle("Theta", "0");
  const Expression gamma = angle("gamma", "0.4552798191630703802559123824490657");
  const Expression Phi = angle("Phi", "0.2226683901658858846744731856093545");
  const Expression delta = angle("delta", "0.4873649795438425502255989535298482");
  const Expression Omega = angle("Omega", "-0.2226683901658858846744731856093549");
  const Expression epsilon = angle("epsilon", "1.230547444549821192497350155677741");

  const PointHandle C = scene.point("C", scene.ground(), {length("xc", 0.014_r), length("yc", 0.072_r), 0});
  const Placement A{{length("xa", -0.06934_r), length("ya", -0.00227_r), 0}};
  const Placement B{{length("xb", -0.03635_r), length("yb", 0.03273_r), 0}};
  const FrameHandle K1 = scene.revolute("K1", scene.ground(), axis::z, beta);
  const FrameHandle K2 = scene.revolute("K2", K1, axis::z, Theta, {{rr, 0, 0}});
  const FrameHandle K3 = scene.revolute("K3", scene.ground(), axis::z, gamma, B);
  const FrameHandle K5 = scene.revolute("K5", scene.ground(), axis::z, delta, A);
  const FrameHandle K4 = scene.revolute("K4", K5, axis::z, Phi, {{zt, 0, 0}});
  const FrameHandle K7 = scene.revolute("K7", scene.ground(), axis::z, epsilon, A);
  const FrameHandle K6 = scene.revolute("K6", K7, axis::z, Omega, {{0, -u, 0}});

  const auto body = [&](const std::string& number, const FrameHandle& frame, const Expression& mass,
                        const Expression& inertia, const Triple& center) {
    const Expression m = scene.parameter("m" + number, "kg", mass),
                     I = scene.parameter("I" + number, "kg m^2", inertia);
    scene.body("S" + number, frame, Inertia::general({.mass = m, .zz = I}).at(center));
  };
  body("1", K1, 0.04325_r, 0.000002194_r, {ra, 0, 0});
  body("2", K2, 0.00365_r, 0.000000441_r, {-da, 0, 0});
  body("3", K3, 0.02373_r, 0.000005255_r, {sb, -sa, 0});
  body("4", K4, 0.00706_r, 0.0000005667_r, {0, ea - e, 0});
  body("5", K5, 0.0705_r, 0.00001169_r, {ta, tb, 0});
  body("6", K6, 0.00706_r, 0.0000005667_r, {zf - fa, 0, 0});
  body("7", K7, 0.05498_r, 0.00001912_r, {-ub, -ua, 0});

  scene.torque("motor", K1, {0, 0, mom}, scene.ground());
  const PointHandle D = scene.point("D", K3, {sd, -sc, 0});
  const Expression stiffness = scene.parameter("c0", "N/m", 4530);
  scene.spring("spring", {.a = C, .b = D, .stiffness = stiffness, .rest = length("l0", 0.07785_r)});

  const PointHandle E2 = scene.point("E2", K2, {-d, 0, 0}), E3 = scene.point("E3", K3, {0, -ss, 0});
  const PointHandle E4 = scene.point("E4", K4, {0, -e, 0}), E6 = scene.point("E6", K6, {zf, 0, 0});
  scene.point("F", K1, {rr, 0, 0});
  const auto joins = [&](const std::string& name, const PointHandle& other) {
    scene.closure(name + "_x", other, E2, axis::x);
    scene.closure(name + "_y", other, E2, axis::y);
  };
  joins("E3", E3);
  joins("E4", E4);
  joins("E6", E6);
  scene.independent({beta});
  return scene;
}

TORSOR_SCENE(andrews_squeezer_scene)
