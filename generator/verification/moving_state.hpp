// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>

#include "torsor/generator/verification/random_state.hpp"

namespace torsor {

/// The motion through a random state with its velocities and accelerations, to second order in the time h from there:
/// q + q̇ h + q̈ h²/2, q̇ + q̈ h, and e + ė h + ë h²/2 with ė = ½ e∘ω and ë = ½ (ė∘ω + e∘ω̇) of unit quaternions, ω in
/// moving axes. |e|² = 1 + O(h³): its first two derivatives vanish at h = 0.
class MovingState {
 public:
  MovingState(const Scene& scene, const RandomState& state);

  Evaluator<Real>::SymbolValue at(const Real& h) const;

 private:
  Evaluator<Real>::SymbolValue start_;
  std::map<const Symbol*, std::array<Real, 3>> motions_;  ///< value, first and second derivative; looked up only
};

}  // namespace torsor
