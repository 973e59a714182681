// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/linear_system.hpp"

namespace torsor::runtime {

namespace detail {

/// The coordinates of a system that are not listed. Throws std::invalid_argument for a list that does not fit.
[[nodiscard]] inline std::vector<Eigen::Index> others(const LinearSystem& system,
                                                      const std::vector<Eigen::Index>& listed) {
  for (const Eigen::Index i : listed) {
    if (i < 0 || i >= system.size() || std::count(listed.begin(), listed.end(), i) != 1) {
      throw std::invalid_argument("coordinate " + std::to_string(i) + " is listed twice or is none of " +
                                  std::to_string(system.size()));
    }
  }
  std::vector<Eigen::Index> rest;
  for (Eigen::Index i = 0; i < system.size(); ++i) {
    if (std::find(listed.begin(), listed.end(), i) == listed.end()) rest.push_back(i);
  }
  if (rest.empty()) throw std::invalid_argument("every coordinate is cyclic: nothing is left to look at");
  return rest;
}

}  // namespace detail

/// Small deviations from a steady motion whose cyclic coordinates are kept at their rates by motors: their rows and
/// columns are left out.
[[nodiscard]] inline LinearSystem reduced_at_constant_rate(const LinearSystem& system,
                                                           const std::vector<Eigen::Index>& cyclic) {
  const std::vector<Eigen::Index> n = detail::others(system, cyclic);
  return {system.M(n, n), system.C(n, n), system.K(n, n), system.F(n)};
}

/// Small deviations from a steady motion at the same momenta of its cyclic coordinates (Routh; Pommier, §7.4): with the
/// parts n (others) and c (cyclic), momenta p = M_cn x_n' + M_cc x_c' + C_cn x_n = 0 give x_c', and then
///   M = M_nn − M_nc M_cc⁻¹ M_cn,  C = C_nn − M_nc M_cc⁻¹ C_cn − C_nc M_cc⁻¹ M_cn,  K = K_nn − C_nc M_cc⁻¹ C_cn.
/// Without this the cyclic coordinates, which nothing brings back, give zero roots and no criterion concludes. K is the
/// Hessian of the reduced potential, for Lejeune-Dirichlet; stability is that of the other coordinates and of the
/// rates. Throws std::invalid_argument when the momenta are not conserved: forces along a cyclic coordinate that depend
/// on its value or rate (C_cc, K_cc, K_cn, K_nc not zero).
[[nodiscard]] inline LinearSystem reduced_at_constant_momentum(const LinearSystem& system,
                                                               const std::vector<Eigen::Index>& cyclic) {
  const std::vector<Eigen::Index> n = detail::others(system, cyclic);
  const std::vector<Eigen::Index>& c = cyclic;
  const NormalisedSystem normal = normalised(system);  // also sees that M is positive definite
  const Eigen::VectorXd scale = system.M.diagonal().cwiseSqrt();
  const auto negligible = [&scale](const Eigen::MatrixXd& matrix, const auto& rows, const auto& columns, double size) {
    for (const Eigen::Index i : rows) {
      for (const Eigen::Index j : columns) {
        if (std::abs(matrix(i, j)) > 1e-9 * size * scale(i) * scale(j)) return false;
      }
    }
    return true;
  };
  const double rate = normal.sigma, stiffness = normal.sigma * normal.sigma;
  if (!negligible(system.C, c, c, rate) || !negligible(system.K, c, c, stiffness) ||
      !negligible(system.K, c, n, stiffness) || !negligible(system.K, n, c, stiffness)) {
    throw std::invalid_argument(
        "the momenta of the cyclic coordinates are not conserved: a force along one of them depends on the motion; "
        "keep their rates constant instead");
  }
  const Eigen::MatrixXd M_cc = system.M(c, c), M_cn = system.M(c, n), M_nc = system.M(n, c);
  const Eigen::MatrixXd C_cn = system.C(c, n), C_nc = system.C(n, c);
  const Eigen::LDLT<Eigen::MatrixXd> factor(M_cc);
  const Eigen::MatrixXd by_mass = factor.solve(M_cn), by_rate = factor.solve(C_cn);
  return {system.M(n, n) - M_nc * by_mass, system.C(n, n) - M_nc * by_rate - C_nc * by_mass,
          system.K(n, n) - C_nc * by_rate, system.F(n)};
}

}  // namespace torsor::runtime
