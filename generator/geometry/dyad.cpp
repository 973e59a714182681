// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/dyad.hpp"

namespace torsor {

Matrix dyad(const Vector& a, const Vector& b) {
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!a[i].is_zero() && !b[j].is_zero()) m(i, j) = a[i] * b[j];
    }
  }
  return m;
}

Matrix cross_operator(const Vector& a) {
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    m(i, j) = -a[k];
    m(i, k) = a[j];
  }
  return m;
}

}  // namespace torsor
