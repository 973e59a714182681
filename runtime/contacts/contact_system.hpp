// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <concepts>
#include <cstddef>

#include "runtime/contacts/contact_problem.hpp"
#include "runtime/status.hpp"

namespace torsor::runtime {

/// What a surface is made of: the coefficients of one contact.
struct ContactRule {
  int tangents = 2;             ///< 0: a stop, 1: in the plane, 2: in space
  bool normal = true;           ///< false: dry friction in a joint, bounded by `bound`
  double friction = 0;          ///< f while it slides
  double static_friction = -1;  ///< f_s while it sticks; below 0: f
  double bound = 0;             ///< b [N]: |T| <= f N + b
  double static_bound = -1;     ///< below 0: b
  double restitution = 0;       ///< e, in [0, 1]

  [[nodiscard]] int rows() const noexcept { return (normal ? 1 : 0) + tangents; }
  [[nodiscard]] double sticking() const noexcept { return static_friction < 0 ? friction : static_friction; }
  [[nodiscard]] double sticking_bound() const noexcept { return static_bound < 0 ? bound : static_bound; }
};

/// A mechanism with contacts at one state: M a = F + J^T r + A^T λ, w = J v + b, dw/dt = J a + drift, A a + γ = 0. The
/// rows of J are contact by contact, the normal first (n from the other body to this one, so that w_N > 0 opens), then
/// the tangents.
template <int nv, int contacts, int constraints = 0>
struct ContactReading {
  static constexpr int rows = 3 * contacts;
  Eigen::Matrix<double, nv, nv> M;
  Eigen::Matrix<double, nv, 1> F;
  std::array<double, static_cast<std::size_t>(contacts)> gap{};
  Eigen::Matrix<double, Eigen::Dynamic, nv, nv == 1 ? Eigen::ColMajor : Eigen::RowMajor, rows, nv> J;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, rows, 1> w, drift;
  Eigen::Matrix<double, constraints, nv> A;
  Eigen::Matrix<double, constraints, 1> gamma;
};

/// What the non-smooth layer asks of a mechanism: sizes, rules, and its reading at a state y = [q; v].
template <class S>
concept ContactSystem = requires(const S& system, double t, const std::array<double, S::nq + S::nv>& y,
                                 std::array<double, S::nq>& rates, typename S::Reading& reading) {
  { system.rule(0) } -> std::convertible_to<ContactRule>;
  { system.read(t, y, reading) } -> std::same_as<Evaluation>;
  system.coordinate_rates(t, y, rates);
};

/// Accelerations without reactions and answers to impulses, loop constraints held: a = a0 + K J^T r,
/// K = M^-1 - M^-1 A^T (A M^-1 A^T)^-1 A M^-1.
template <class Reading>
class ContactDynamics {
 public:
  static constexpr int nv = decltype(Reading::M)::ColsAtCompileTime;
  static constexpr int constraints = decltype(Reading::A)::RowsAtCompileTime;

  /// False where the mass matrix or the constraints have lost rank.
  [[nodiscard]] bool compute(const Reading& reading) noexcept {
    const Eigen::LLT<Eigen::Matrix<double, nv, nv>> mass(reading.M);
    if (mass.info() != Eigen::Success) return false;
    K.setIdentity();
    mass.solveInPlace(K);
    a0 = mass.solve(reading.F);
    if constexpr (constraints > 0) {
      const Eigen::Matrix<double, nv, constraints> Y = mass.solve(reading.A.transpose());
      const Eigen::Matrix<double, constraints, constraints> S = reading.A * Y;
      const Eigen::LLT<Eigen::Matrix<double, constraints, constraints>> schur(S);
      if (schur.info() != Eigen::Success) return false;
      const Eigen::Matrix<double, constraints, 1> off = reading.A * a0 + reading.gamma;
      a0 -= Y * schur.solve(off);
      K -= Y * schur.solve(Y.transpose());
    }
    KJ = K * reading.J.transpose();
    W = reading.J * KJ;
    return a0.allFinite() && W.allFinite();
  }

  Eigen::Matrix<double, nv, nv> K;
  Eigen::Matrix<double, nv, 1> a0;
  Eigen::Matrix<double, nv, Eigen::Dynamic, nv == 1 ? Eigen::RowMajor : Eigen::ColMajor, nv, Reading::rows> KJ;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Reading::rows, Reading::rows> W;
};

}  // namespace torsor::runtime
