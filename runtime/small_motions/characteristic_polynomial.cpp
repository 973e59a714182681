// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/characteristic_polynomial.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>

namespace torsor::runtime {

CharacteristicPolynomial characteristic_polynomial(const LinearSystem& system) {
  const NormalisedSystem normal = normalised(system);
  const Eigen::Index n = system.size();
  const int count = static_cast<int>(2 * n + 1);
  const Eigen::MatrixXcd D = normal.D.cast<std::complex<double>>(), S = normal.S.cast<std::complex<double>>();
  std::vector<std::complex<double>> values;
  double bound = 0.0;
  for (int k = 0; k < count; ++k) {
    const std::complex<double> z = std::polar(1.0, 2.0 * std::numbers::pi * k / count);
    Eigen::MatrixXcd matrix = z * D + S;
    matrix.diagonal().array() += z * z;
    bound = std::max(bound, matrix.rowwise().norm().prod());
    values.push_back(matrix.partialPivLu().determinant());
  }
  const double error = 16.0 * static_cast<double>(n * n) * std::numeric_limits<double>::epsilon() * bound;
  CharacteristicPolynomial result;
  double unit = 1.0;  // σ^{2n−m}: the coefficients belong to s/σ
  for (int m = count - 1; m >= 0; --m) {
    std::complex<double> sum = 0.0;
    for (int k = 0; k < count; ++k) {
      const double angle = -2.0 * std::numbers::pi * ((k * m) % count) / count;
      sum += values[static_cast<std::size_t>(k)] * std::polar(1.0, angle);
    }
    const bool leading = m == count - 1;
    result.coefficients.push_back(leading ? 1.0 : sum.real() / count * unit);
    result.uncertainties.push_back(leading ? 0.0 : error * unit);
    unit *= normal.sigma;
  }
  return result;
}

}  // namespace torsor::runtime
