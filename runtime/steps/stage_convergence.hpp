// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

namespace torsor::runtime {

/// What one sweep of the iteration for the stages changed: of each component relative to itself, the largest, and of
/// all relative to the largest of them.
template <class Scalar>
struct StageChange {
  Scalar by_component = Scalar(0), moved = Scalar(0), size = Scalar(0);

  /// A component of this size that moved so far.
  void add(Scalar distance, Scalar magnitude) noexcept {
    size = std::max(size, magnitude);
    if (!(distance > Scalar(0))) return;
    by_component = std::max(by_component, distance / magnitude);
    moved = std::max(moved, distance);
  }

  [[nodiscard]] Scalar overall() const noexcept { return moved > Scalar(0) ? moved / size : Scalar(0); }
};

/// Decides when the iteration for the stages of an implicit step has come down to rounding.
///
/// Done when a change is so far below a rounding that a million of them stay below one, or the next would be at the
/// rate seen; and when changes no longer shrink: at once where they are nearly roundings, after three sweeps without a
/// smaller one where the equations magnify roundings (stiff springs do), which only the overall change can tell.
/// Nothing coarser will do: an error of the iteration is not random, so that it would add up over the steps
/// (Hairer-McLachlan-Razakarivony, BIT 48 (2008), section 3).
template <class Scalar>
class StageConvergence {
 public:
  [[nodiscard]] bool reached(const StageChange<Scalar>& latest) noexcept {
    const Scalar before = change_, change = latest.by_component;
    change_ = change;
    if (change <= far_below) return true;
    if (!(change < smallest_)) {
      return change <= near_rounding || (++barren_ >= 3 && latest.overall() <= magnified_rounding);
    }
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
  // The square root of a rounding.
  static constexpr Scalar magnified_rounding = sizeof(Scalar) == sizeof(float) ? Scalar(3e-4) : Scalar(1.5e-8);

  Scalar change_ = std::numeric_limits<Scalar>::infinity(), smallest_ = change_;
  int barren_ = 0;
};

}  // namespace torsor::runtime
