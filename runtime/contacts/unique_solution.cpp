// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/unique_solution.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "torsor/runtime/contacts/contact_scale.hpp"

namespace torsor::runtime {
namespace {

bool has_bound(const ContactProblem& problem) noexcept {
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    if (law.bearing > 0) return false;
    if (!law.slips && (law.static_friction != law.friction || law.static_bound != law.bound)) return false;
  }
  return true;
}

}  // namespace

bool solution_is_unique(const ContactProblem& problem) noexcept {
  if (!has_bound(problem)) return false;
  const int n = problem.rows();
  const ContactScale scale(problem);
  ContactVector unit(n);
  for (int row = 0; row < n; ++row) unit(row) = scale.unit(row);
  const ContactVector over = unit.cwiseInverse();
  const ContactMatrix W = over.asDiagonal() * ((problem.W + problem.W.transpose()) / 2) * over.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<ContactMatrix> parts(W);
  if (parts.info() != Eigen::Success) return false;
  const ContactVector& own = parts.eigenvalues();
  if (!(own.size() > 0 && own.minCoeff() > 1e-8 * own.maxCoeff())) return false;
  // x = Λ^½ Vᵀ Δr, so that Δr · W Δr = |x|².
  const ContactMatrix& V = parts.eigenvectors();
  const ContactVector root = own.cwiseSqrt();
  ContactMatrix bound = ContactMatrix::Zero(n, n);
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const int pressing = problem.pressing_row(i), t = problem.tangent_row(i);
    if (pressing < 0 || law.tangents == 0 || law.friction == 0) continue;
    const double unit_of_slip = unit.segment(t, law.tangents).maxCoeff();
    const ContactVector force = V.row(pressing).transpose().cwiseQuotient(root);
    const ContactMatrix slip = V.middleRows(t, law.tangents) * root.asDiagonal();
    const ContactMatrix squares = slip * slip.transpose();
    const double fastest = law.tangents == 1 ? squares(0, 0)
                                             : (squares(0, 0) + squares(1, 1)) / 2 +
                                                   std::hypot((squares(0, 0) - squares(1, 1)) / 2, squares(0, 1));
    const double c = std::sqrt(fastest) / force.norm();
    if (!(c > 0)) continue;
    const double f = law.friction * unit_of_slip / unit(pressing);
    bound.noalias() += f / 2 * (c * force * force.transpose() + slip.transpose() * slip / c);
  }
  return Eigen::SelfAdjointEigenSolver<ContactMatrix>(bound, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff() < 0.99;
}

}  // namespace torsor::runtime
