// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/linear_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace torsor::runtime {

void detail::throw_not_square(Eigen::Index velocities, Eigen::Index coordinates) {
  throw std::invalid_argument("the linearised equations have " + std::to_string(coordinates) +
                              " independent coordinates and " + std::to_string(velocities) +
                              " independent velocities: they are no M x'' + C x' + K x = F; take the state matrix");
}

LinearSystem undamped(const Eigen::MatrixXd& M, const Eigen::MatrixXd& K) {
  return {M, Eigen::MatrixXd::Zero(M.rows(), M.cols()), K, Eigen::VectorXd::Zero(M.rows())};
}

Eigen::MatrixXd NormalisedSystem::coordinates(const Eigen::MatrixXd& y) const {
  return L.transpose().triangularView<Eigen::Upper>().solve(y);
}

Eigen::VectorXcd NormalisedSystem::coordinates(const Eigen::VectorXcd& y) const {
  Eigen::MatrixXd parts(y.size(), 2);
  parts << y.real(), y.imag();
  const Eigen::MatrixXd solved = coordinates(parts);
  Eigen::VectorXcd result(y.size());
  result.real() = solved.col(0);
  result.imag() = solved.col(1);
  return result;
}

Eigen::VectorXd NormalisedSystem::force(const Eigen::VectorXd& given) const {
  return L.triangularView<Eigen::Lower>().solve(given) / (sigma * sigma);
}

Eigen::VectorXcd NormalisedSystem::force(const Eigen::VectorXcd& given) const {
  Eigen::VectorXcd result(given.size());
  result.real() = force(Eigen::VectorXd(given.real()));
  result.imag() = force(Eigen::VectorXd(given.imag()));
  return result;
}

NormalisedSystem normalised(const LinearSystem& system) {
  const Eigen::Index n = system.M.rows();
  for (const Eigen::MatrixXd* matrix : {&system.M, &system.C, &system.K}) {
    if (n == 0 || matrix->rows() != n || matrix->cols() != n) {
      throw std::invalid_argument("a matrix of small motions is " + std::to_string(matrix->rows()) + " x " +
                                  std::to_string(matrix->cols()) + " where M has " + std::to_string(n) +
                                  " rows; give M, C and K one square shape");
    }
    if (!matrix->allFinite()) throw std::invalid_argument("a matrix of small motions has an entry that is not finite");
  }
  const Eigen::VectorXd scale = system.M.diagonal().cwiseAbs().cwiseMax(0.0).cwiseSqrt();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (std::abs(system.M(i, j) - system.M(j, i)) > 1e-9 * scale(i) * scale(j)) {
        throw std::invalid_argument("the mass matrix is not symmetric: M(" + std::to_string(i) + "," +
                                    std::to_string(j) + ") = " + std::to_string(system.M(i, j)) + " and M(" +
                                    std::to_string(j) + "," + std::to_string(i) +
                                    ") = " + std::to_string(system.M(j, i)));
      }
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(system.M);
  if (factor.info() != Eigen::Success) {
    throw std::invalid_argument(
        "the mass matrix is not positive definite: a coordinate moves no mass; leave it out of the coordinates");
  }
  NormalisedSystem result;
  result.L = factor.matrixL();
  const auto congruent = [&factor](const Eigen::MatrixXd& matrix) {
    const Eigen::MatrixXd half = factor.matrixL().solve(matrix);
    return Eigen::MatrixXd(factor.matrixL().solve(half.transpose()).transpose());
  };
  result.D = congruent(system.C);
  result.S = congruent(system.K);
  const double sigma = std::max(std::sqrt(result.S.norm()), result.D.norm());
  if (sigma > 0.0) result.sigma = sigma;
  result.D /= result.sigma;
  result.S /= result.sigma * result.sigma;
  return result;
}

}  // namespace torsor::runtime
