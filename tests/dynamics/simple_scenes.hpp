// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/dynamics/equations/equations.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::testing_mechanisms {

/// State of a scene by name; what is not named is zero, parameters stand at their values.
class NamedState {
 public:
  NamedState(const Equations& equations, testing_symbols::Point point)
      : evaluate_(equations.program(), [point = std::move(point)](const SymbolPointer& symbol) {
          if (symbol->kind == SymbolKind::pi) return Real::pi();
          const auto place = point.find(symbol->name);
          return place == point.end() ? Real(0) : place->second;
        }) {}
  Real operator()(const Value& value) { return evaluate_(value); }
  double in_double(const Value& value) { return evaluate_(value).to_double(); }

 private:
  Evaluator<Real> evaluate_;
};

inline Expression kilograms(const char* value) { return Expression::quantity(value, "kg"); }
inline Expression metres(const char* value) { return Expression::quantity(value, "m"); }

/// Point mass of 2 kg at the end of a rod of 3/2 m, theta from the downward vertical, gravity 981/100 along -y.
inline Scene pendulum() {
  Scene scene("pendulum");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, theta);
  scene.body("bob", arm, Inertia::point(kilograms("2")).at({0, metres("-1.5"), 0}));
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  return scene;
}

/// A body of the moments 1, 2, 3 kg m² turning about its centre of mass, placed by the unit quaternion e.
inline Scene torque_free_body() {
  Scene scene("torque_free_body");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle body = scene.spherical("body", scene.ground(), e);
  const auto moment = [](const char* value) { return Expression::quantity(value, "kg m^2"); };
  scene.body("body", body,
             Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("2"), .zz = moment("3")}));
  return scene;
}

}  // namespace torsor::testing_mechanisms
