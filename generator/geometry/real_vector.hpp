// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// Three numbers in high precision: a vector at one configuration, where a `Vector` is one at all of them.
using RealVector = std::array<Real, 3>;
/// Rows of numbers of one length.
using RealRotation = std::array<RealVector, 3>;

inline RealVector operator+(const RealVector& a, const RealVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline RealVector operator-(const RealVector& a, const RealVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RealVector operator*(const Real& k, const RealVector& v) { return {k * v[0], k * v[1], k * v[2]}; }
inline Real dot(const RealVector& a, const RealVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline RealVector cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real norm(const RealVector& v) { return sqrt(dot(v, v)); }

inline RealVector operator*(const RealRotation& r, const RealVector& v) {
  return {dot(r[0], v), dot(r[1], v), dot(r[2], v)};
}
inline RealVector column(const RealRotation& r, int j) {
  const auto k = static_cast<std::size_t>(j);
  return {r[0][k], r[1][k], r[2][k]};
}
inline RealRotation operator*(const RealRotation& a, const RealRotation& b) {
  RealRotation product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return product;
}

/// Rotation by an angle about a unit vector n: cos 1 + sin [n] + (1 − cos) n nᵀ (Rodrigues).
RealRotation rotation_about(const RealVector& n, const Real& angle);
/// Rotation by the vector θ n.
RealRotation rotation_by(const RealVector& turn);

}  // namespace torsor
