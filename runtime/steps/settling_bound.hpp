// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/steps/step_control.hpp"

namespace torsor::runtime {

/// How far settling may move the end of a step. Constraints that time says nothing of are left by the error of the step;
/// one that follows a law of time is left by whatever that law did within the step, and no other estimate sees it.
/// Roundings are those of `Precision`.
template <class Scalar, class Precision = Scalar>
struct SettlingBound {
  static constexpr Scalar most = Scalar(100);        ///< in units of the tolerances
  static constexpr Scalar roundings = Scalar(4096);  ///< of the largest number of the state, which are no correction

  Tolerances<Scalar> tolerances;

  /// What settling moved over the most that it may, 1 and less being allowed. `now` is the state at the start of the step.
  template <std::size_t size>
  [[nodiscard]] Scalar share(const std::array<Scalar, size>& now, const std::array<Scalar, size>& before,
                             const std::array<Scalar, size>& settled) const noexcept {
    Scalar largest = Scalar(0), sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, std::abs(before[i]));
    const Scalar least = roundings * static_cast<Scalar>(std::numeric_limits<Precision>::epsilon()) * largest;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar moved = settled[i] - before[i];
      if (moved == Scalar(0)) continue;
      const Scalar magnitude = std::max({std::abs(now[i]), std::abs(before[i]), std::abs(settled[i])});
      const Scalar allowed = most * (tolerances.absolute + tolerances.relative * magnitude);
      const Scalar ratio = moved / std::max(allowed, least);
      sum += ratio * ratio;
    }
    return std::sqrt(sum / static_cast<Scalar>(size));
  }
};

}  // namespace torsor::runtime
