// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "torsor/runtime/contacts/contact_motion.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/numerics/lu.hpp"

namespace torsor::runtime {

/// A mechanism generated with the kernels that derivatives of a motion with contacts follow from.
template <class M>
concept HasContactDerivatives =
    HasContacts<M> && requires(const typename M::Precomputed& precomputed, const typename M::State& state,
                               const typename M::Accelerations& a, const typename M::Multipliers& lambda,
                               const typename M::Inputs& inputs, typename M::ContactMotionDerivatives& of_motion,
                               typename M::ContactRowDerivatives& of_rows) {
  M::contact_motion_derivatives(precomputed, state, a, lambda, inputs, of_motion);
  M::contact_row_derivatives(precomputed, state, a, of_rows);
};

/// Whether accelerations have derivatives in the present regimes, or why not.
enum class ContactDerivativesStatus { ok, slip_without_direction, several_reactions, reaction_of_a_joint, singular, not_finite };

[[nodiscard]] constexpr std::string_view describe(ContactDerivativesStatus status) noexcept {
  switch (status) {
    case ContactDerivativesStatus::ok:
      return "accelerations have derivatives";
    case ContactDerivativesStatus::slip_without_direction:
      return "derivatives of accelerations are not given where a slip begins or ends";
    case ContactDerivativesStatus::several_reactions:
      return "derivatives of accelerations are not given where reactions are not unique";
    case ContactDerivativesStatus::reaction_of_a_joint:
      return "derivatives of accelerations are not given where friction is in proportion to a joint's reaction, and that is zero";
    case ContactDerivativesStatus::singular:
      return "derivatives of accelerations are not given where the equations of the regimes are singular";
    case ContactDerivativesStatus::not_finite:
      return "derivatives of accelerations are not given where the equations of the regimes are not finite";
  }
  return "unknown status";
}

/// Exact derivatives of the accelerations of a motion with contacts while its regimes last, by states, inputs and parameters.
/// The motion fulfils M a + h = E u + A^T λ + J^T r, A a + γ = 0 and for each row of J one more equation: its reaction is zero
/// where a contact is open, J a + drift is zero where it is held, and T = -(f N + b) d where it slides. Changes of (a, λ, r)
/// solve the same equations, linearised. d turns with the velocity of the slip: δd = (1 - d d^T) δw/|w|. Of a joint that rubs in
/// proportion to its reaction R = B a + C r + D λ + R0, N is |R|, and δ|R| = R/|R| · δR.
template <HasContactDerivatives M>
class ContactDerivatives {
 public:
  static constexpr std::size_t freedoms = velocities_of<M>, rows = static_cast<std::size_t>(M::contact_row_count),
                               contacts = static_cast<std::size_t>(M::contact_count),
                               inputs = static_cast<std::size_t>(M::input_count),
                               parameters = static_cast<std::size_t>(M::parameter_count),
                               multipliers = static_cast<std::size_t>(M::multiplier_count);
  /// Components of the reactions of joints.
  static constexpr std::size_t bearings = [] {
    std::size_t count = 0;
    if constexpr (requires { M::contact_bearings; }) {
      for (const auto each : M::contact_bearings) count += static_cast<std::size_t>(each);
    }
    return count;
  }();
  static constexpr std::size_t held = static_cast<std::size_t>(kept_constraints<M>()), all = freedoms + held + rows;

  /// Of the state that the motion was solved for last. After another answer than `ok` there is no `along`.
  [[nodiscard]] ContactDerivativesStatus compute(const ContactMotion& motion, const typename M::Precomputed& precomputed,
                                                 const typename M::State& state, const typename M::Inputs& u) noexcept {
    contact_ = -1;
    for (int i = 0; i < motion.count(); ++i) {
      if (!slides(motion, i)) {
        if (motion.states[as(i)].touches && motion.undetermined(i)) return refuse(ContactDerivativesStatus::several_reactions, i);
        continue;
      }
      if (motion.undetermined(i)) return refuse(ContactDerivativesStatus::several_reactions, i);
      if (motion.rule(i).bearing > 0 && !has_reaction(motion, i)) {
        return refuse(ContactDerivativesStatus::reaction_of_a_joint, i);
      }
      if (!motion.turns_with_velocity(i)) return refuse(ContactDerivativesStatus::slip_without_direction, i);
    }
    equate(motion);
    const Evaluation factorised = equations_.factorise();
    if (factorised == Evaluation::not_finite) return ContactDerivativesStatus::not_finite;
    if (factorised != Evaluation::ok || equations_.smallest_pivot() < least_pivot) return ContactDerivativesStatus::singular;
    solve_motion(motion);
    M::contact_motion_derivatives(precomputed, state, a_, lambda_, u, of_motion_);
    add_reactions(motion, precomputed, state);
    return ContactDerivativesStatus::ok;
  }

  /// Of which contact the last answer was; -1: of none.
  [[nodiscard]] int contact() const noexcept { return contact_; }

  /// The change of accelerations for a displacement along the freedoms and changes of velocities, inputs and parameters.
  void along(const double* dq, const double* dv, const double* du, const double* dp, double* da) const noexcept {
    typename Equations::Vector right{};
    std::array<double, rows> rates{}, accelerations{};
    for (std::size_t i = 0; i < freedoms; ++i) {
      right[i] = sum<freedoms>(pull_by_position_, freedoms, i, dq);
      right[i] -= sum<freedoms>(of_motion_.residual_by_position, freedoms, i, dq);
      right[i] -= sum<freedoms>(of_motion_.residual_by_velocity, freedoms, i, dv);
      if constexpr (inputs > 0) right[i] -= sum<inputs>(of_motion_.residual_by_input, freedoms, i, du);
      if constexpr (parameters > 0) {
        right[i] += sum<parameters>(pull_by_parameter_, freedoms, i, dp);
        right[i] -= sum<parameters>(of_motion_.residual_by_parameter, freedoms, i, dp);
      }
    }
    if constexpr (held > 0) {
      std::size_t row = freedoms;
      for (std::size_t k = 0; k < multipliers; ++k) {
        if (repeats_others(k)) continue;
        right[row] -= sum<freedoms>(of_motion_.constraint_by_position, multipliers, k, dq);
        right[row] -= sum<freedoms>(of_motion_.constraint_by_velocity, multipliers, k, dv);
        if constexpr (parameters > 0) right[row] -= sum<parameters>(of_motion_.constraint_by_parameter, multipliers, k, dp);
        ++row;
      }
    }
    for (std::size_t k = 0; k < rows; ++k) {
      accelerations[k] = sum<freedoms>(of_motion_.row_by_position, rows, k, dq);
      accelerations[k] += sum<freedoms>(of_motion_.row_by_velocity, rows, k, dv);
      rates[k] = sum<freedoms>(of_motion_.rate_by_position, rows, k, dq);
      rates[k] += sum<freedoms>(of_motion_.rate_by_velocity, rows, k, dv);
      if constexpr (parameters > 0) {
        accelerations[k] += sum<parameters>(of_motion_.row_by_parameter, rows, k, dp);
        rates[k] += sum<parameters>(of_motion_.rate_by_parameter, rows, k, dp);
      }
      if (is_held_[k]) right[freedoms + held + k] = -accelerations[k];
    }
    std::array<double, bearings> of_joints{};
    for (std::size_t k = 0; k < bearings; ++k) {
      of_joints[k] = sum<freedoms>(bearing_by_position_, bearings, k, dq);
      if constexpr (bearings > 0) of_joints[k] += sum<freedoms>(of_motion_.bearing_by_velocity, bearings, k, dv);
      if constexpr (parameters > 0) of_joints[k] += sum<parameters>(bearing_by_parameter_, bearings, k, dp);
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      const Slip& slip = slips_[i];
      if (!slip.slides) continue;
      double pull = 0;
      for (std::size_t k = 0; k < slip.bearing; ++k) pull += slip.pull_by_bearing[k] * of_joints[slip.first_bearing + k];
      if constexpr (parameters > 0) {
        pull += sum<parameters>(of_motion_.friction_by_parameter, contacts, i, dp) * slip.pressing +
                sum<parameters>(of_motion_.bound_by_parameter, contacts, i, dp);
      }
      double along_slip = 0;
      for (std::size_t k = 0; k < slip.tangents; ++k) along_slip += slip.direction[k] * rates[slip.row + k];
      for (std::size_t k = 0; k < slip.tangents; ++k) {
        double turn = 0;
        if (slip.tangents > 1) turn = slip.pull_over_speed * (rates[slip.row + k] - slip.direction[k] * along_slip);
        right[freedoms + held + slip.row + k] = -pull * slip.direction[k] - turn;
      }
    }
    solve(right);
    std::copy_n(right.begin(), freedoms, da);
  }

 private:
  using Equations = Lu<double, all>;

  /// The square root of a rounding, of equations whose rows and columns have size 1. Reactions grow with one over the pivot as a
  /// slip comes to where it jams, and their changes with its square: below, no digit of the accelerations' changes is left.
  static constexpr double least_pivot = 0x1p-26;

  /// What a contact that slides adds to the equations.
  struct Slip {
    bool slides = false;
    std::size_t row = 0, tangents = 0;  ///< of its tangents
    std::array<double, 2> direction{};
    double pressing = 0;         ///< N, or |R|
    double pull_over_speed = 0;  ///< (f N + b)/w, w the velocity along the direction, which may be opposite to it
    std::size_t bearing = 0, first_bearing = 0;  ///< components of R
    std::array<double, 2> pull_by_bearing{};     ///< f R/|R|
  };

  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  static constexpr Eigen::Index at(std::size_t i) noexcept { return static_cast<Eigen::Index>(i); }

  static constexpr bool repeats_others([[maybe_unused]] std::size_t constraint) noexcept {
    if constexpr (HasRedundantConstraints<M>) {
      for (const int each : M::redundant_multipliers) {
        if (static_cast<std::size_t>(each) == constraint) return true;
      }
    }
    return false;
  }

  static bool slides(const ContactMotion& motion, int i) noexcept {
    const ContactState& state = motion.states[as(i)];
    return state.touches && state.regime == ContactRegime::slides && motion.rule(i).tangents > 0;
  }

  /// Row i of a matrix that is stored column by column, times a change. What does not change takes no part, also where its slope
  /// has no bound, as that of sqrt(p) at 0.
  template <std::size_t columns, class Matrix>
  static double sum(const Matrix& matrix, std::size_t height, std::size_t i, const double* change) noexcept {
    double total = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      if (change[j] != 0) total += matrix[j * height + i] * change[j];
    }
    return total;
  }

  /// Whether R is more than rounding of its terms, so that it has a direction.
  static bool has_reaction(const ContactMotion& motion, int i) noexcept {
    double terms = 0;
    for (int k = motion.first_bearing(i); k < motion.first_bearing(i + 1); ++k) {
      terms += motion.dynamics().S.row(k).cwiseAbs().dot(motion.reactions().cwiseAbs()) + std::abs(motion.dynamics().R_free(k));
    }
    return motion.pressing(i) > 1e-12 * terms;
  }

  ContactDerivativesStatus refuse(ContactDerivativesStatus status, int contact) noexcept {
    contact_ = contact;
    return status;
  }

  /// The equations of the motion and of its changes, each row over its size, then each column.
  void equate(const ContactMotion& motion) noexcept {
    const ContactReading& reading = motion.reading();
    auto& matrix = equations_.matrix();
    matrix.fill(0);
    is_held_.fill(false);
    slips_.fill({});
    const auto entry = [&matrix](std::size_t i, std::size_t j) -> double& { return matrix[j * all + i]; };
    for (std::size_t j = 0; j < freedoms; ++j) {
      for (std::size_t i = 0; i < freedoms; ++i) entry(i, j) = reading.M(at(i), at(j));
      for (std::size_t k = 0; k < held; ++k) {
        entry(j, freedoms + k) = -reading.A(at(k), at(j));
        entry(freedoms + k, j) = reading.A(at(k), at(j));
      }
      for (std::size_t k = 0; k < rows; ++k) entry(j, freedoms + held + k) = -reading.J(at(k), at(j));
    }
    for (int i = 0; i < motion.count(); ++i) equate(motion, i, entry);
    for (std::size_t i = 0; i < all; ++i) {
      double largest = 0;
      for (std::size_t j = 0; j < all; ++j) largest = std::max(largest, std::abs(entry(i, j)));
      over_[i] = largest > 0 ? 1 / largest : 1;
      for (std::size_t j = 0; j < all; ++j) entry(i, j) *= over_[i];
    }
    for (std::size_t j = 0; j < all; ++j) {
      double largest = 0;
      for (std::size_t i = 0; i < all; ++i) largest = std::max(largest, std::abs(entry(i, j)));
      units_[j] = largest > 0 ? 1 / largest : 1;
      for (std::size_t i = 0; i < all; ++i) entry(i, j) *= units_[j];
    }
  }

  void solve(typename Equations::Vector& right) const noexcept {
    for (std::size_t i = 0; i < all; ++i) right[i] *= over_[i];
    equations_.solve(right);
    for (std::size_t i = 0; i < all; ++i) right[i] *= units_[i];
  }

  template <class Entry>
  void equate(const ContactMotion& motion, int i, const Entry& entry) noexcept {
    constexpr std::size_t first = freedoms + held;
    const ContactState& state = motion.states[as(i)];
    const ContactRule rule = motion.rule(i);
    const std::size_t tangent = as(motion.tangent_row(i)), tangents = as(rule.tangents);
    const auto hold = [&](std::size_t row) {
      is_held_[row] = true;
      for (std::size_t j = 0; j < freedoms; ++j) entry(first + row, j) = motion.reading().J(at(row), at(j));
    };
    const auto leave = [&](std::size_t row) { entry(first + row, first + row) = 1; };
    if (rule.normal) state.touches ? hold(tangent - 1) : leave(tangent - 1);
    const bool sticks = state.touches && state.regime == ContactRegime::sticks;
    for (std::size_t k = tangent; k < tangent + tangents; ++k) sticks ? hold(k) : leave(k);
    if (!slides(motion, i)) return;
    Slip& slip = slips_[as(i)];
    slip = {.slides = true, .row = tangent, .tangents = tangents, .direction = motion.direction(i)};
    slip.pressing = motion.pressing(i);
    double speed = 0;
    for (std::size_t k = 0; k < tangents; ++k) speed += slip.direction[k] * motion.reading().w(at(tangent + k));
    if (tangents > 1) slip.pull_over_speed = (rule.friction * slip.pressing + rule.bound) / speed;
    if (rule.bearing > 0) {
      slip.bearing = as(rule.bearing);
      slip.first_bearing = as(motion.first_bearing(i));
      const auto R = motion.bearing(i);
      for (std::size_t k = 0; k < slip.bearing; ++k) slip.pull_by_bearing[k] = rule.friction * R[k] / slip.pressing;
      for (std::size_t k = 0; k < tangents; ++k) press_by_joint(motion.reading(), slip, k, entry);
      return;
    }
    const std::optional<int> by = motion.carrier(i);
    if (!by || !motion.states[as(*by)].touches) return;
    for (std::size_t k = 0; k < tangents; ++k) {
      entry(first + tangent + k, first + as(motion.first_row(*by))) = rule.friction * slip.direction[k];
    }
  }

  /// T + f |R| d = -b d, with |R| = R/|R| · R.
  template <class Entry>
  static void press_by_joint(const ContactReading& reading, const Slip& slip, std::size_t tangent, const Entry& entry) noexcept {
    constexpr std::size_t first = freedoms + held;
    const std::size_t row = first + slip.row + tangent;
    for (std::size_t k = 0; k < slip.bearing; ++k) {
      const double pull = slip.pull_by_bearing[k] * slip.direction[tangent];
      const Eigen::Index from = at(slip.first_bearing + k);
      for (std::size_t j = 0; j < freedoms; ++j) entry(row, j) += pull * reading.B(from, at(j));
      for (std::size_t j = 0; j < held; ++j) entry(row, freedoms + j) += pull * reading.D(from, at(j));
      for (std::size_t j = 0; j < rows; ++j) entry(row, first + j) += pull * reading.C(from, at(j));
    }
  }

  /// Accelerations and multipliers, as the same equations give them.
  void solve_motion(const ContactMotion& motion) noexcept {
    const ContactReading& reading = motion.reading();
    typename Equations::Vector right{};
    for (std::size_t i = 0; i < freedoms; ++i) right[i] = reading.F(at(i));
    for (std::size_t k = 0; k < held; ++k) right[freedoms + k] = -reading.gamma(at(k));
    for (std::size_t k = 0; k < rows; ++k) {
      if (is_held_[k]) right[freedoms + held + k] = -reading.drift(at(k));
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      const Slip& slip = slips_[i];
      if (!slip.slides) continue;
      double pull = motion.rule(static_cast<int>(i)).bound;
      for (std::size_t k = 0; k < slip.bearing; ++k) pull += slip.pull_by_bearing[k] * reading.R0(at(slip.first_bearing + k));
      for (std::size_t k = 0; k < slip.tangents; ++k) right[freedoms + held + slip.row + k] = -pull * slip.direction[k];
    }
    solve(right);
    for (std::size_t i = 0; i < freedoms; ++i) a_[static_cast<int>(i)] = right[i];
    if constexpr (multipliers > 0) {
      std::size_t row = freedoms;
      for (std::size_t k = 0; k < multipliers; ++k) lambda_[static_cast<int>(k)] = repeats_others(k) ? 0 : right[row++];
    }
  }

  /// Derivatives of J^T r and of C r at fixed reactions: those of entry i of the first are r · ∂(J e_i).
  void add_reactions(const ContactMotion& motion, const typename M::Precomputed& precomputed,
                     const typename M::State& state) noexcept {
    pull_by_position_.fill(0);
    pull_by_parameter_.fill(0);
    const ContactVector& r = motion.reactions();
    if constexpr (bearings > 0) {
      bearing_by_position_ = of_motion_.bearing_by_position;
      add_rows(of_motion_.bearing_rows_by_position, r, freedoms, bearing_by_position_);
      if constexpr (parameters > 0) {
        bearing_by_parameter_ = of_motion_.bearing_by_parameter;
        add_rows(of_motion_.bearing_rows_by_parameter, r, parameters, bearing_by_parameter_);
      }
    }
    if (r.isZero(0)) return;
    typename M::Accelerations unit{};
    for (std::size_t i = 0; i < freedoms; ++i) {
      unit[static_cast<int>(i)] = 1;
      M::contact_row_derivatives(precomputed, state, unit, of_rows_);
      unit[static_cast<int>(i)] = 0;
      for (std::size_t k = 0; k < rows; ++k) {
        if (r(at(k)) == 0) continue;
        for (std::size_t j = 0; j < freedoms; ++j) {
          pull_by_position_[j * freedoms + i] += r(at(k)) * of_rows_.by_position[j * rows + k];
        }
        if constexpr (parameters > 0) {
          for (std::size_t j = 0; j < parameters; ++j) {
            pull_by_parameter_[j * freedoms + i] += r(at(k)) * of_rows_.by_parameter[j * rows + k];
          }
        }
      }
    }
  }

  /// To each component of R the changes of its row of C, times r.
  template <class Matrix, class Sum>
  static void add_rows(const Matrix& of_rows, const ContactVector& r, std::size_t columns, Sum& sum) noexcept {
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < bearings; ++i) {
        for (std::size_t k = 0; k < rows; ++k) {
          if (r(at(k)) != 0) sum[j * bearings + i] += of_rows[(j * bearings + i) * rows + k] * r(at(k));
        }
      }
    }
  }

  Equations equations_;
  typename Equations::Vector over_{};   ///< one over the size of each row
  typename Equations::Vector units_{};  ///< of each unknown: one over the size of its column
  std::array<bool, rows> is_held_{};
  std::array<Slip, contacts> slips_{};
  typename M::Accelerations a_{};
  typename M::Multipliers lambda_{};
  typename M::ContactMotionDerivatives of_motion_{};
  typename M::ContactRowDerivatives of_rows_{};
  std::array<double, freedoms * freedoms> pull_by_position_{};
  std::array<double, freedoms * parameters> pull_by_parameter_{};
  std::array<double, bearings * freedoms> bearing_by_position_{};
  std::array<double, bearings * parameters> bearing_by_parameter_{};
  int contact_ = -1;
};

}  // namespace torsor::runtime
