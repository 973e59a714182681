// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "torsor/runtime/constraints/independent_constraints.hpp"

namespace torsor::runtime {

bool ContactDynamics::compute(const ContactReading& reading) {
  mass_.compute(reading.M);
  distance_ = 1;
  if (mass_.info() != Eigen::Success) return false;
  const auto L = mass_.matrixL();
  KF = reading.F;
  L.solveInPlace(KF);
  closing.setZero(reading.F.size());
  closing_rate.setZero(reading.F.size());
  if (reading.A.rows() > 0) {
    if (!orthogonalise(reading.A)) return false;
    // L^T a is L^-1 F without its part in Q, and -R^-T γ in Q.
    lambda_.noalias() = Q_.transpose() * KF;
    KF.noalias() -= Q_ * lambda_;
    along(reading.gamma);
    lambda_ = -lambda_ - w_;
    a0 = KF;
    a0.noalias() -= Q_ * w_;
    mass_.matrixU().solveInPlace(a0);
    least_change(reading.value, closing);
    least_change(reading.rate, closing_rate);
    R_.triangularView<Eigen::Upper>().solveInPlace(lambda_);
  } else {
    a0 = KF;
    mass_.matrixU().solveInPlace(a0);
  }
  mass_.matrixU().solveInPlace(KF);
  R_free = reading.R0;
  if (R_free.size() > 0) {
    R_free.noalias() += reading.B * a0;
    for (Eigen::Index k = 0; k < reading.A.rows(); ++k) {
      const int i = order_[static_cast<std::size_t>(k)];
      R_free += reading.D.col(i) * (lambda_(k) * over_(i));
    }
  }
  return a0.allFinite();
}

bool ContactDynamics::respond(const ContactReading& reading) {
  LJ_ = reading.J.transpose();
  answer_.resize(LJ_.rows());  // here, so that nothing is allocated later
  mass_.matrixL().solveInPlace(LJ_);
  if (reading.A.rows() > 0) {
    lengths_ = LJ_.colwise().norm().transpose();
    // Twice: what is left of a row that loops nearly hold has digits of its own.
    part_.noalias() = Q_.transpose() * LJ_;
    LJ_.noalias() -= Q_ * part_;
    AKJ = part_;
    part_.noalias() = Q_.transpose() * LJ_;
    LJ_.noalias() -= Q_ * part_;
    AKJ += part_;
    R_.triangularView<Eigen::Upper>().solveInPlace(AKJ);
    for (Eigen::Index k = 0; k < reading.A.rows(); ++k) {
      part_.row(order_[static_cast<std::size_t>(k)]) = over_(order_[static_cast<std::size_t>(k)]) * AKJ.row(k);
    }
    AKJ = part_;
    // At a dead centre the loops hold what a contact acts along, and an event falls beside it by rounding. To take away the slip
    // that this leaves would stop the mechanism: in W, which has squares, such a row is zero to rounding.
    for (Eigen::Index i = 0; i < LJ_.cols(); ++i) {
      if (LJ_.col(i).norm() < 1e-8 * lengths_(i)) LJ_.col(i).setZero();
    }
  }
  W.noalias() = LJ_.transpose() * LJ_;
  if (reading.R0.size() > 0) {
    LB_ = reading.B.transpose();
    mass_.matrixL().solveInPlace(LB_);
    S = reading.C;
    S.noalias() += LB_.transpose() * LJ_;
    if (reading.A.rows() > 0) S.noalias() -= reading.D * AKJ;
  }
  return W.allFinite();
}

void ContactDynamics::add_answer(const ContactVector& impulses, Eigen::VectorXd& to) {
  answer_.noalias() = LJ_ * impulses;
  mass_.matrixU().solveInPlace(answer_);
  to += answer_;
}

void ContactDynamics::forget() noexcept {
  longest_.resize(0);
  largest_pivot_ = 0;
  distance_ = 1;
}

// L^-1 A^T, each column over its size, with the longest of those that are left first: Gram-Schmidt, twice over. Source:
// Golub-Van Loan, Matrix Computations, 5.2 and 5.4.
bool ContactDynamics::orthogonalise(const Eigen::MatrixXd& A) {
  const auto m = static_cast<int>(A.rows());
  Q_ = A.transpose();
  mass_.matrixL().solveInPlace(Q_);
  R_.setZero(m, m);
  w_.setZero(m);
  over_.setZero(m);
  order_.resize(static_cast<std::size_t>(m));
  distance_ = 0;
  if (longest_.size() != m) longest_.setZero(m);
  for (int j = 0; j < m; ++j) {
    // One that vanishes as a whole, as where a loop is laid flat, is noticed by the size that it had.
    longest_(j) = std::max(longest_(j), Q_.col(j).norm());
    if (!(longest_(j) > 0)) return false;
    over_(j) = 1 / longest_(j);
    Q_.col(j) *= over_(j);
    order_[static_cast<std::size_t>(j)] = j;
  }
  for (int k = 0; k < m; ++k) {
    int longest = k;
    for (int j = k + 1; j < m; ++j) longest = Q_.col(j).squaredNorm() > Q_.col(longest).squaredNorm() ? j : longest;
    if (longest != k) {
      Q_.col(k).swap(Q_.col(longest));
      R_.col(k).swap(R_.col(longest));
      std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(longest)]);
    }
    for (int i = 0; i < k; ++i) take_out(i, k);
    const double length = Q_.col(k).norm();
    if (!(length > usual_rank_tolerance<double>())) return false;
    R_(k, k) = length;
    Q_.col(k) /= length;
    for (int j = k + 1; j < m; ++j) take_out(k, j);
  }
  largest_pivot_ = std::max(largest_pivot_, R_(m - 1, m - 1));
  distance_ = R_(m - 1, m - 1) / largest_pivot_;
  return true;
}

void ContactDynamics::take_out(int k, int j) {
  const double part = Q_.col(k).dot(Q_.col(j));
  R_(k, j) += part;
  Q_.col(j) -= part * Q_.col(k);
}

// R^T w = c, over the sizes of the constraints.
void ContactDynamics::along(const Eigen::VectorXd& c) {
  for (Eigen::Index k = 0; k < c.size(); ++k) {
    const int i = order_[static_cast<std::size_t>(k)];
    w_(k) = c(i) * over_(i);
  }
  R_.transpose().triangularView<Eigen::Lower>().solveInPlace(w_);
}

// The x of least x^T M x with A x = -c.
void ContactDynamics::least_change(const Eigen::VectorXd& c, Eigen::VectorXd& x) {
  along(c);
  x.noalias() = Q_ * w_;
  mass_.matrixU().solveInPlace(x);
  x *= -1;
}

}  // namespace torsor::runtime
