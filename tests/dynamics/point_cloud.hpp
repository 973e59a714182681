// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/body_screws.hpp"
#include "torsor/generator/geometry/real_vector.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::testing_mechanisms {

using Column = RealVector;

inline Column columns(Evaluator<Real>& evaluate, const Vector& v) {
  const Real x = evaluate(v[0]);
  const Real y = evaluate(v[1]);
  return {x, y, evaluate(v[2])};
}
inline double distance(const Column& a, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += testing_symbols::relative_difference(a[i], b[i]);
  return sum;
}

inline Vector rates_of(const Vector& v) {
  Vector result;
  for (int i = 0; i < 3; ++i) {
    if (!v[i].is_zero()) result[i] = time_derivative(v[i]);
  }
  return result;
}

/// A body that moves on a carrier which itself moves: a carrier that slides along x and turns about a skew axis, on it
/// a body that turns about y and slides along z. The body's matter is eight points of mass m/8 at center + (±a, ±b,
/// ±c), so that every integral over it is a sum of eight terms. X moves in the carrier; it belongs to no body.
struct BodyOnCarrier {
  BodyOnCarrier() {
    const auto m = [](const char* value) { return Expression::quantity(value, "m"); };
    const Expression q1 = scene.coordinate("q1", "m");
    const Expression q2 = scene.coordinate("q2", "rad");
    const Expression q3 = scene.coordinate("q3", "rad");
    const Expression q4 = scene.coordinate("q4", "m");
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, q1);
    const FrameHandle R = scene.revolute("R", slide, {1, 2, 2}, q2 + q1 / m("3"), {.origin = {m("0.2"), 0, m("-0.1")}});
    const FrameHandle arm = scene.revolute(
        "arm", R, axis::y, q3, {.origin = {m("0.3"), m("0.4"), m("0.1")}, .rotation = Rotation::about(0, 5)});
    const FrameHandle S = scene.prismatic("S", arm, axis::z, q4 + m("0.2") * sin(q3), {.origin = {m("0.5"), 0, 0}});
    for (const char* name : {"x", "y", "z"}) frozen.push_back(scene.parameter(std::string("frozen_") + name, "m"));
    const Expression mass = Expression::quantity("2.5", "kg");
    const Expression a = m("0.2"), b = m("0.3"), c = m("0.5");
    const Inertia cloud = Inertia::general({.mass = mass, .xx = mass * (b * b + c * c), .yy = mass * (a * a + c * c),
                                            .zz = mass * (a * a + b * b)});
    scene.body("cloud", S, cloud.at({m("0.1"), m("-0.2"), m("0.4")}));
    scene.body("weight", R, Inertia::point(Expression::quantity("0.7", "kg")).at({m("0.6"), 0, m("0.2")}));
    scene.point("X", R, {q4 + m("0.3"), m("0.2") * cos(q3), q1 - q4});
    scene.point("E", scene.ground(), {m("0.4"), m("-0.3"), m("0.9")});
  }

  /// The eight points in the axes of the body's link; that link is `S` itself.
  static std::vector<Vector> points(Program& program) {
    std::vector<Vector> all;
    for (int k = 0; k < 8; ++k) {
      const auto place = [&](long center, long half, bool positive) {
        return program.number(Number::rational(positive ? center + half : center - half, 10), units::metre);
      };
      all.emplace_back(place(1, 2, (k & 1) != 0), place(-2, 3, (k & 2) != 0), place(4, 5, (k & 4) != 0));
    }
    return all;
  }
  static Real mass_of_point() { return testing_symbols::rational(5, 16); }

  Scene scene{"body_on_carrier"};
  std::vector<Expression> frozen;  ///< a point held in R, for the acceleration of R's own points
};

}  // namespace torsor::testing_mechanisms
