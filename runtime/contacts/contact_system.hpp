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
  bool normal = true;           ///< false: dry friction in a joint, bounded by `bound`, or resistance to rolling
  int pressed_by = -1;          ///< of resistance to rolling or spinning: the contact, earlier in order, that rolls
  double friction = 0;          ///< f while it slides; of resistance to rolling a length [m]
  double static_friction = -1;  ///< f_s while it sticks; below 0: f
  double bound = 0;             ///< b [N]: |T| <= f N + b
  double static_bound = -1;     ///< below 0: b
  double restitution = 0;       ///< e, in [0, 1]

  [[nodiscard]] int rows() const noexcept { return (normal ? 1 : 0) + tangents; }
  /// Whether the rule of a contact, by its place among all, says what is possible; a number that is none is not.
  [[nodiscard]] bool valid(int contact) const noexcept {
    return friction >= 0 && sticking() >= friction && bound >= 0 && sticking_bound() >= bound && restitution >= 0 &&
           restitution <= 1 && tangents >= 0 && tangents <= 2 && rows() > 0 &&
           (pressed_by < 0 || (!normal && pressed_by < contact));
  }
  [[nodiscard]] double sticking() const noexcept { return static_friction < 0 ? friction : static_friction; }
  [[nodiscard]] double sticking_bound() const noexcept { return static_bound < 0 ? bound : static_bound; }
};

/// Whether the rule of a contact is possible, and what presses it a contact with a normal force.
template <class S>
[[nodiscard]] bool valid_rule(const S& system, int contact) noexcept {
  const ContactRule rule = system.rule(contact);
  return rule.valid(contact) && (rule.pressed_by < 0 || system.rule(rule.pressed_by).normal);
}

/// A mechanism with contacts at one state: M a = F + J^T r + A^T λ, w = J v + b, dw/dt = J a + drift, A a + γ = 0. The
/// rows of J are contact by contact, the normal first (n from the other body to this one, so that w_N > 0 opens), then
/// the tangents. Of each constraint too: f(q, t), 0 where it is not holonomic, and its rate A v - b.
template <int nv_, int contacts, int constraints_ = 0>
struct ContactReading {
  static constexpr int nv = nv_, rows = 3 * contacts, constraints = constraints_;  ///< of each the most there may be
  static constexpr int held = constraints > 0 ? constraints : 1;
  Eigen::Matrix<double, nv, nv> M;
  Eigen::Matrix<double, nv, 1> F;
  std::array<double, static_cast<std::size_t>(contacts)> gap{};
  Eigen::Matrix<double, Eigen::Dynamic, nv, nv == 1 ? Eigen::ColMajor : Eigen::RowMajor, rows, nv> J;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, rows, 1> w, drift;
  Eigen::Matrix<double, Eigen::Dynamic, nv, nv == 1 ? Eigen::ColMajor : Eigen::RowMajor, held, nv> A;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, held, 1> gamma, value, rate;
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
/// K = M^-1 - M^-1 A^T (A M^-1 A^T)^-1 A M^-1. What puts the loops back on their constraints with the least change, in
/// the metric of the masses: closing = -M^-1 A^T (A M^-1 A^T)^-1 f, and the same of the velocities.
template <class Reading>
class ContactDynamics {
 public:
  static constexpr int nv = Reading::nv, constraints = Reading::constraints;
  using Velocity = Eigen::Matrix<double, nv, 1>;

  template <int most>
  using Wide = Eigen::Matrix<double, nv, Eigen::Dynamic, nv == 1 ? Eigen::RowMajor : Eigen::ColMajor, nv, most>;

  /// False where the mass matrix or the constraints have lost rank.
  [[nodiscard]] bool compute(const Reading& reading) noexcept {
    const Eigen::LLT<Eigen::Matrix<double, nv, nv>> mass(reading.M);
    if (mass.info() != Eigen::Success) return false;
    K.setIdentity();
    mass.solveInPlace(K);
    a0 = mass.solve(reading.F);
    closing.setZero();
    closing_rate.setZero();
    if constexpr (constraints > 0) {
      using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, constraints, constraints>;
      using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, constraints, 1>;
      if (reading.A.rows() > 0) {
        const Wide<constraints> Y = mass.solve(reading.A.transpose());
        const Square S = reading.A * Y;
        const Eigen::LLT<Square> schur(S);
        if (schur.info() != Eigen::Success) return false;
        const Few off = reading.A * a0 + reading.gamma;
        a0 -= Y * schur.solve(off);
        K -= Y * schur.solve(Y.transpose());
        closing = -Y * schur.solve(reading.value);
        closing_rate = -Y * schur.solve(reading.rate);
      }
    }
    KJ = K * reading.J.transpose();
    W = reading.J * KJ;
    return a0.allFinite() && W.allFinite();
  }

  Eigen::Matrix<double, nv, nv> K;
  Velocity a0, closing, closing_rate;
  Wide<Reading::rows> KJ;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Reading::rows, Reading::rows> W;
};

}  // namespace torsor::runtime
