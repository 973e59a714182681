// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

namespace torsor::runtime {

/// Where an interpolant shows an event that the motion itself does not have, its step was too long: what is left of that step is
/// taken in sixteen shorter ones, and, where one of these is too long, in others again. The time goes forwards.
class CarefulSteps {
 public:
  /// A step from `start` to `end` lost sight of an event, the motion came to `time`: whether to go on from there.
  [[nodiscard]] bool repeat(double time, double start, double end) noexcept {
    if (start >= until_) repeats_ = 0;
    if (repeats_ == most || !(end > start)) return false;
    ++repeats_;
    length_ = (end - start) / 16;
    until_ = std::max(end, time);
    return true;
  }

  /// Whether a time lies in what is left of the step that was too long.
  [[nodiscard]] bool lasts(double time) const noexcept { return time < until_; }

  /// The method with the longest step that is allowed there; itself where its steps have one length.
  template <class Method>
  [[nodiscard]] Method limit(Method method) const noexcept {
    if constexpr (requires { method.largest_step; }) {
      if (!(method.largest_step > 0 && method.largest_step < length_)) method.largest_step = length_;
    }
    return method;
  }

  /// Where these steps end, on the way to another time.
  [[nodiscard]] double end(double otherwise) const noexcept { return std::min(until_, otherwise); }

 private:
  static constexpr int most = 6;
  int repeats_ = 0;
  double length_ = 0, until_ = -std::numeric_limits<double>::infinity();
};

}  // namespace torsor::runtime
