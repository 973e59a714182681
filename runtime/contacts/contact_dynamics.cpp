// SPDX-License-Identifier: MIT
#include "runtime/contacts/contact_dynamics.hpp"

namespace torsor::runtime {

bool ContactDynamics::compute(const ContactReading& reading) {
  mass_.compute(reading.M);
  if (mass_.info() != Eigen::Success) return false;
  KF = reading.F;
  mass_.solveInPlace(KF);
  closing.setZero(reading.F.size());
  closing_rate.setZero(reading.F.size());
  if (reading.A.rows() == 0) {
    a0 = KF;
    R_free = reading.R0;
    R_free.noalias() += reading.B * a0;
    return a0.allFinite();
  }
  Y_ = reading.A.transpose();
  mass_.solveInPlace(Y_);
  S_.noalias() = reading.A * Y_;
  schur_.compute(S_);
  if (schur_.info() != Eigen::Success) return false;
  // Each asks for a change of velocity M^-1 A^T (A M^-1 A^T)^-1 times what it leaves of the constraints.
  right_.noalias() = reading.A * KF;
  schur_.solveInPlace(right_);
  KF.noalias() -= Y_ * right_;
  a0 = KF;
  lambda_ = -right_;
  right_ = reading.gamma;
  schur_.solveInPlace(right_);
  lambda_ -= right_;
  a0.noalias() -= Y_ * right_;
  R_free = reading.R0;
  if (R_free.size() > 0) {
    R_free.noalias() += reading.B * a0;
    R_free.noalias() += reading.D * lambda_;
  }
  right_ = reading.value;
  schur_.solveInPlace(right_);
  closing.noalias() -= Y_ * right_;
  right_ = reading.rate;
  schur_.solveInPlace(right_);
  closing_rate.noalias() -= Y_ * right_;
  return a0.allFinite();
}

bool ContactDynamics::respond(const ContactReading& reading) {
  KJ = reading.J.transpose();
  mass_.solveInPlace(KJ);
  if (reading.A.rows() > 0) {
    AKJ.noalias() = reading.A * KJ;
    schur_.solveInPlace(AKJ);
    KJ.noalias() -= Y_ * AKJ;
  }
  W.noalias() = reading.J * KJ;
  if (reading.R0.size() > 0) {
    S = reading.C;
    S.noalias() += reading.B * KJ;
    if (reading.A.rows() > 0) S.noalias() -= reading.D * AKJ;
  }
  return W.allFinite();
}

}  // namespace torsor::runtime
