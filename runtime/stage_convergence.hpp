// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

namespace torsor::runtime {

/// Decides when the iteration for the stages of an implicit step has come down to rounding. A change is that of the
/// stages in one sweep, relative to the state.
///
/// Done when a change is so far below a rounding that a million of them stay below one, or the next would be at the
/// rate seen; and when changes no longer shrink: at once where they are nearly roundings, after three sweeps without a
/// smaller one where the equations magnify roundings. Nothing coarser will do: an error of the iteration is not random,
/// so that it would add up over the steps (Hairer-McLachlan-Razakarivony, BIT 48 (2008), section 3).
template <class Scalar>
class StageConvergence {
 public:
  [[nodiscard]] bool reached(Scalar change) noexcept {
    const Scalar before = change_;
    change_ = change;
    if (change <= far_below) return true;
    if (!(change < smallest_)) return change <= near_rounding || (++barren_ >= 3 && smallest_ <= magnified_rounding);
    smallest_ = change;
    barren_ = 0;
    const Scalar rate = change / before;  // 0 after the first sweep, which had nothing before it
    return rate > Scalar(0) && rate < Scalar(0.5) && change * rate <= far_below;
  }

  /// Whether the last change was as large as the state itself.
  [[nodiscard]] bool diverges() const noexcept {
    return change_ > Scalar(0.5) && change_ <= std::numeric_limits<Scalar>::max();
  }

 private:
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar far_below = epsilon / Scalar(1048576);
  static constexpr Scalar near_rounding = epsilon * Scalar(1024);
  static constexpr Scalar magnified_rounding = epsilon * Scalar(4194304);

  Scalar change_ = std::numeric_limits<Scalar>::infinity(), smallest_ = change_;
  int barren_ = 0;
};

}  // namespace torsor::runtime
