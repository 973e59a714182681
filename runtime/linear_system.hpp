// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "runtime/library.hpp"

namespace torsor::runtime {

/// Small motions M x'' + C x' + K x = F with constant matrices (Pommier, §7.2, §7.3). F is what the linearised
/// equations leave over at the state they were made about; the forces of the functions that take one come beside it.
struct LinearSystem {
  Eigen::MatrixXd M, C, K;
  Eigen::VectorXd F;

  [[nodiscard]] Eigen::Index size() const noexcept { return M.rows(); }
};

/// A system without damping and without a constant force.
[[nodiscard]] LinearSystem undamped(const Eigen::MatrixXd& M, const Eigen::MatrixXd& K);

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
  [[nodiscard]] Eigen::MatrixXd coordinates(const Eigen::MatrixXd& y) const;
  [[nodiscard]] Eigen::VectorXcd coordinates(const Eigen::VectorXcd& y) const;

  /// L⁻¹ F / σ² of a force.
  [[nodiscard]] Eigen::VectorXd force(const Eigen::VectorXd& given) const;
  [[nodiscard]] Eigen::VectorXcd force(const Eigen::VectorXcd& given) const;
};

/// Throws std::invalid_argument for matrices that do not fit, are not finite, or for a mass matrix that is not
/// symmetric positive definite.
[[nodiscard]] NormalisedSystem normalised(const LinearSystem& system);

}  // namespace torsor::runtime
