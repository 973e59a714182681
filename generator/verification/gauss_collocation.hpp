// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/verification/motion_integrator.hpp"

namespace torsor {

/// Gauss collocation with three stages, order 6, with steps of one length: symmetric, so that the energy of reversible
/// motions stays bounded over long times. Stages are iterated until only rounding moves them, which needs steps that resolve
/// the fastest motion. Source: Hairer-Lubich-Wanner, Geometric Numerical Integration, II.1.3, VIII.6.
class GaussCollocation6 final : public MotionIntegrator {
 public:
  GaussCollocation6(Slope slope, Settle settle, std::vector<double> y, double step);

  bool advance(double end) override;
  std::unique_ptr<MotionIntegrator> copy() const override { return std::make_unique<GaussCollocation6>(*this); }

 private:
  bool step(double h);

  double step_;
  std::array<std::vector<double>, 3> stages_;
};

}  // namespace torsor
