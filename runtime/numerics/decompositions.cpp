// SPDX-License-Identifier: MIT
#include "torsor/runtime/numerics/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <stdexcept>

namespace torsor::runtime {

namespace {

void require_square(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() == 0 || matrix.rows() != matrix.cols()) {
    throw std::invalid_argument("eigenvalues are asked of a matrix that is not square");
  }
}

}  // namespace

Eigenpairs eigenpairs(const Eigen::MatrixXd& A) {
  require_square(A);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the eigenvalues of the state matrix did not converge");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& S) {
  require_square(S);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(S);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Index SingularValues::rank(double threshold) const {
  if (values.size() == 0 || values(0) == 0.0) return 0;
  return (values.array() > threshold * values(0)).count();
}

SingularValues singular_values(const Eigen::MatrixXd& A) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(A, Eigen::ComputeFullV);
  return {decomposition.singularValues(), decomposition.matrixV()};
}

}  // namespace torsor::runtime
