// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"

#include <cmath>
#include <stdexcept>

#include "torsor/runtime/numerics/decompositions.hpp"

namespace torsor::runtime {

LinearSystem on_constraints(const LinearSystem& system, const Eigen::MatrixXd& A) {
  const Eigen::Index n = system.size();
  // Rows of length 1 in coordinates of equal mass: what is rank does not depend on units.
  const Eigen::VectorXd scale =
      system.M.diagonal().unaryExpr([](double mass) { return mass > 0.0 ? 1.0 / std::sqrt(mass) : 1.0; });
  Eigen::MatrixXd even = A * scale.asDiagonal();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    const double length = even.row(i).norm();
    if (length > 0.0) even.row(i) /= length;
  }
  const SingularValues decomposition = singular_values(even);
  const Eigen::Index freedom = n - decomposition.rank(1e-10);
  if (freedom == 0) throw std::invalid_argument("the constraints leave no motion at this state");
  const Eigen::MatrixXd Z = scale.asDiagonal() * decomposition.right.rightCols(freedom);
  return {Z.transpose() * system.M * Z, Z.transpose() * system.C * Z, Z.transpose() * system.K * Z,
          Z.transpose() * system.F};
}

StabilityReport stability(const LinearSystem& system, bool forces_at_rest_have_force_function) {
  const StabilityReport linear = stability_by_eigenvalues(system);
  if (linear.verdict != Stability::cannot_conclude || !forces_at_rest_have_force_function) return linear;
  const StabilityReport potential = stability_by_lejeune_dirichlet(system);
  return {potential.verdict, potential.reason + "; " + linear.reason};
}

}  // namespace torsor::runtime
