// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/inertia_operations.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/mechanics/gauss_quadrature.hpp"

namespace torsor::testing_quadrature {

using Points = std::vector<MassPoint>;
using Place = std::array<double, 3>;

inline double in_double(const Expression& formula) {
  Program program;
  Evaluator<double> evaluate(program, [](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::pi ? std::acos(-1.0) : std::nan("");
  });
  return evaluate(program.lower(formula));
}

inline Expression in_unit(double value, const char* unit) {
  return Expression::quantity(std::to_string(value), unit);  // six decimals suffice for the numbers used here
}

/// Places (a, b, c) with c along the axis and a, b along the two that follow it.
inline Place along(int axis, double a, double b, double c) {
  Place place{};
  place[static_cast<std::size_t>(axis)] = c;
  place[static_cast<std::size_t>((axis + 1) % 3)] = a;
  place[static_cast<std::size_t>((axis + 2) % 3)] = b;
  return place;
}

/// Points of a circle, for a trapezoidal rule that is exact for the squares of coordinates.
inline std::vector<std::pair<double, double>> circle() {
  std::vector<std::pair<double, double>> rule;
  const double pi = std::acos(-1.0);
  for (int k = 0; k < 12; ++k) rule.emplace_back(2 * pi * k / 12, 2 * pi / 12);
  return rule;
}

/// Scales the masses of points of equal density to `mass` in all.
inline Points of_mass(double mass, Points points) {
  const double sum = total_mass(points);
  for (MassPoint& point : points) point.mass *= mass / sum;
  return points;
}

inline Place center_of(const Points& points) {
  Place center{};
  for (const auto& [m, place] : points) {
    for (std::size_t i = 0; i < 3; ++i) center[i] += m * place[i] / total_mass(points);
  }
  return center;
}

inline Points seen_from(const Place& origin, Points points) {
  for (MassPoint& point : points) {
    for (std::size_t i = 0; i < 3; ++i) point.place[i] -= origin[i];
  }
  return points;
}

inline Points together(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Mass, centre of mass and operator about it, and the operator about another point by Huygens' theorem. The rules are
/// exact for these polynomials: only some 10³ roundings of numbers of order one remain.
inline void expect_body(const Inertia& inertia, const Points& points) {
  const double rounding = 2e-13;
  EXPECT_NEAR(in_double(inertia.mass), total_mass(points), rounding);
  const Place center = center_of(points);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(in_double(inertia.center[i]), center[i], rounding) << "centre " << i;
  const auto expect_operator = [&](const InertiaOperator& j, const Place& about, const char* where) {
    const std::array<double, 6> integrated = inertia_about_origin(seen_from(about, points));
    const std::array<const Expression*, 6> entries{&j.xx, &j.yy, &j.zz, &j.xy, &j.xz, &j.yz};
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(in_double(*entries[k]), integrated[k], rounding) << "entry " << k << where;
    }
  };
  expect_operator({inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz}, center, " about G");
  const Place other{0.3, -0.8, 0.5};
  const Triple there{in_unit(other[0], "m"), in_unit(other[1], "m"), in_unit(other[2], "m")};
  expect_operator(operator_about(inertia, there), other, " about another point");
}

}  // namespace torsor::testing_quadrature
