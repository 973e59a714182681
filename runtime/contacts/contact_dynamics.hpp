// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Cholesky>
#include <vector>

#include "torsor/runtime/contacts/contact_system.hpp"

namespace torsor::runtime {

/// Accelerations without reactions and answers to impulses, loop constraints held: a = a0 + K J^T r,
/// K = M^-1 - M^-1 A^T (A M^-1 A^T)^-1 A M^-1. What puts the loops back on their constraints with the least change, in
/// the metric of the masses: closing = -M^-1 A^T (A M^-1 A^T)^-1 f, and the same of the velocities. Nothing is allocated
/// after the first reading.
///
/// With M = L L^T all comes from orthogonal factors L^-1 A^T = Q R and from L^-1 J^T without its part in Q. A M^-1 A^T would
/// square what masses far apart do to the digits: of a light link between heavy ones it loses all of them.
class ContactDynamics {
 public:
  /// Accelerations and closing; false where the mass matrix or the constraints have lost rank.
  [[nodiscard]] bool compute(const ContactReading& reading);
  /// Answers to impulses at the reading computed last; false where they are not finite.
  [[nodiscard]] bool respond(const ContactReading& reading);
  /// Adds the answer K J^T r to impulses, or to reactions, of all rows.
  void add_answer(const ContactVector& impulses, Eigen::VectorXd& to);
  /// How far the reading computed last is from where constraints lose rank, as branches of a loop meet: the last pivot of
  /// L^-1 A^T over the largest that was read, each constraint over its largest length. 1 where all is regular.
  [[nodiscard]] double distance() const noexcept { return distance_; }
  /// Back to what is known before the first reading.
  void forget() noexcept;

  Eigen::VectorXd a0;       ///< without reactions
  Eigen::VectorXd KF;       ///< the same where constraints hold velocities: a0 but for γ
  Eigen::VectorXd closing, closing_rate;
  Eigen::MatrixXd W;        ///< Delassus' matrix J K J^T
  Eigen::MatrixXd AKJ;      ///< (A M^-1 A^T)^-1 A M^-1 J^T: what closing a rate of the loops does to the rows of J
  Eigen::MatrixXd S;        ///< reactions of joints are R = S r + R_free
  Eigen::VectorXd R_free;

 private:
  [[nodiscard]] bool orthogonalise(const Eigen::MatrixXd& A);
  void take_out(int k, int j);
  void along(const Eigen::VectorXd& c);
  void least_change(const Eigen::VectorXd& c, Eigen::VectorXd& x);

  Eigen::LLT<Eigen::MatrixXd> mass_;
  Eigen::MatrixXd LJ_;  ///< L^-1 J^T without its part in Q: W is its square
  Eigen::MatrixXd Q_, R_, part_, LB_;
  Eigen::VectorXd answer_;
  std::vector<int> order_;      ///< of the columns of Q: which constraint
  Eigen::VectorXd longest_, over_;  ///< largest size of each constraint that was read, and one over it
  double distance_ = 1, largest_pivot_ = 0;
  Eigen::VectorXd w_, lambda_;  ///< λ without reactions of contacts
  Eigen::VectorXd lengths_;     ///< of the columns of L^-1 J^T
};

}  // namespace torsor::runtime
