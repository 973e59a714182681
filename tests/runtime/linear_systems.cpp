// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/runtime/linear_systems.hpp"

#include <Eigen/LU>
#include <random>

namespace linear_systems {

LinearSystem chain(int n, double mass, double stiffness) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    K(i, i) = 2.0 * stiffness;
    if (i > 0) K(i, i - 1) = K(i - 1, i) = -stiffness;
  }
  return torsor::runtime::undamped(mass * Eigen::MatrixXd::Identity(n, n), K);
}

LinearSystem absorber() {
  Eigen::MatrixXd K(2, 2);
  K << 110, -10, -10, 10;
  return torsor::runtime::undamped(Eigen::Vector2d(1, 0.1).asDiagonal(), K);
}

LinearSystem rotating_mass(double a, double b, double turn) {
  LinearSystem system = torsor::runtime::undamped(Eigen::MatrixXd::Identity(2, 2),
                                                  Eigen::Vector2d(a - turn * turn, b - turn * turn).asDiagonal());
  system.C << 0, -2 * turn, 2 * turn, 0;
  return system;
}

Eigen::MatrixXd random_matrix(int n, int seed) {
  std::mt19937_64 engine(static_cast<std::mt19937_64::result_type>(seed));
  Eigen::MatrixXd matrix(n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) matrix(i, j) = static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0;
  }
  return matrix;
}

LinearSystem random_system(int n, int seed) {
  const Eigen::MatrixXd a = random_matrix(n, 2 * seed), b = random_matrix(n, 2 * seed + 1);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  return torsor::runtime::undamped(a * a.transpose() + 0.3 * one, b * b.transpose() + 0.2 * one);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) { return matrix.inverse(); }

double determinant(const Eigen::MatrixXd& matrix) { return matrix.determinant(); }

}  // namespace linear_systems
