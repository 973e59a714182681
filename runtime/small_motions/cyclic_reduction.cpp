// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/cyclic_reduction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace torsor::runtime {

namespace {

/// The coordinates of a system that are not listed. Throws std::invalid_argument for a list that does not fit.
[[nodiscard]] std::vector<Eigen::Index> others(const LinearSystem& system, const std::vector<Eigen::Index>& listed) {
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

}  // namespace

LinearSystem reduced_at_constant_rate(const LinearSystem& system, const std::vector<Eigen::Index>& cyclic) {
  const std::vector<Eigen::Index> n = others(system, cyclic);
  return {system.M(n, n), system.C(n, n), system.K(n, n), system.F(n)};
}

LinearSystem reduced_at_constant_momentum(const LinearSystem& system, const std::vector<Eigen::Index>& cyclic) {
  const std::vector<Eigen::Index> n = others(system, cyclic);
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
  // A force counts that would hold the stiffest freedom aside by 1e-9 m or rad.
  const double usual = scale.maxCoeff();
  for (const Eigen::Index i : c) {
    if (std::abs(system.F(i)) > 1e-9 * stiffness * scale(i) * usual) {
      throw std::invalid_argument(
          "the momentum of the cyclic coordinate " + std::to_string(i) + " is not conserved: a constant force of " +
          std::to_string(system.F(i)) +
          " along it is left; linearise about a steady motion, in which it is balanced, or keep its rate constant instead");
    }
  }
  const Eigen::MatrixXd M_cc = system.M(c, c), M_cn = system.M(c, n), M_nc = system.M(n, c);
  const Eigen::MatrixXd C_cn = system.C(c, n), C_nc = system.C(n, c);
  const Eigen::LDLT<Eigen::MatrixXd> factor(M_cc);
  const Eigen::MatrixXd by_mass = factor.solve(M_cn), by_rate = factor.solve(C_cn);
  return {system.M(n, n) - M_nc * by_mass, system.C(n, n) - M_nc * by_rate - C_nc * by_mass,
          system.K(n, n) - C_nc * by_rate, system.F(n)};
}

}  // namespace torsor::runtime
