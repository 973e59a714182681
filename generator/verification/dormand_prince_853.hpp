// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/verification/motion_integrator.hpp"

namespace torsor {

/// A motion y' = f(t, y) in `double` by Dormand and Prince's method of order 8 with steps that a tolerance chooses, for
/// states whose size is known when the program runs. Source: Hairer-Norsett-Wanner I, II.5, II.10 (10.17).
class DormandPrince853 final : public MotionIntegrator {
 public:
  /// Errors of a step stay below tolerance · (1 + |y_i|).
  DormandPrince853(Slope slope, Settle settle, std::vector<double> y, double tolerance);

  bool advance(double end) override;
  std::unique_ptr<MotionIntegrator> copy() const override { return std::make_unique<DormandPrince853>(*this); }

 private:
  double attempt(double h);  ///< the weighted error; not a number where there is no slope
  double bend(double h) const;  ///< of the step that has been attempted, see `creeps`
  double first_step(double span) const;

  double h_ = 0.0, tolerance_;
  std::vector<double> trial_, next_;
  std::array<std::vector<double>, 12> slopes_;
};

}  // namespace torsor
