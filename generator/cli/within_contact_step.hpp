// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/verification/motion_integrator.hpp"
#include "torsor/runtime/contacts/contact_motion.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"

namespace torsor {

/// The motion of contacts within a step, in the regimes of that step: where what is watched passes zero there.
template <std::size_t size>
class WithinContactStep final : public MotionIntegrator {
 public:
  /// The motion must live as long. `tolerance` is that of the norm over all numbers of an array of this size.
  WithinContactStep(runtime::ContactMotion& motion, double t, std::vector<double> y, double tolerance)
      : MotionIntegrator({}, {}, std::move(y)), motion_(&motion), tolerance_(tolerance) {
    t_ = t;
  }

  bool advance(double end) override {
    std::array<double, size> y{};
    std::copy(y_.begin(), y_.end(), y.begin());
    const auto slope = [this](double t, const std::array<double, size>& at, std::array<double, size>& rates) {
      rates.fill(0);
      return motion_->slope(t, at, rates);
    };
    const runtime::DormandPrince853 method{.relative_tolerance = tolerance_, .absolute_tolerance = tolerance_};
    const runtime::Result<double> result = runtime::integrate(slope, y, t_, end, method);
    if (!result) return fail(std::string(describe(result.status)));
    std::copy_n(y.begin(), y_.size(), y_.begin());
    t_ = end;
    return true;
  }
  std::unique_ptr<MotionIntegrator> copy() const override { return std::make_unique<WithinContactStep>(*this); }

 private:
  runtime::ContactMotion* motion_;
  double tolerance_;
};

}  // namespace torsor
