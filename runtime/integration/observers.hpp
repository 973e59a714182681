// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Passes on the first of every `count` states, for methods whose steps are finer than the record shall be. A count that
/// is not above zero stops the integration.
/// `Every observer(10, recorder);` keeps a reference to `recorder`.
template <class Observer>
class Every {
 public:
  Every(std::int64_t count, Observer& observer) noexcept : count_(count), observer_(observer) {}

  template <class Scalar, std::size_t size>
  bool operator()(const Scalar& t, const std::array<Scalar, size>& y) {
    if (count_ < 1) return false;
    return seen_++ % count_ != 0 || notify(observer_, t, y);
  }

 private:
  std::int64_t count_;
  std::int64_t seen_ = 0;
  Observer& observer_;
};

/// Passes on states at start, start + interval, ... through the interpolant, in the direction in which time runs.
/// An interval that is not above zero stops the integration.
/// `EquallySpaced observer(0.0, 0.01, recorder);` keeps a reference to `recorder`.
template <class Scalar, class Observer>
class EquallySpaced {
 public:
  EquallySpaced(Scalar start, Scalar interval, Observer& observer) noexcept
      : start_(start), interval_(std::abs(interval)), observer_(observer) {}

  template <class Step>
  requires requires(const Step& step, Scalar t) { step(t), step.start, step.end; }
  bool operator()(const Step& step) {
    if (!(interval_ > Scalar(0))) return false;
    const Scalar direction = step.end >= step.start ? Scalar(1) : Scalar(-1);
    // The last sample of 0.1, 0.2, ... may exceed the end by rounding alone: it is then the end. Rounding is that of the
    // largest number of the sum, which an end near zero is not.
    const Scalar largest = std::max(std::abs(start_), std::abs(step.end));
    const Scalar slack = Scalar(8) * std::numeric_limits<Scalar>::epsilon() * largest;
    for (;; ++samples_) {
      const Scalar t = start_ + direction * static_cast<Scalar>(samples_) * interval_;
      const Scalar beyond = direction * (t - step.end);
      if (!(beyond <= slack)) return true;
      if (direction * (t - step.start) < -slack) continue;  // before the integration began
      const Scalar inside = beyond > Scalar(0) ? step.end : t;
      if (!notify(observer_, inside, step(inside))) return false;
    }
  }

 private:
  Scalar start_, interval_;
  std::int64_t samples_ = 0;
  Observer& observer_;
};

}  // namespace torsor::runtime
