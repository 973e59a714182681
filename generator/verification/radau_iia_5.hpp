// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/verification/motion_integrator.hpp"

namespace torsor {

/// Radau's collocation of order 5 (IIA) with steps that a tolerance chooses: for stiff motions, what decays fast is gone
/// and steps follow what is slow. Stages by simplified Newton iterations with a Jacobian by differences.
/// Source: Hairer-Wanner II, IV.8; the error estimate is that of the authors' code radau5.
class RadauIia5 final : public MotionIntegrator {
 public:
  /// Errors of a step stay below tolerance · (1 + |y_i|).
  RadauIia5(Slope slope, Settle settle, std::vector<double> y, double tolerance);

  bool advance(double end) override;
  std::unique_ptr<MotionIntegrator> copy() const override { return std::make_unique<RadauIia5>(*this); }

 private:
  /// The weighted error of a step that leads to `next_`; not a number where it does not converge.
  double attempt(double h);
  bool linearise();

  double tolerance_, h_ = 0.0;
  std::vector<double> next_, slope_here_;
  std::vector<std::vector<double>> jacobian_;  ///< ∂f/∂y at the beginning of the step
};

}  // namespace torsor
