// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

/// Watches the regime that laws of friction on constraints assume: a surface that presses, λ ≥ 0, and friction −f λ G/|G|
/// that brakes. A constraint holds whatever the sign of λ is; where λ < 0 it pulls, which no surface does. Where G was given
/// as a direction, the slip may turn against it. Friction with a positive power then drives the motion.
class FrictionRegime {
 public:
  explicit FrictionRegime(EvaluatedMotion& motion);
  void look(double t, const std::vector<double>& y);
  /// For each constraint the first place that was looked at where its friction is none.
  std::vector<std::string> remarks() const;

 private:
  struct Watched {
    std::size_t row;
    double power = 0;                    ///< the largest until now: what is small beside it is rounding
    bool pulls = false, drives = false;  ///< how the regime was left
    double time = 0, lambda = 0;         ///< where
  };
  EvaluatedMotion& motion_;
  double force_ = 0;  ///< the largest |λ| of all constraints until now
  std::vector<Watched> watched_;
};

}  // namespace torsor
