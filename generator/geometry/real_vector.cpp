// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/real_vector.hpp"

namespace torsor {

RealRotation rotation_about(const RealVector& n, const Real& angle) {
  Real sine, cosine;
  sincos(angle, sine, cosine);
  const Real rest = Real(1) - cosine;
  RealRotation r;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    r[i][i] = cosine + rest * n[i] * n[i];
    r[i][j] = rest * n[i] * n[j] - sine * n[k];
    r[j][i] = rest * n[i] * n[j] + sine * n[k];
  }
  return r;
}

RealRotation rotation_by(const RealVector& turn) {
  const Real angle = norm(turn);
  const RealVector x{Real(1), Real(0), Real(0)};
  return rotation_about(angle.is_zero() ? x : (Real(1) / angle) * turn, angle);
}

}  // namespace torsor
