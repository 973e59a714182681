// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "runtime/contacts/contact_system.hpp"
#include "runtime/contacts/regime_system.hpp"
#include "runtime/contacts/slip_direction.hpp"

namespace torsor::runtime {

/// What the automaton knows of one contact between events.
struct ContactState {
  bool touches = false;  ///< gap and its rate are zero; always so of dry friction
  ContactRegime regime = ContactRegime::open;
  std::array<double, 2> direction{1, 0};  ///< of slip, while it slides
  double fastest = 0;                     ///< the largest slip since it slides [m/s]
  bool begins = false;                    ///< its slip has just begun: the direction follows from forces
  double begun = 0;                       ///< when [s]
  bool fades = false;                     ///< its slip has been near its end, and is followed through it
  double force_slack = 0;                 ///< [N] it was decided with N, or what is left of its bound, zero to rounding
};

/// y' = f(t, y) of a mechanism while the regimes of its contacts last: closed contacts keep w_N = 0, sticking ones w_T
/// = 0, and sliding ones have T = -(f N + b) d, d the direction of the slip w_T. Settling puts gaps and these
/// velocities back to zero, in the metric of the masses.
///
/// In space w_T passes through zero without a change of sign. So d is followed from step to step: s = d_last · w_T
/// changes sign where the slip ends, and beyond it d = sign(s) w_T/|w_T| goes on smoothly. Near s = 0, where w_T is
/// rounding, d is d_last. A slip that has just begun has its direction from the forces (slip_direction.hpp) until it
/// has a speed: equations with d = w_T/|w_T| are too stiff before.
template <ContactSystem S>
class ContactMotion {
 public:
  static constexpr std::size_t nq = S::nq, nv = S::nv;
  static constexpr int contacts = static_cast<int>(S::contacts);
  using Vector = std::array<double, nq + nv>;
  using Reading = typename S::Reading;
  using Problem = ContactProblem<contacts>;
  using States = std::array<ContactState, S::contacts>;
  using Forces = typename Problem::Vector;

  explicit ContactMotion(const S& system) noexcept : system_(system) {}

  States states{};

  [[nodiscard]] Evaluation operator()(double t, const Vector& y, Vector& dydt) noexcept {
    const Evaluation evaluation = solve(t, y);
    std::array<double, nq> rates{};
    system_.coordinate_rates(t, y, rates);
    std::copy(rates.begin(), rates.end(), dydt.begin());
    for (std::size_t i = 0; i < nv; ++i) dydt[nq + i] = a_(static_cast<Eigen::Index>(i));
    return evaluation;
  }

  /// Loops, gaps of closed contacts, their velocities and those of sticking ones back to zero.
  [[nodiscard]] Evaluation project(double t, Vector& y) noexcept {
    bool any = Reading::constraints > 0;
    for (int i = 0; i < contacts; ++i) any = any || at(i).touches;
    if (!any) return Evaluation::ok;
    for (int step = 0; step < 3; ++step) {
      if (!read(t, y)) return Evaluation::singular;
      double worst = dynamics_.closing.cwiseAbs().maxCoeff();
      select([&](int i, int row, bool normal) {
        if (!normal) return false;
        worst = std::max(worst, std::abs(reading_.gap[as(i)]));
        right_(row) = -reading_.gap[as(i)] - reading_.J.row(row).dot(dynamics_.closing);
        return true;
      });
      if (!(worst > 0)) break;
      const Velocity change = dynamics_.closing + least_change();
      Vector there = y;
      for (std::size_t i = 0; i < nv; ++i) there[nq + i] = change(static_cast<Eigen::Index>(i));
      std::array<double, nq> moved{};
      system_.coordinate_rates(t, there, moved);
      double largest = 0, place = 0;
      for (std::size_t i = 0; i < nq; ++i) {
        y[i] += moved[i];
        largest = std::max(largest, std::abs(moved[i]));
        place = std::max(place, std::abs(y[i]));
      }
      known_ = false;
      if (largest <= 4 * std::numeric_limits<double>::epsilon() * place) break;
    }
    if constexpr (requires { system_.normalise(y); }) system_.normalise(y);
    if (!read(t, y)) return Evaluation::singular;
    select([&](int i, int row, bool normal) {
      right_(row) = -reading_.w(row) - reading_.J.row(row).dot(dynamics_.closing_rate);
      return normal || at(i).regime == ContactRegime::sticks;
    });
    const Velocity change = dynamics_.closing_rate + least_change();
    for (std::size_t i = 0; i < nv; ++i) y[nq + i] += change(static_cast<Eigen::Index>(i));
    known_ = false;
    if (!read(t, y)) return Evaluation::singular;
    follow_directions();
    return Evaluation::ok;
  }

  /// Reads the mechanism at a state; false where it cannot be.
  [[nodiscard]] bool read(double t, const Vector& y) noexcept {
    if (known_ && t == t_ && y == y_) return true;
    known_ = solved_ = false;
    if (!read(t, y, reading_, dynamics_)) return false;
    t_ = t;
    y_ = y;
    return known_ = true;
  }

  /// Accelerations and reactions of the present regimes.
  [[nodiscard]] Evaluation solve(double t, const Vector& y) noexcept {
    if (!read(t, y)) return Evaluation::singular;
    if (solved_) return Evaluation::ok;
    Problem problem = problem_of(reading_, dynamics_);
    typename RegimeSystem<contacts>::Regimes regimes{};
    std::array<bool, S::contacts> begins{};
    bool any = false;
    for (int i = 0; i < contacts; ++i) {
      const ContactState& state = at(i);
      AssumedRegime& regime = regimes[as(i)];
      if (!state.touches) continue;
      regime.pressed = problem.law(i).normal;
      if (problem.law(i).tangents == 0 || state.regime == ContactRegime::open) continue;
      regime.friction =
          state.regime == ContactRegime::sticks ? AssumedRegime::Friction::sticks : AssumedRegime::Friction::slides;
      regime.direction = direction(i);
      begins[as(i)] = follows_forces(i);
      any = any || begins[as(i)];
    }
    if (any) {
      const Evaluation aligned = align(t, y, problem, regimes, begins);
      if (aligned != Evaluation::ok) return aligned;
    }
    RegimeSystem<contacts> equations(problem, regimes);
    if (!equations.solve()) return Evaluation::singular;
    r_ = equations.reactions();
    a_ = dynamics_.a0 + dynamics_.KJ * r_;
    solved_ = true;
    return a_.allFinite() ? Evaluation::ok : Evaluation::not_finite;
  }

  /// A problem of all contacts with the rules' coefficients, and no contact that slips already: of accelerations at a
  /// reading, or with any other motions without reactions.
  [[nodiscard]] Problem problem_of(const Reading& reading, const ContactDynamics<Reading>& dynamics) const noexcept {
    Problem problem = problem_of(reading.J * dynamics.a0 + reading.drift);
    problem.W = dynamics.W;
    return problem;
  }
  template <class Right>
  [[nodiscard]] Problem problem_of(const Right& q) const noexcept {
    Problem problem;
    problem.count = contacts;
    for (int i = 0; i < contacts; ++i) {
      const ContactRule rule = system_.rule(i);
      problem.laws[as(i)] = {.normal = rule.normal,
                             .pressed_by = rule.pressed_by,
                             .tangents = rule.tangents,
                             .friction = rule.friction,
                             .static_friction = rule.sticking(),
                             .bound = rule.bound,
                             .static_bound = rule.sticking_bound()};
    }
    problem.W = dynamics_.W;
    problem.q = q;
    return problem;
  }

  /// Direction of the slip at the state read last.
  [[nodiscard]] std::array<double, 2> direction(int i) const noexcept {
    const ContactRule rule = system_.rule(i);
    const auto& last = at(i).direction;
    if (rule.tangents < 2 || at(i).begins) return last;
    const int t = tangent_row(i);
    const double x = reading_.w(t), y = reading_.w(t + 1), length = std::hypot(x, y);
    if (!(length > std::max(64 * rounding_of(t), 1e-12 * at(i).fastest))) return last;
    const double sign = x * last[0] + y * last[1] < 0 ? -1 : 1;
    return {sign * x / length, sign * y / length};
  }

  /// Direction of the velocity of a slip, whatever is known of it; the last one where it has none.
  [[nodiscard]] std::array<double, 2> velocity_direction(int i) const noexcept {
    const int t = tangent_row(i);
    if (system_.rule(i).tangents < 2) return at(i).direction;
    const double x = reading_.w(t), y = reading_.w(t + 1), length = std::hypot(x, y);
    if (!(length > least_slip(i))) return at(i).direction;
    return {x / length, y / length};
  }

  /// A slip that nears its end: where friction would turn it much faster than it ends, the equations are stiff, and its
  /// direction follows from the forces again.
  void fade(int i, double t, const Vector& y) noexcept {
    ContactState& state = states[as(i)];
    state.fades = state.begins = true;
    state.begun = t;
    changed();
    state.begins = solve(t, y) == Evaluation::ok && stiff_[as(i)];
    changed();
  }

  /// Goes on with that direction, as a slip that has a speed.
  void take_direction(int i) noexcept {
    ContactState& state = states[as(i)];
    state.direction = velocity_direction(i);
    state.begins = false;
    state.fastest = std::max(state.fastest, slip(i));
    changed();
  }

  /// Whether a slip has a velocity across its last direction, beyond what is left of one that ends.
  [[nodiscard]] bool slips_across(int i) const noexcept {
    if (system_.rule(i).tangents < 2) return false;
    const int t = tangent_row(i);
    const double length = std::hypot(reading_.w(t), reading_.w(t + 1));
    return length > std::max(4 * least_slip(i), 1e-11 * at(i).fastest);
  }

  /// d_last · w_T, which falls through zero where the slip ends.
  [[nodiscard]] double slip(int i) const noexcept {
    const int t = tangent_row(i);
    double sum = 0;
    for (int k = 0; k < system_.rule(i).tangents; ++k) sum += at(i).direction[as(k)] * reading_.w(t + k);
    return sum;
  }

  /// A slip below which a contact that begins to slide is as good as at rest: some hundred roundings.
  [[nodiscard]] double least_slip(int i) const noexcept {
    double largest = 0;
    for (int k = 0; k < system_.rule(i).tangents; ++k) largest = std::max(largest, rounding_of(tangent_row(i) + k));
    return 256 * largest;
  }

  /// Falls through zero where a slip that began has got a speed from which equations with d = w_T/|w_T| go on: where
  /// second order in s would have turned it by more than 10⁻¹⁵ m/s since.
  ///
  /// Falls through zero too where a slip that had a speed nears its end, or has got one again.
  [[nodiscard]] double youth(int i, double t) const noexcept {
    const double s = slip(i), short_of = 1e4 * least_slip(i) - s;
    if (!at(i).begins) return s - 1e-6 * at(i).fastest;
    if (at(i).fades) return 4e-6 * at(i).fastest - s;
    if (system_.rule(i).tangents < 2) return short_of;
    const double gone = across_[as(i)] * lag_[as(i)] * (t - at(i).begun) / 5;
    return std::max(1e-15 - std::abs(gone), short_of);
  }

  /// f_s N + b_s - |T| of a sticking contact.
  [[nodiscard]] double margin(int i) const noexcept {
    const ContactRule rule = system_.rule(i);
    const int t = tangent_row(i);
    const int by = carrier(i);
    const double N = by < 0 ? 0 : r_(normal_row(by));
    double length = 0;
    for (int k = 0; k < rule.tangents; ++k) length = std::hypot(length, r_(t + k));
    return rule.sticking() * N + rule.sticking_bound() - length;
  }

  /// What rounding may make of a velocity: some parts of its terms.
  [[nodiscard]] double rounding_of(int row) const noexcept {
    double sum = 0;
    for (std::size_t j = 0; j < nv; ++j) {
      sum += std::abs(reading_.J(row, static_cast<Eigen::Index>(j)) * y_[nq + j]);
    }
    return std::numeric_limits<double>::epsilon() * (sum + std::abs(reading_.w(row)));
  }

  /// What rounding may make of a gap, of the coordinates that it depends on.
  [[nodiscard]] double rounding_of_gap(int i) const noexcept {
    double sum = 0, largest = 0;
    for (std::size_t j = 0; j < nq; ++j) largest = std::max(largest, std::abs(y_[j]));
    for (std::size_t j = 0; j < nv; ++j) {
      sum += std::abs(reading_.J(normal_row(i), static_cast<Eigen::Index>(j))) * (nq == nv ? std::abs(y_[j]) : largest);
    }
    return std::numeric_limits<double>::epsilon() * sum;
  }

  /// The contact whose gap decides whether this one touches: itself, or the one that rolls; -1: it always does.
  [[nodiscard]] int carrier(int contact) const noexcept {
    const ContactRule rule = system_.rule(contact);
    return rule.normal ? contact : rule.pressed_by;
  }
  [[nodiscard]] int rows() const noexcept { return normal_row(contacts); }
  [[nodiscard]] int normal_row(int contact) const noexcept {
    int row = 0;
    for (int i = 0; i < contact; ++i) row += system_.rule(i).rows();
    return row;
  }
  [[nodiscard]] int tangent_row(int i) const noexcept { return normal_row(i) + (system_.rule(i).normal ? 1 : 0); }

  [[nodiscard]] const Reading& reading() const noexcept { return reading_; }
  [[nodiscard]] const ContactDynamics<Reading>& dynamics() const noexcept { return dynamics_; }
  [[nodiscard]] const Forces& reactions() const noexcept { return r_; }
  [[nodiscard]] const S& system() const noexcept { return system_; }
  /// Regimes were changed: what was solved is no longer valid.
  void changed() noexcept { solved_ = false; }

 private:
  using Velocity = Eigen::Matrix<double, static_cast<int>(nv), 1>;
  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] const ContactState& at(int i) const noexcept { return states[as(i)]; }
  [[nodiscard]] bool follows_forces(int i) const noexcept {
    return at(i).touches && at(i).regime == ContactRegime::slides && at(i).begins && system_.rule(i).tangents == 2;
  }

  // Directions of slips that have just begun, to first order in the slip: the rate of those of order zero is taken
  // over a microsecond of the motion, long against rounding and short against the motion.
  [[nodiscard]] Evaluation align(double t, const Vector& y, const Problem& problem,
                                 typename RegimeSystem<contacts>::Regimes& regimes,
                                 const std::array<bool, S::contacts>& begins) noexcept {
    std::array<double, S::contacts> across{};
    if (!align_slips<contacts>(problem, regimes, begins, across)) return Evaluation::singular;
    RegimeSystem<contacts> equations(problem, regimes);
    if (!equations.solve()) return Evaluation::singular;
    const Velocity a = dynamics_.a0 + dynamics_.KJ * equations.reactions();
    const Forces u = equations.motion();
    constexpr double later = 1e-6;
    Vector there = y;
    std::array<double, nq> rates{};
    system_.coordinate_rates(t, y, rates);
    for (std::size_t i = 0; i < nq; ++i) there[i] += later * rates[i];
    for (std::size_t i = 0; i < nv; ++i) there[nq + i] += later * a(static_cast<Eigen::Index>(i));
    Reading reading;
    ContactDynamics<Reading> dynamics;
    if (!read(t + later, there, reading, dynamics)) return Evaluation::singular;
    auto turned = regimes;
    if (!align_slips<contacts>(problem_of(reading, dynamics), turned, begins, across)) return Evaluation::singular;
    for (int i = 0; i < contacts; ++i) {
      if (!begins[as(i)]) continue;
      const auto& d = regimes[as(i)].direction;
      const auto& e = turned[as(i)].direction;
      const int k = tangent_row(i);
      const double s = d[0] * reading_.w(k) + d[1] * reading_.w(k + 1);
      across[as(i)] = across_[as(i)] = s * (d[0] * e[1] - d[1] * e[0]) / later;
      // s κ over the force that turns the slip back: the angle by which it lags.
      const auto du = equations.motion_by_turning(i);
      const double stiffness = d[0] * (u(k) - du(k + 1)) + d[1] * (u(k + 1) + du(k));
      lag_[as(i)] = stiffness > 0 ? across_[as(i)] / stiffness : 1;
      stiff_[as(i)] = stiffness > 8 * std::abs(d[0] * u(k) + d[1] * u(k + 1));
    }
    return align_slips<contacts>(problem, regimes, begins, across) ? Evaluation::ok : Evaluation::singular;
  }

  [[nodiscard]] bool read(double t, const Vector& y, Reading& reading,
                          ContactDynamics<Reading>& dynamics) const noexcept {
    reading.J.resize(rows(), Eigen::NoChange);
    reading.w.resize(rows());
    reading.drift.resize(rows());
    return system_.read(t, y, reading) == Evaluation::ok && dynamics.compute(reading);
  }

  void follow_directions() noexcept {
    for (int i = 0; i < contacts; ++i) {
      if (!at(i).touches || at(i).regime != ContactRegime::slides || system_.rule(i).tangents < 2) continue;
      ContactState& state = states[as(i)];
      const double now = slip(i);
      state.fastest = std::max(state.fastest, now);
      // Near its end the slip has no direction of its own that is worth following.
      if (now > 1e-6 * state.fastest && !state.begins) state.direction = direction(i);
    }
  }

  // Rows of touching contacts for which `wanted` says so.
  template <class Wanted>
  void select(const Wanted& wanted) noexcept {
    chosen_ = 0;
    right_ = Forces::Zero(rows());
    for (int i = 0; i < contacts; ++i) {
      if (!at(i).touches) continue;
      const ContactRule rule = system_.rule(i);
      for (int k = 0; k < rule.rows(); ++k) {
        const int row = normal_row(i) + k;
        if (wanted(i, row, rule.normal && k == 0)) row_[as(chosen_++)] = row;
      }
    }
  }

  // The least change of velocity, in the metric of the masses, that adds `right_` to the rows selected.
  [[nodiscard]] Velocity least_change() const noexcept {
    Velocity change = Velocity::Zero();
    if (chosen_ == 0) return change;
    typename Problem::Matrix W(chosen_, chosen_);
    Forces b(chosen_);
    for (int i = 0; i < chosen_; ++i) {
      b(i) = right_(row_[as(i)]);
      for (int j = 0; j < chosen_; ++j) W(i, j) = dynamics_.W(row_[as(i)], row_[as(j)]);
    }
    Eigen::FullPivLU<typename Problem::Matrix> lu(W);
    lu.setThreshold(1e-11);
    const Forces P = lu.solve(b);
    for (int i = 0; i < chosen_; ++i) change += dynamics_.KJ.col(row_[as(i)]) * P(i);
    return change;
  }

  const S& system_;
  Reading reading_;
  ContactDynamics<Reading> dynamics_;
  Velocity a_;
  Forces r_, right_;
  std::array<double, S::contacts> across_{}, lag_{};  ///< s κ and the angle of lag of slips that begin
  std::array<bool, S::contacts> stiff_{};
  std::array<int, static_cast<std::size_t>(3 * contacts)> row_{};
  int chosen_ = 0;
  double t_ = 0;
  Vector y_{};
  bool known_ = false, solved_ = false;
};

}  // namespace torsor::runtime
