// SPDX-License-Identifier: MIT
#include "torsor/runtime/numerics/matrix_exponential.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace torsor::runtime {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() != matrix.cols() || !matrix.allFinite()) {
    throw std::invalid_argument("the exponential is asked of a matrix that is not square or not finite");
  }
  constexpr std::array<double, 14> b{64764752532480000.0,
                                     32382376266240000.0,
                                     7771770303897600.0,
                                     1187353796428800.0,
                                     129060195264000.0,
                                     10559470521600.0,
                                     670442572800.0,
                                     33522128640.0,
                                     1323241920.0,
                                     40840800.0,
                                     960960.0,
                                     16380.0,
                                     182.0,
                                     1.0};
  constexpr double theta = 5.371920351148152;  // below it the approximant is exact to double precision
  const double norm = matrix.cwiseAbs().colwise().sum().maxCoeff();
  int squarings = 0;
  if (norm > theta) squarings = std::max(0, static_cast<int>(std::ceil(std::log2(norm / theta))));
  const Eigen::MatrixXd A = matrix * std::ldexp(1.0, -squarings);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(A.rows(), A.cols());
  const Eigen::MatrixXd A2 = A * A, A4 = A2 * A2, A6 = A4 * A2;
  const Eigen::MatrixXd odd =
      A6 * (b[13] * A6 + b[11] * A4 + b[9] * A2) + b[7] * A6 + b[5] * A4 + b[3] * A2 + b[1] * one;
  const Eigen::MatrixXd U = A * odd;
  const Eigen::MatrixXd V = A6 * (b[12] * A6 + b[10] * A4 + b[8] * A2) + b[6] * A6 + b[4] * A4 + b[2] * A2 + b[0] * one;
  Eigen::MatrixXd result = (V - U).partialPivLu().solve(V + U);
  for (int i = 0; i < squarings; ++i) result = Eigen::MatrixXd(result * result);
  return result;
}

}  // namespace torsor::runtime
