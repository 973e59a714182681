// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace torsor::runtime {

/// Small motions M x'' + C x' + K x = F with constant matrices (Pommier, §7.2, §7.3). F is what the linearised
/// equations leave over at the state they were made about; the forces of the functions that take one come beside it.
struct LinearSystem {
  Eigen::MatrixXd M, C, K;
  Eigen::VectorXd F;

  [[nodiscard]] Eigen::Index size() const noexcept { return M.rows(); }
};

/// A system without damping and without a constant force.
[[nodiscard]] inline LinearSystem undamped(const Eigen::MatrixXd& M, const Eigen::MatrixXd& K) {
  return {M, Eigen::MatrixXd::Zero(M.rows(), M.cols()), K, Eigen::VectorXd::Zero(M.rows())};
}

/// The result of the generated kernel `linearisation` as matrices: M, C, K are n x n, stored column by column. With
/// constraints these are the equations in all freedoms, at fixed multipliers.
template <class Linearisation>
[[nodiscard]] LinearSystem linear_system(const Linearisation& linear) {
  const auto n = static_cast<Eigen::Index>(linear.F.size());
  const auto matrix = [n](const auto& values) {
    Eigen::MatrixXd result(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = 0; i < n; ++i)
        result(i, j) = static_cast<double>(values[static_cast<std::size_t>(j * n + i)]);
    }
    return result;
  };
  LinearSystem system{matrix(linear.M), matrix(linear.C), matrix(linear.K), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) system.F(i) = static_cast<double>(linear.F[static_cast<std::size_t>(i)]);
  return system;
}

/// The same system in coordinates and a time without units: with M = L Lᵀ, y = Lᵀ x and τ = σ t,
///   d²y/dτ² + D dy/dτ + S y = L⁻¹ F / σ²,  D = L⁻¹ C L⁻ᵀ / σ,  S = L⁻¹ K L⁻ᵀ / σ²,
/// where σ = max(‖L⁻¹ K L⁻ᵀ‖^½, ‖L⁻¹ C L⁻ᵀ‖) [rad/s] (1 for a free body) makes both of the size of 1: what is
/// computed with them does not depend on the units of the coordinates.
struct NormalisedSystem {
  Eigen::MatrixXd L, D, S;
  double sigma = 1.0;

  /// x = L⁻ᵀ y of one column or several.
  [[nodiscard]] Eigen::MatrixXd coordinates(const Eigen::MatrixXd& y) const {
    return L.transpose().triangularView<Eigen::Upper>().solve(y);
  }
  [[nodiscard]] Eigen::VectorXcd coordinates(const Eigen::VectorXcd& y) const { return joined(y, true); }

  /// L⁻¹ F / σ² of a force.
  [[nodiscard]] Eigen::VectorXd force(const Eigen::VectorXd& given) const {
    return L.triangularView<Eigen::Lower>().solve(given) / (sigma * sigma);
  }
  [[nodiscard]] Eigen::VectorXcd force(const Eigen::VectorXcd& given) const { return joined(given, false); }

 private:
  [[nodiscard]] Eigen::VectorXcd joined(const Eigen::VectorXcd& vector, bool back) const {
    const Eigen::VectorXd real = vector.real(), imaginary = vector.imag();
    Eigen::VectorXcd result(vector.size());
    result.real() = back ? Eigen::VectorXd(coordinates(Eigen::MatrixXd(real))) : force(real);
    result.imag() = back ? Eigen::VectorXd(coordinates(Eigen::MatrixXd(imaginary))) : force(imaginary);
    return result;
  }
};

/// Throws std::invalid_argument for matrices that do not fit, are not finite, or for a mass matrix that is not
/// symmetric positive definite.
[[nodiscard]] inline NormalisedSystem normalised(const LinearSystem& system) {
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
