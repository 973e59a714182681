// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

using RealNumbers = std::vector<Real>;

constexpr int shown_digits = 8;  // of a time, in an error

class Extrapolation {
 public:
  Extrapolation(const InitialValueProblem& problem, const ExtrapolationOptions& options)
      : f_(problem.f),
        options_(options),
        time_(problem.t0.with_digits(options.work_digits)),
        tolerance_(Number(10).pow(-options.tolerance_digits), options.work_digits) {
    for (const Real& component : problem.y0) state_.push_back(component.with_digits(options.work_digits));
    for (int row = 1; row < options.columns; ++row) {
      // 1 / ((n_j / n_{j-k})² − 1) for n_j = 2j: Aitken-Neville in h², (9.10).
      std::vector<Real> weights;
      for (int k = 1; k <= row; ++k) {
        const long j = row + 1, i = row + 1 - k;
        weights.emplace_back(Number::rational(i * i, j * j - i * i), options.work_digits);
      }
      weights_.push_back(std::move(weights));
    }
    slope_ = evaluate(time_, state_);
    if (has_nan(slope_)) fail("the right-hand side is not a number");
  }

  const RealNumbers& state() const { return state_; }

  void advance_to(const Real& target) {
    if (target == time_) return;
    if (step_.is_zero()) step_ = first_step(target);
    while (time_ != target) {
      const Real remaining = target - time_;
      const bool lands = abs(step_) >= abs(remaining);
      const Real trial = lands ? remaining : step_;
      if (abs(trial) <= abs(time_) * time_.epsilon() * Real(1000)) {
        fail("the step has become " + trial.to_string(2) + "; the solution may end here (a singularity)");
      }
      if (++step_count_ > options_.maximum_step_count) {
        fail("the limit of " + std::to_string(options_.maximum_step_count) +
             " steps is reached; ask for fewer digits or raise maximum_step_count");
      }
      const auto [next, error] = extrapolate(trial);
      const double factor = step_factor(error);
      const Real proposal = trial * Real::from_double(factor);
      if (!(error <= 1.0)) {
        step_ = proposal;
        just_rejected_ = true;
        continue;
      }
      // A step cut short to land on a time says little against the longer one proposed before.
      if (!lands || abs(proposal) > abs(step_)) step_ = just_rejected_ && factor > 1.0 ? trial : proposal;
      just_rejected_ = false;
      time_ = lands ? target : time_ + trial;
      state_ = next;
      slope_ = evaluate(time_, state_);
      if (has_nan(slope_)) fail("the right-hand side is not a number");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw Error("the extrapolation integration stops at t = " + time_.to_string(shown_digits) + ": " + reason);
  }

  static bool has_nan(const RealNumbers& values) {
    return std::any_of(values.begin(), values.end(), [](const Real& value) { return value.is_nan(); });
  }

  RealNumbers evaluate(const Real& t, const RealNumbers& y) const {
    RealNumbers slope = f_(t, y);
    if (slope.size() != y.size()) {
      throw UsageError("the right-hand side returned " + std::to_string(slope.size()) + " derivatives for a state of " +
                       std::to_string(y.size()) + ": return one for each");
    }
    return slope;
  }

  /// A step after which no component has changed by more than a tenth of max(1, |y_i|) at its initial rate.
  Real first_step(const Real& target) const {
    Real step = target - time_;
    for (std::size_t i = 0; i < state_.size(); ++i) {
      if (slope_[i].is_zero()) continue;
      const Real bound = weight(state_[i]) / (abs(slope_[i]) * Real(10));
      if (bound < abs(step)) step = step > Real() ? bound : -bound;
    }
    return step;
  }

  static Real weight(const Real& component) { return std::max(Real(1), abs(component)); }

  /// Explicit midpoint rule over an even number of sub-steps, (9.13b) without the final smoothing.
  RealNumbers midpoint(const Real& step, int substep_count) const {
    const Real h = step / Real(substep_count);
    const Real twice = h + h;
    RealNumbers before = state_;
    RealNumbers now = state_;
    for (std::size_t i = 0; i < now.size(); ++i) now[i] += h * slope_[i];
    for (int k = 1; k < substep_count; ++k) {
      const RealNumbers slope = evaluate(time_ + h * Real(k), now);
      for (std::size_t i = 0; i < now.size(); ++i) before[i] += twice * slope[i];
      std::swap(before, now);
    }
    return now;
  }

  /// The corner T_KK of the tableau and its distance to T_K,K-1, relative to the tolerance.
  std::pair<RealNumbers, double> extrapolate(const Real& step) const {
    std::vector<RealNumbers> row{midpoint(step, 2)};  // T_j1, T_j2, ..., T_jj
    for (int j = 1; j < options_.columns; ++j) {
      const std::vector<Real>& weights = weights_[static_cast<std::size_t>(j - 1)];
      std::vector<RealNumbers> next{midpoint(step, 2 * (j + 1))};
      for (std::size_t k = 0; k < row.size(); ++k) {
        RealNumbers refined = next[k];
        for (std::size_t i = 0; i < refined.size(); ++i) refined[i] += weights[k] * (next[k][i] - row[k][i]);
        next.push_back(std::move(refined));
      }
      row = std::move(next);
    }
    const RealNumbers& best = row[row.size() - 1];
    const RealNumbers& second = row[row.size() - 2];
    Real error;
    for (std::size_t i = 0; i < best.size(); ++i) {
      if (best[i].is_nan() || second[i].is_nan()) return {best, std::nan("")};
      const Real scale = tolerance_ * std::max(weight(state_[i]), abs(best[i]));
      error = std::max(error, abs(best[i] - second[i]) / scale);
    }
    return {best, error.to_double()};
  }

  /// This step's best successor for an error of order 2K − 1, with the safety factors of II.9. Where the right-hand
  /// side leaves its domain there is no estimate: try a quarter.
  double step_factor(double error) const {
    if (std::isnan(error)) return 0.25;
    const double bounded = std::clamp(error, 1e-300, 1e300);
    return std::clamp(0.94 * std::pow(0.65 / bounded, 1.0 / (2 * options_.columns - 1)), 0.05, 5.0);
  }

  const DifferentialEquation& f_;
  ExtrapolationOptions options_;
  Real time_;
  Real tolerance_;
  RealNumbers state_;
  RealNumbers slope_;
  Real step_;
  std::vector<std::vector<Real>> weights_;  // weights_[j-2][k-1] makes T_j,k+1 from T_jk and T_j-1,k
  long step_count_ = 0;
  bool just_rejected_ = false;
};

void check(const Real& t0, const std::vector<Real>& times, const ExtrapolationOptions& options) {
  if (options.columns < 3 || options.columns > 40) {
    throw UsageError("an extrapolation with " + std::to_string(options.columns) +
                     " columns is not offered: ask for 3 to 40");
  }
  if (options.tolerance_digits < 1 || options.work_digits < options.tolerance_digits) {
    throw UsageError("a tolerance of " + std::to_string(options.tolerance_digits) +
                     " digits cannot be met with arithmetic of " + std::to_string(options.work_digits) +
                     " digits: work with at least ten more than the tolerance");
  }
  if (t0.is_nan()) throw UsageError("the initial time is not a number: give a number");
  const bool forward = times.empty() || times.back() >= t0;
  const Real* previous = &t0;
  for (const Real& time : times) {
    if (!(forward ? time >= *previous : time <= *previous)) {
      throw UsageError("the time " + time.to_string(shown_digits) + " comes after " +
                       previous->to_string(shown_digits) +
                       " in the list of times: order them away from the initial time");
    }
    previous = &time;
  }
}

/// Largest n, up to the limit, with |a_i − b_i| <= 10^-n · max(1, |a_i|) for all i.
int agreement(const RealNumbers& a, const RealNumbers& b, int limit) {
  Real difference;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, abs(a[i] - b[i]) / std::max(Real(1), abs(a[i])));
  }
  int digits = 0;
  while (digits < limit && difference * pow(Real(10), digits + 1) <= Real(1)) ++digits;
  return digits;
}

/// The first digits that two numbers have in common: largest n, up to the limit, with |a − b| <= 10^-n |a|.
int shared_digits(const Real& a, const Real& b, int limit) {
  const Real difference = abs(a - b);
  if (difference.is_zero()) return limit;
  int digits = 0;
  while (digits < limit && difference * pow(Real(10), digits + 1) <= abs(a)) ++digits;
  return digits;
}

/// The states at the times that are reached; what ends the integration before the last one is told in `stopped`.
std::vector<RealNumbers> integrate_as_far_as_it_goes(const InitialValueProblem& problem, const std::vector<Real>& times,
                                                     const ExtrapolationOptions& options, std::string& stopped) {
  check(problem.t0, times, options);
  const WorkingDigits digits(options.work_digits);
  std::vector<RealNumbers> states;
  try {
    Extrapolation extrapolation(problem, options);
    for (const Real& time : times) {
      extrapolation.advance_to(time.with_digits(options.work_digits));
      states.push_back(extrapolation.state());
    }
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    if (!options.as_far_as_it_goes || states.empty()) throw;
    if (stopped.empty()) stopped = error.what();
  }
  return states;
}

}  // namespace

std::vector<std::vector<Real>> integrate(const InitialValueProblem& problem, const std::vector<Real>& times,
                                         const ExtrapolationOptions& options) {
  check(problem.t0, times, options);
  const WorkingDigits digits(options.work_digits);
  Extrapolation extrapolation(problem, options);
  std::vector<std::vector<Real>> states;
  for (const Real& time : times) {
    extrapolation.advance_to(time.with_digits(options.work_digits));
    states.push_back(extrapolation.state());
  }
  return states;
}

ConvergedSolution integrate_converged(const InitialValueProblem& problem, const std::vector<Real>& times,
                                      const ExtrapolationOptions& options) {
  ExtrapolationOptions coarser = options;
  coarser.columns = options.columns > 6 ? options.columns - 3 : options.columns + 3;
  coarser.tolerance_digits = std::max(1, options.tolerance_digits - 3);
  ConvergedSolution solution;
  solution.worst_agreed_digits = options.work_digits;
  solution.values = integrate_as_far_as_it_goes(problem, times, options, solution.stopped);
  const std::vector<std::vector<Real>> other = integrate_as_far_as_it_goes(problem, times, coarser, solution.stopped);
  solution.values.resize(std::min(solution.values.size(), other.size()));
  const WorkingDigits digits(options.work_digits);
  for (std::size_t index = 0; index < solution.values.size(); ++index) {
    const RealNumbers& values = solution.values[index];
    solution.agreed_digits.push_back(agreement(values, other[index], options.work_digits));
    solution.shared_digits.emplace_back();
    for (std::size_t i = 0; i < values.size(); ++i) {
      solution.shared_digits.back().push_back(shared_digits(values[i], other[index][i], options.work_digits));
    }
    solution.worst_agreed_digits = std::min(solution.worst_agreed_digits, solution.agreed_digits.back());
  }
  return solution;
}

}  // namespace torsor
