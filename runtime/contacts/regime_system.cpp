// SPDX-License-Identifier: MIT
#include "runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

RegimeSystem::RegimeSystem(const ContactProblem& problem, const Regimes& regimes) noexcept
    : problem_(problem), regimes_(regimes) {
  const int rows = problem.rows();
  B_.setZero(rows, unknowns());
  c_.setZero(rows);
  rows_.fill(0);
  int column = 0;
  PerContact<int> normal_column{};
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const AssumedRegime& assumed = at(i);
    const int t = problem.tangent_row(i);
    normal_column[as(i)] = -1;
    if (assumed.pressed) {
      B_(problem.first_row(i), column) = 1;
      normal_column[as(i)] = column;
      rows_[as(column++)] = problem.first_row(i);
    }
    const int by = law.normal ? i : law.pressed_by;
    const int pressing = by < 0 ? -1 : normal_column[as(by)];
    for (int k = 0; assumed.friction == Friction::slides && k < law.tangents; ++k) {
      c_(t + k) = -law.bound * assumed.direction[as(k)];
      if (pressing >= 0) B_(t + k, pressing) = -law.friction * assumed.direction[as(k)];
    }
    for (int k = 0; assumed.friction == Friction::sticks && k < law.tangents; ++k) {
      B_(t + k, column) = 1;
      rows_[as(column++)] = t + k;
    }
  }
  const ContactMatrix WB = problem.W * B_;
  const ContactVector rest = problem.W * c_ + problem.q;
  E_.resize(column, column);
  e_.resize(column);
  for (int i = 0; i < column; ++i) {
    E_.row(i) = WB.row(rows_[as(i)]);
    e_(i) = -rest(rows_[as(i)]);
  }
}

int RegimeSystem::unknowns() const noexcept {
  int n = 0;
  for (int i = 0; i < problem_.count; ++i) {
    n += (at(i).pressed ? 1 : 0) + (at(i).friction == Friction::sticks ? problem_.law(i).tangents : 0);
  }
  return n;
}

bool RegimeSystem::solve() noexcept {
  const int n = static_cast<int>(E_.cols());
  kernel_.resize(n, 0);
  x_.setZero(n);
  if (n == 0) return true;
  lu_.compute(E_);
  // A pivot below this share of the largest is what rounding leaves of a row that depends on others.
  lu_.setThreshold(1e-11);
  x_ = lu_.solve(e_);
  if (lu_.rank() < n) {
    kernel_ = lu_.kernel();
    const ContactVector left = E_ * x_ - e_;
    const double size = E_.cwiseAbs().maxCoeff() * x_.cwiseAbs().maxCoeff() + e_.cwiseAbs().maxCoeff();
    return left.cwiseAbs().maxCoeff() <= 1e-10 * size + problem_.noise;
  }
  return x_.allFinite();
}

void RegimeSystem::approach(const ContactVector& reactions) noexcept {
  if (kernel_.cols() == 0) return;
  ContactVector missing = -x_;
  for (int i = 0; i < static_cast<int>(missing.size()); ++i) missing(i) += reactions(rows_[as(i)]);
  const ContactMatrix square = kernel_.transpose() * kernel_;
  const ContactVector right = kernel_.transpose() * missing;
  x_ += kernel_ * square.partialPivLu().solve(right);
}

ContactVector RegimeSystem::motion_by_turning(int i) const noexcept {
  const ContactLaw& law = problem_.law(i);
  const int t = problem_.tangent_row(i);
  const ContactVector r = reactions();
  const double pull = law.friction * problem_.pressing(i, r) + law.bound;
  ContactVector dr = ContactVector::Zero(problem_.rows());
  dr(t) = pull * at(i).direction[1];
  dr(t + 1) = -pull * at(i).direction[0];
  const ContactVector du = problem_.W * dr;
  const int n = static_cast<int>(E_.cols());
  if (n == 0) return du;
  ContactVector right(n);
  for (int k = 0; k < n; ++k) right(k) = -du(rows_[as(k)]);
  const ContactVector dx = lu_.solve(right);
  return du + problem_.W * (B_ * dx);
}

}  // namespace torsor::runtime
