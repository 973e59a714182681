// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>

#include "tests/scenes/pendulums.hpp"

namespace torsor::testing_mechanisms {

/// x along the old z, for joints whose axis x is to lie along z.
inline Placement x_along_z(const Triple& origin) { return {origin, Rotation::about(1, -6)}; }

/// Four links without mass in a plane, revolute joints along z, their lengths in metres.
struct LinkLengths { int crank, coupler, rocker, ground; };
inline Scene four_links(const LinkLengths& lengths, const std::array<Expression, 3>& angles) {
  Scene scene("four_links");
  const auto metre = [](int n) { return Expression::quantity(Number(n), units::metre); };
  std::array<Expression, 3> q;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = scene.coordinate("theta_" + std::to_string(i + 1), "rad");
    scene.initial(q[i], angles[i]);
  }
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, q[0]);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, q[1], {{metre(lengths.crank), 0, 0}, {}});
  const FrameHandle rocker =
      scene.revolute("rocker", scene.ground(), axis::z, q[2], {{metre(lengths.ground), 0, 0}, {}});
  const FrameHandle end = scene.weld("coupler_end", coupler, x_along_z({metre(lengths.coupler), 0, 0}));
  const FrameHandle rocker_end = scene.weld("rocker_end", rocker, x_along_z({metre(lengths.rocker), 0, 0}));
  scene.loop_joint("knee", {.type = JointType::revolute, .a = end, .b = rocker_end});
  return scene;
}

/// Crank, coupler and rocker of 1, 2 and 3/2 m, rods of 1, 2 and 3/2 kg, over a base of 2 m, gravity in their plane.
/// The start is that of the closed loop, to fifteen digits: the triangle over the crank by the cosine rule.
struct FourBar {
  Scene scene;
  Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  FrameHandle coupler = scene.revolute("coupler", crank, axis::z, b, {{metres("1"), 0, 0}});
  FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {{metres("2"), 0, 0}});

  explicit FourBar(const std::string& name) : scene(name) {
    scene.body("crank", crank, Inertia::rod(kilograms("1"), metres("1"), 0).at({metres("0.5"), 0, 0}));
    scene.body("coupler", coupler, Inertia::rod(kilograms("2"), metres("2"), 0).at({metres("1"), 0, 0}));
    scene.body("rocker", rocker, Inertia::rod(kilograms("1.5"), metres("1.5"), 0).at({metres("0.75"), 0, 0}));
    scene.gravity({0, quantity("-9.81", "m/s^2"), 0});
    scene.initial(a, 1);
    scene.initial(b, quantity("-0.701107141659005", "rad"));
    scene.initial(c, quantity("1.264965395965706", "rad"));
  }
  /// By two conditions in the plane.
  void close() {
    const PointHandle tip = scene.point("tip", coupler, {metres("2"), 0, 0});
    const PointHandle end = scene.point("end", rocker, {metres("1.5"), 0, 0});
    scene.closure("x", tip, end, axis::x);
    scene.closure("y", tip, end, axis::y);
  }
  /// Frames at the ends of coupler and rocker whose x is along the pin.
  std::pair<FrameHandle, FrameHandle> ends() {
    return {scene.weld("tip", coupler, x_along_z({metres("2"), 0, 0})),
            scene.weld("end", rocker, x_along_z({metres("1.5"), 0, 0}))};
  }
};

/// Cranks of length 1 from pivots 2 apart and a coupler of length 2, at rest with the cranks turned by `start`.
inline Scene parallelogram(Angle of_coupler, const Expression& start) {
  Scene scene("parallelogram");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const bool absolute = of_coupler == Angle::absolute;
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, absolute ? b - a : b, {{metres("1"), 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {{metres("2"), 0, 0}});
  for (const FrameHandle& frame : {crank, coupler, rocker}) {
    scene.body("s" + std::to_string(frame.index), frame, Inertia::rod(kilograms("1"), metres("1"), 0));
  }
  scene.initial(a, start);
  scene.initial(b, absolute ? 0 : -start);
  scene.initial(c, start);
  const PointHandle tip = scene.point("tip", coupler, {metres("2"), 0, 0});
  const PointHandle end = scene.point("end", rocker, {metres("1"), 0, 0});
  scene.closure("x", tip, end, axis::x);
  scene.closure("y", tip, end, axis::y);
  return scene;
}

/// Bennett's linkage: four skew revolute axes, opposite links alike, lengths a and b, twists α and β with
/// a / sin α = b / sin β: 1 m and 30°, 2 m and 90°. It moves although 4 − 6 freedoms are left by counting.
inline Scene bennett(const std::array<Expression, 3>& start = {pi() / Expression(2), Expression(2) * pi() / Expression(3),
                                                               -pi() / Expression(2)}) {
  Scene scene("bennett");
  const Placement along_a{{metres("1"), 0, 0}, Rotation::about(0, 2)},
      along_b{{metres("2"), 0, 0}, Rotation::about(0, 6)};
  // tan(θ1/2) tan(θ2/2) = sin((β + α)/2) / sin((β − α)/2) = √3.
  std::array<Expression, 3> q;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = scene.coordinate("theta_" + std::to_string(i + 1), "rad");
    scene.initial(q[i], start[i]);
  }
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, q[0]);
  const FrameHandle second = scene.revolute("second", first, axis::z, q[1], along_a);
  const FrameHandle third = scene.revolute("third", second, axis::z, q[2], along_b);
  const FrameHandle end = scene.weld("end", third, along_a);
  // The ground is the fourth link: from the last axis along x by b, and turned by β, lies the first one.
  const Rotation back = Rotation::about(0, 6).transpose();
  const FrameHandle last_axis = scene.weld("last_axis", scene.ground(), {{-metres("2"), 0, 0}, back});
  const FrameHandle end_x = scene.weld("end_x", end, x_along_z({0, 0, 0}));
  const FrameHandle last_x = scene.weld("last_x", last_axis, x_along_z({0, 0, 0}));
  scene.loop_joint("last", {.type = JointType::revolute, .a = last_x, .b = end_x});
  return scene;
}

/// Elsewhere, as a user states it: closed to the digits of a double.
inline Scene bennett_in_digits() {
  const auto angle = [](const char* number) { return Expression::quantity(number, "rad"); };
  return bennett({angle("0.7"), angle("2.7261731790164174"), angle("-0.7")});
}

/// Sarrus' linkage: two chains of three parallel revolute joints, along y and along x, guide a plate straight up.
inline Scene sarrus() {
  Scene scene("sarrus");
  const Expression third = pi() / Expression(3);
  const auto angle = [&scene](const std::string& name, const Expression& start) {
    const Expression q = scene.coordinate(name, "rad");
    scene.initial(q, start);
    return q;
  };
  const Triple two_x{metres("2"), 0, 0}, two_y{0, metres("2"), 0};
  const Expression a_1 = angle("a_1", -third), a_2 = angle("a_2", -third), a_3 = angle("a_3", Expression(2) * third);
  const FrameHandle A_1 = scene.revolute("A_1", scene.ground(), axis::y, a_1, {two_x, {}});
  const FrameHandle A_2 = scene.revolute("A_2", A_1, axis::y, a_2, {two_x, {}});
  const FrameHandle plate = scene.revolute("plate", A_2, axis::y, a_3, {two_x, {}});
  const Expression b_1 = angle("b_1", third), b_2 = angle("b_2", third);
  const FrameHandle B_1 = scene.revolute("B_1", scene.ground(), axis::x, b_1, {two_y, {}});
  const FrameHandle B_2 = scene.revolute("B_2", B_1, axis::x, b_2, {two_y, {}});
  const FrameHandle end = scene.weld("B_end", B_2, {two_y, {}});
  const FrameHandle corner = scene.weld("corner", plate, {{metres("-2"), metres("2"), 0}, {}});
  scene.loop_joint("hinge", {.type = JointType::revolute, .a = corner, .b = end});
  return scene;
}

/// Slider-crank without a redundant condition: revolute crank, spherical crank pin, revolute gudgeon pin, cylindrical
/// piston: 1 + 3 + 1 + 2 freedoms, six conditions. At rest with the crank straight up.
inline Scene isostatic_slider_crank() {
  Scene scene("slider_crank");
  const auto coordinate = [&scene](const std::string& name, const std::string& unit, const Expression& start = 0) {
    const Expression q = scene.coordinate(name, unit);
    scene.initial(q, start);
    return q;
  };
  const Expression theta = coordinate("theta", "rad", pi() / Expression(2));
  const Expression s = coordinate("s", "m", 4), turn = coordinate("turn", "rad");
  const Expression pin = coordinate("pin", "rad", 0.6);
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, theta);
  const FrameHandle piston =
      scene.cylindrical("piston", scene.ground(), {.axis = axis::x, .displacement = s, .angle = turn});
  const FrameHandle rod = scene.revolute("rod", piston, axis::z, pin);
  const FrameHandle crank_end = scene.weld("crank_end", crank, {{metres("3"), 0, 0}, {}});
  const FrameHandle rod_end = scene.weld("rod_end", rod, {{metres("-5"), 0, 0}, {}});
  scene.loop_joint("crank_pin", {.type = JointType::spherical, .a = crank_end, .b = rod_end});
  return scene;
}

/// Support on a slide, with a pendulum and a driven rotor on it: an open chain.
inline Scene absorber() {
  Scene scene("absorber");
  const Expression X = scene.coordinate("X", "m"), theta = scene.coordinate("theta", "rad");
  const Expression phi = scene.coordinate("phi", "rad");
  scene.drive(phi, scene.parameter("omega", "rad/s") * scene.time());
  const FrameHandle support = scene.prismatic("support", scene.ground(), axis::x, X);
  scene.revolute("pendulum", support, axis::y, theta);
  scene.revolute("rotor", support, axis::y, phi);
  return scene;
}

}  // namespace torsor::testing_mechanisms
