// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/steps/compensated_state.hpp"

namespace torsor::runtime {

/// The state of an integration and the one it may move on to: y + increment, and on request what rounding lost of that
/// sum, carried into the next one, so that the state is known to about twice its digits and rounding does not add up
/// from step to step.
template <class Scalar, std::size_t size>
class AccumulatedState {
 public:
  using Vector = std::array<Scalar, size>;

  AccumulatedState(Vector& y, bool compensated) noexcept : y_(y), compensated_(compensated) {}

  [[nodiscard]] const Vector& now() const noexcept { return y_; }
  [[nodiscard]] const Vector& next() const noexcept { return next_; }

  /// next = now + increment.
  void propose(const Vector& increment) noexcept {
    if (!compensated_) {
      for (std::size_t i = 0; i < size; ++i) next_[i] = y_[i] + increment[i];
      return;
    }
    next_sums_ = sums_;
    for (std::size_t i = 0; i < size; ++i) next_[i] = next_sums_.add(i, y_[i], increment[i]);
  }

  /// Puts `next` back onto the system's invariants. A correction within a few roundings stays undone where sums are
  /// compensated: it would round anew what the compensation keeps. False when the system could not.
  template <class F>
  [[nodiscard]] bool settle(F& f, Scalar t) noexcept {
    unsettled_ = next_;
    if (!compensated_) return f.settle(t, next_);
    Vector settled = next_;
    if (!f.settle(t, settled)) return false;
    constexpr Scalar few = Scalar(4) * std::numeric_limits<Scalar>::epsilon();
    bool moved = false;
    for (std::size_t i = 0; i < size; ++i) moved = moved || std::abs(settled[i] - next_[i]) > few * std::abs(next_[i]);
    if (moved) next_ = settled;
    return true;
  }

  /// `next` as it was before the last settling.
  [[nodiscard]] const Vector& unsettled() const noexcept { return unsettled_; }

  /// Puts another state in the place of `next`.
  void replace(const Vector& next) noexcept { next_ = next; }

  void accept() noexcept {
    y_ = next_;
    if (compensated_) sums_ = next_sums_;
  }

 private:
  Vector& y_;
  bool compensated_;
  Vector next_{}, unsettled_{};
  CompensatedState<Scalar, size> sums_, next_sums_;
};

}  // namespace torsor::runtime
