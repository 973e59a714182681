// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/row_basis.hpp"

namespace torsor {

Real product(const RealRow& a, const RealRow& b) {
  Real sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Real length(const RealRow& a) { return sqrt(product(a, a)); }

RealRow solve_positive(RealRows a, RealRow b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j <= k; ++j) {
      Real rest = a[k][j];
      for (std::size_t i = 0; i < j; ++i) rest -= a[k][i] * a[j][i];
      a[k][j] = j < k ? rest / a[j][j] : sqrt(rest);
    }
    for (std::size_t i = 0; i < k; ++i) b[k] -= a[k][i] * b[i];
    b[k] /= a[k][k];
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = k + 1; i < n; ++i) b[k] -= a[i][k] * b[i];
    b[k] /= a[k][k];
  }
  return b;
}

}  // namespace torsor
