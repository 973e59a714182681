// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// Right-hand side f of y' = f(t, y).
using DifferentialEquation = std::function<std::vector<Real>(const Real& t, const std::vector<Real>& y)>;

/// y' = f(t, y), y(t0) = y0.
struct InitialValueProblem {
  DifferentialEquation f;
  std::vector<Real> y0;
  Real t0 = Real(0);
};

/// How an extrapolation integration is done.
struct ExtrapolationOptions {
  int columns = 14;           ///< columns K of the tableau: order 2K, K² + 1 evaluations of f a step
  int tolerance_digits = 40;  ///< local error below 10^-tolerance_digits · max(1, |y_i|)
  int work_digits = 60;       ///< precision of the arithmetic; the tableau itself costs some 5 digits
  long maximum_step_count = 100000;
  bool as_far_as_it_goes = false;  ///< integrate_converged: where a run fails, what both reached is the solution
};

/// A solution with the digits that two integrations of different order and tolerance have in common.
struct ConvergedSolution {
  std::vector<std::vector<Real>> values;  ///< one state per asked time
  std::vector<int> agreed_digits;         ///< per time: both agree to 10^-agreed_digits · max(1, |y_i|) everywhere
  int worst_agreed_digits = 0;
  std::vector<std::vector<int>> shared_digits{};  ///< per time and component: the first digits that both have in common
  std::string stopped{};                          ///< why there are fewer states than times; empty when there are not
};

/// y at each of `times` (monotonic, in either direction from t0; the integration lands on each of them exactly).
/// Gragg-Bulirsch-Stoer: explicit midpoint rule without smoothing over 2, 4, ..., 2K sub-steps, extrapolated in h², own
/// step control (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.9, (9.10) and (9.13)).
/// While f runs, Real::working_digits() is work_digits; give y0 and the times with at least as many digits. Errors:
/// UsageError for options or times that make no sense; Error naming t where
/// f is not a number, the step vanishes or there are too many steps.
std::vector<std::vector<Real>> integrate(const InitialValueProblem& problem, const std::vector<Real>& times,
                                         const ExtrapolationOptions& options);

/// The same, and once more with three columns and three digits of tolerance less; the values are those of the first. Where
/// a run fails after the first time, `as_far_as_it_goes` keeps the times that both reached.
ConvergedSolution integrate_converged(const InitialValueProblem& problem, const std::vector<Real>& times,
                                      const ExtrapolationOptions& options);

}  // namespace torsor
