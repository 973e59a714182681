// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace torsor::testing_quadrature {

/// Nodes and weights of Gauss-Legendre quadrature with n points on [low, high], by Newton's method on P_n: exact for
/// polynomials of degree 2n - 1.
inline std::vector<std::pair<double, double>> gauss_legendre(int n, double low, double high) {
  const double pi = std::acos(-1.0);
  std::vector<std::pair<double, double>> rule;
  for (int k = 1; k <= n; ++k) {
    double x = std::cos(pi * (k - 0.25) / (n + 0.5));
    double slope = 0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double before = 1;
      double value = x;
      for (int j = 2; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.emplace_back((low + high) / 2 + x * (high - low) / 2, (high - low) / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/// A body as mass points.
struct MassPoint {
  double mass;
  std::array<double, 3> place;
};

/// J = Σ m (r² 1 − r rᵀ) about the origin, in the order xx, yy, zz, xy, xz, yz.
inline std::array<double, 6> inertia_about_origin(const std::vector<MassPoint>& points) {
  std::array<double, 6> j{};
  for (const auto& [m, p] : points) {
    j[0] += m * (p[1] * p[1] + p[2] * p[2]);
    j[1] += m * (p[0] * p[0] + p[2] * p[2]);
    j[2] += m * (p[0] * p[0] + p[1] * p[1]);
    j[3] -= m * p[0] * p[1];
    j[4] -= m * p[0] * p[2];
    j[5] -= m * p[1] * p[2];
  }
  return j;
}

inline double total_mass(const std::vector<MassPoint>& points) {
  double sum = 0;
  for (const MassPoint& point : points) sum += point.mass;
  return sum;
}

}  // namespace torsor::testing_quadrature
