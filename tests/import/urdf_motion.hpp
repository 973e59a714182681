// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor::testing_urdf {

/// A robot of that name around some links and joints.
inline std::string robot(const std::string& body) { return "<robot name=\"machine\">" + body + "</robot>"; }

inline Scene read(const std::string& body, const UrdfOptions& options = {}) {
  return read_urdf_text(robot(body), "machine.urdf", options).scene;
}

inline Expression number(const char* decimal, const char* unit = "1") { return Expression::quantity(decimal, unit); }

/// A body without any symmetry, as URDF and as a scene writes it.
inline const char* inertial =
    "<inertial><origin xyz=\"0.02 -0.03 0.05\"/><mass value=\"1.5\"/>"
    "<inertia ixx=\"0.011\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.013\" iyz=\"0.0015\" izz=\"0.009\"/></inertial>";
inline Inertia lump() {
  const auto moment = [](const char* value) { return number(value, "kg m^2"); };
  return Inertia::general({.mass = number("1.5", "kg"), .xx = moment("0.011"), .yy = moment("0.013"),
                           .zz = moment("0.009"), .xy = moment("0.001"), .xz = moment("-0.002"),
                           .yz = moment("0.0015")})
      .at({number("0.02", "m"), number("-0.03", "m"), number("0.05", "m")});
}

inline std::string link(const std::string& name) { return "<link name=\"" + name + "\">" + inertial + "</link>"; }

/// A joint from `parent` to `child`, both by their names.
inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& more) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + more + "</joint>";
}

inline Scene with_weight(Scene scene) {
  scene.gravity({0, 0, number("-9.81", "m/s^2")});
  return scene;
}

using Values = std::map<std::string, std::string>;

/// Accelerations in 50 digits by the freedoms' names, at a state given by name; inputs by name, zero when not given.
inline std::map<std::string, Real> accelerations(const Scene& scene, const Values& q, const Values& v,
                                                 const Values& u = {}) {
  const Equations equations(scene);
  const auto value = [&](const Values& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? Real(0) : Real(parse_decimal(found->second), 50);
  };
  Evaluator<Real> evaluate(equations.program(), [&](const SymbolPointer& symbol) {
    switch (symbol->kind) {
      case SymbolKind::pi:
        return Real::pi(50);
      case SymbolKind::coordinate:
        return value(q, symbol->name);
      case SymbolKind::velocity:
        return value(v, symbol->name.substr(0, symbol->name.find('\'')));
      default:
        return value(u, symbol->name);
    }
  });
  const std::vector<Real> solved = evaluate(equations.forward().accelerations);
  std::map<std::string, Real> by_name;
  for (std::size_t i = 0; i < solved.size(); ++i) by_name[equations.model().coordinates()[i].q->name] = solved[i];
  return by_name;
}

/// The same accelerations of both, each within a part of the largest.
inline void expect_same(const std::map<std::string, Real>& actual, const std::map<std::string, Real>& expected,
                        double tolerance) {
  double largest = 0;
  for (const auto& [name, a] : expected) largest = std::max(largest, std::abs(a.to_double()));
  ASSERT_GT(largest, 0);
  ASSERT_EQ(actual.size(), expected.size());
  for (const auto& [name, a] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name;
    EXPECT_LE(abs(actual.at(name) - a).to_double(), tolerance * largest) << name << ": " << a.to_string(20);
  }
}

/// Both derivations in 50 digits lose a few to the condition of M.
inline constexpr double fifty_digits = 1e-42;
/// Angles that are no multiple of π/12 are good to 2·10⁻¹⁸ of themselves; the accelerations of these mechanisms, of a
/// few bodies of like size, depend on them with coefficients of the order of 10.
inline constexpr double rational_angles = 1e-16;

}  // namespace torsor::testing_urdf
