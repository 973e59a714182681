// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/library.hpp"

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

namespace detail {

/// Values stored column by column.
template <class Values>
[[nodiscard]] Eigen::MatrixXd matrix(const Values& values, Eigen::Index rows) {
  Eigen::MatrixXd result(rows, static_cast<Eigen::Index>(values.size()) / rows);
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    result(k % rows, k / rows) = static_cast<double>(values[static_cast<std::size_t>(k)]);
  }
  return result;
}

[[noreturn]] void throw_not_square(Eigen::Index velocities, Eigen::Index coordinates);

}  // namespace detail

/// The result of the generated kernel `linearisation` as matrices: M, C, K are n x n, stored column by column. With
/// constraints these are the equations in all freedoms, at fixed multipliers.
template <class Linearisation>
[[nodiscard]] LinearSystem linear_system(const Linearisation& linear) {
  const auto n = static_cast<Eigen::Index>(linear.F.size());
  return {detail::matrix(linear.M, n), detail::matrix(linear.C, n), detail::matrix(linear.K, n),
          detail::matrix(linear.F, n).col(0)};
}

/// The same of a constrained mechanism in its independent freedoms, M_r, C_r, K_r, F_r: about any state that satisfies
/// the constraints, moving or at rest. Throws std::invalid_argument where constraints on velocities leave more
/// coordinates than velocities: K_r is not square then, take `state_matrix`.
template <class Linearisation>
[[nodiscard]] LinearSystem reduced_linear_system(const Linearisation& linear) {
  const auto n = static_cast<Eigen::Index>(linear.F_r.size());
  if (linear.K_r.size() != linear.M_r.size())
    detail::throw_not_square(n, static_cast<Eigen::Index>(linear.K_r.size()) / n);
  return {detail::matrix(linear.M_r, n), detail::matrix(linear.C_r, n), detail::matrix(linear.K_r, n),
          detail::matrix(linear.F_r, n).col(0)};
}

/// A of x' = A x + B δu from the generated kernel `linearisation`, x the deviations of independent coordinates and then
/// of independent velocities.
template <class Linearisation>
[[nodiscard]] Eigen::MatrixXd state_matrix(const Linearisation& linear) {
  return detail::matrix(linear.A, static_cast<Eigen::Index>(std::lround(std::sqrt(linear.A.size()))));
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
