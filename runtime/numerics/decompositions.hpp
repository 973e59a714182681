// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace torsor::runtime {

/// Decompositions whose templates take many seconds to compile, compiled once in the library. Matrices of the size that
/// mechanisms have; any units. A matrix must be finite.

/// Roots of det(A − λ 1) = 0 and a vector A x = λ x of length 1 for each, in columns; no order.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

/// By the QR algorithm. Throws std::invalid_argument when A is not square, std::runtime_error when it does not
/// converge.
[[nodiscard]] Eigenpairs eigenpairs(const Eigen::MatrixXd& A);

/// Those of a symmetric matrix, rising; the vectors are orthonormal.
struct SymmetricEigenpairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Reads the lower triangle. Throws std::invalid_argument when S is not square.
[[nodiscard]] SymmetricEigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& S);

/// Of A = U diag(σ) Vᵀ: σ, falling, and V, square: its columns beyond the rank span the motions v with A v = 0.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd right;

  /// Number of values above `threshold` times the largest.
  [[nodiscard]] Eigen::Index rank(double threshold) const;
};

/// By Jacobi's rotations.
[[nodiscard]] SingularValues singular_values(const Eigen::MatrixXd& A);

}  // namespace torsor::runtime
