// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "runtime/contacts/contact_result.hpp"
#include "runtime/contacts/contact_solver.hpp"
#include "runtime/contacts/contact_system.hpp"

namespace torsor::runtime {

/// Steps of Moreau and Jean, for a mechanism with contacts:
///   q_m = q + (1 - θ) h q'(v);  v+ = v + h M^-1 F + M^-1 J^T P at q_m;  q+ = q_m + θ h q'(v+),
///   0 <= w_N+ + e w_N-, P_N >= 0, |P_T| <= f P_N,
/// for the contacts whose gap at q_m is closed. No event is located: impacts, accumulations and ends of slip happen
/// within steps, and the error is of first order in h. Gaps below zero are put back by displacements that do not become
/// velocities. Impulses of the last step are the first guess of the next. Source: Acary & Brogliato 2008, chapter 10.
template <class S>
class MoreauJean {
 public:
  static constexpr std::size_t nq = S::nq, nv = S::nv;
  static constexpr int contacts = static_cast<int>(S::contacts);
  using Vector = std::array<double, nq + nv>;
  using Problem = ContactProblem<contacts>;
  using Forces = typename Problem::Vector;

  explicit MoreauJean(const S& system, double theta = 0.5) noexcept : system_(system), theta_(theta) {
    for (int i = 0; i < contacts; ++i) {
      if (!valid_rule(system, i)) {
        status_ = ContactStatus::invalid_rule;
        contact_ = i;
        return;
      }
      rows_ += system.rule(i).rows();
    }
    reading_.J.resize(rows_, Eigen::NoChange);
    reading_.w.resize(rows_);
    reading_.drift.resize(rows_);
    impulses_ = Forces::Zero(rows_);
  }

  /// One step of length h > 0 from (t, y). False with a status where it cannot be made.
  bool step(double t, double h, Vector& y) noexcept {
    if (status_ == ContactStatus::invalid_rule) return false;
    Vector middle = y;
    move(t, middle, (1 - theta_) * h);
    const double there = t + (1 - theta_) * h;
    if (!read(there, middle)) return end(ContactStatus::integration_failed);
    Chosen chosen = choose([&](int i) {
      const int by = system_.rule(i).normal ? i : system_.rule(i).pressed_by;
      return by < 0 || reading_.gap[as(by)] <= 0;
    });
    // Loops are held as contacts are, by their velocities at q_m.
    const Velocity change = dynamics_.closing_rate + h * (dynamics_.K * reading_.F);
    const Velocity v_free = velocity(y) + change;
    const Forces w_free = reading_.w + reading_.J * change;
    fill(chosen, w_free);
    Forces start(chosen.rows);
    for (int k = 0; k < chosen.rows; ++k) start(k) = impulses_(chosen.row[as(k)]);
    for (int k = 0; k < chosen.problem.count; ++k) {
      const ContactRule rule = system_.rule(chosen.who[as(k)]);
      ContactLaw& law = chosen.problem.laws[as(k)];
      law.bound *= h;  // bounded forces, as impulses of the step
      law.static_bound *= h;
      const int n = chosen.problem.first_row(k);
      const double before = reading_.w(chosen.row[as(n)]);
      if (rule.normal && before < 0) chosen.problem.q(n) += rule.restitution * before;
    }
    impulses_.setZero();
    Velocity v = v_free;
    residual_ = 0;
    if (chosen.problem.count > 0) {
      ContactIteration<contacts> iteration(chosen.problem, {});
      iteration.start_from(start);
      ContactAnswer<contacts> answer = iteration.run();
      if (!answer && chosen.problem.count <= 6) answer = solve_contacts(chosen.problem);
      if (!answer) return end(ContactStatus::no_solution);
      residual_ = answer.best().residual;
      for (int k = 0; k < chosen.rows; ++k) impulses_(chosen.row[as(k)]) = answer.best().r(k);
      v += dynamics_.KJ * impulses_;
    }
    for (std::size_t i = 0; i < nv; ++i) middle[nq + i] = v(static_cast<Eigen::Index>(i));
    move(there, middle, theta_ * h);
    y = middle;
    return put_back(t + h, y);
  }

  [[nodiscard]] ContactStatus status() const noexcept { return status_; }
  [[nodiscard]] double residual() const noexcept { return residual_; }         ///< certificate of the last step
  [[nodiscard]] double depth() const noexcept { return depth_; }  ///< [m] below zero before its end put it back
  [[nodiscard]] int contact() const noexcept { return contact_; }  ///< the one whose rule is invalid; else -1
  [[nodiscard]] const Forces& impulses() const noexcept { return impulses_; }  ///< of the last step, all rows

 private:
  using Velocity = Eigen::Matrix<double, static_cast<int>(nv), 1>;
  struct Chosen {
    Problem problem;
    std::array<int, S::contacts> who{};
    std::array<int, static_cast<std::size_t>(3 * contacts)> row{};
    int rows = 0;
  };
  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  bool end(ContactStatus status) noexcept {
    status_ = status;
    return false;
  }
  [[nodiscard]] static Velocity velocity(const Vector& y) noexcept { return Eigen::Map<const Velocity>(y.data() + nq); }
  void move(double t, Vector& y, double h) const noexcept {
    std::array<double, nq> rates{};
    system_.coordinate_rates(t, y, rates);
    for (std::size_t i = 0; i < nq; ++i) y[i] += h * rates[i];
  }
  [[nodiscard]] bool read(double t, const Vector& y) noexcept {
    return system_.read(t, y, reading_) == Evaluation::ok && dynamics_.compute(reading_);
  }

  template <class Wanted>
  [[nodiscard]] Chosen choose(const Wanted& wanted) const noexcept {
    Chosen chosen;
    std::array<int, S::contacts> place{};
    int first = 0;
    for (int i = 0; i < contacts; ++i) {
      const ContactRule rule = system_.rule(i);
      if (wanted(i)) {
        for (int k = 0; k < rule.rows(); ++k) chosen.row[as(chosen.rows++)] = first + k;
        chosen.who[as(chosen.problem.count)] = i;
        place[as(i)] = chosen.problem.count;
        chosen.problem.laws[as(chosen.problem.count++)] = {.normal = rule.normal,
                                                           .pressed_by = rule.pressed_by < 0 ? -1 : place[as(rule.pressed_by)],
                                                           .tangents = rule.tangents,
                                                           .friction = rule.friction,
                                                           .static_friction = rule.sticking(),
                                                           .bound = rule.bound,
                                                           .static_bound = rule.sticking_bound()};
      }
      first += rule.rows();
    }
    return chosen;
  }
  void fill(Chosen& chosen, const Forces& q) const noexcept {
    chosen.problem.W.resize(chosen.rows, chosen.rows);
    chosen.problem.q.resize(chosen.rows);
    for (int i = 0; i < chosen.rows; ++i) {
      chosen.problem.q(i) = q(chosen.row[as(i)]);
      for (int j = 0; j < chosen.rows; ++j) {
        chosen.problem.W(i, j) = dynamics_.W(chosen.row[as(i)], chosen.row[as(j)]);
      }
    }
  }

  // The least displacement, in the metric of the masses, after which no gap is negative and loops are closed: contacts
  // without friction, whose reactions are displacements.
  bool put_back(double t, Vector& y) noexcept {
    if constexpr (requires { system_.normalise(y); }) system_.normalise(y);
    for (int repeat = 0; repeat < 3; ++repeat) {
      if (!read(t, y)) return end(ContactStatus::integration_failed);
      double deepest = 0;
      for (int i = 0; i < contacts; ++i) {
        if (system_.rule(i).normal) deepest = std::max(deepest, -reading_.gap[as(i)]);
      }
      if (repeat == 0) depth_ = deepest;
      if (!(deepest > 1e-14 || dynamics_.closing.cwiseAbs().maxCoeff() > 1e-14)) return true;
      Chosen chosen = choose([&](int i) { return system_.rule(i).normal; });
      Forces gaps = Forces::Zero(rows_);
      for (int k = 0; k < chosen.problem.count; ++k) {
        const int n = chosen.problem.first_row(k);
        const int row = chosen.row[as(n)];
        gaps(row) = reading_.gap[as(chosen.who[as(k)])] + reading_.J.row(row).dot(dynamics_.closing);
        chosen.problem.laws[as(k)] = {.tangents = chosen.problem.law(k).tangents};
      }
      fill(chosen, gaps);
      ContactIteration<contacts> iteration(chosen.problem, {});
      const ContactAnswer<contacts> answer = iteration.run();
      if (!answer) return true;  // contacts that exclude each other
      Forces r = Forces::Zero(rows_);
      for (int k = 0; k < chosen.rows; ++k) r(chosen.row[as(k)]) = answer.best().r(k);
      const Velocity change = dynamics_.closing + dynamics_.KJ * r;
      Vector there = y;
      for (std::size_t i = 0; i < nv; ++i) there[nq + i] = change(static_cast<Eigen::Index>(i));
      std::array<double, nq> moved{};
      system_.coordinate_rates(t, there, moved);
      for (std::size_t i = 0; i < nq; ++i) y[i] += moved[i];
    }
    return true;
  }

  const S& system_;
  const double theta_;
  int rows_ = 0;
  typename S::Reading reading_;
  ContactDynamics<typename S::Reading> dynamics_;
  Forces impulses_;
  ContactStatus status_ = ContactStatus::reached_end;
  double residual_ = 0, depth_ = 0;
  int contact_ = -1;
};

/// Steps of equal length from t0 to t1, `steps` of them; the status of the last one. integration_failed where t1 < t0 or
/// there is no step.
template <ContactSystem S>
ContactStatus step_contacts(const S& system, std::array<double, S::nq + S::nv>& y, double t0, double t1, long steps,
                            double theta = 0.5) noexcept {
  MoreauJean<S> scheme(system, theta);
  if (!(t1 >= t0) || steps < 1) return ContactStatus::integration_failed;
  const double h = (t1 - t0) / static_cast<double>(steps);
  for (long k = 0; k < steps; ++k) {
    if (!scheme.step(t0 + static_cast<double>(k) * h, h, y)) return scheme.status();
  }
  return ContactStatus::reached_end;
}

}  // namespace torsor::runtime
