// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// Time and step length of one integration with steps of its own choice: what lengths are tried next, and when there is
/// nothing left to try. `plan`, then either `refuse` or `keep`, until the time is the end.
template <class Scalar>
class StepClock {
 public:
  explicit StepClock(double largest_step = 0.0) noexcept
      : largest(largest_step > 0.0 ? static_cast<Scalar>(largest_step) : std::numeric_limits<Scalar>::infinity()) {}

  /// Steps are counted from here on, as those of a motion that begins.
  void count_anew() noexcept {
    result.statistics = {};
    refusal = Evaluation::ok;
    last_word_ = {};
  }

  /// Before the first step towards a new end.
  void set_out() noexcept { after_rejection_ = false; }

  /// The next step to try towards the end: from result.time to t_next, h long with its sign. False when it would be too
  /// short or one too many; the result then says so.
  [[nodiscard]] bool plan(Scalar end, std::int64_t step_limit) noexcept {
    const Scalar t = result.time, remaining = end - t;
    // A step that all but reaches the end is stretched to it, so that none of a rounding's length is left over.
    const bool last = length * Scalar(1.01) >= std::abs(remaining);
    t_next = last ? end : t + std::copysign(length, remaining);
    h = t_next - t;  // what the clock really advances, so that rounding of time never accumulates
    // Where the model fails at the end of every step, steps of a rounding's length creep towards that place.
    const Scalar span = refusal == Evaluation::ok ? std::abs(t) : std::max(std::abs(t), std::abs(remaining));
    if (!last && !(std::abs(h) > smallest_step(span))) {
      give_up();
      return false;
    }
    if (result.statistics.accepted + result.statistics.rejected >= step_limit) {
      result.status = IntegrationStatus::too_many_steps;
      return false;
    }
    return true;
  }

  /// The step is not taken; the model's word on it is kept for the case that shorter ones fail too.
  void refuse(Evaluation evaluation, Scalar shorter) noexcept {
    ++result.statistics.rejected;
    refusal = evaluation;
    if (evaluation != Evaluation::ok) last_word_ = {evaluation, tried()};
    length = shorter;
    after_rejection_ = true;
  }

  void keep(Scalar longer) noexcept {
    ++result.statistics.accepted;
    refusal = Evaluation::ok;
    length = std::min(longer, largest);
    after_rejection_ = false;
    result.time = t_next;
  }

  /// For what the model said last, or for the step length where it said nothing.
  void give_up() noexcept {
    result.evaluation = refusal;
    result.status = refusal == Evaluation::ok ? IntegrationStatus::step_too_small : IntegrationStatus::model_failure;
    // A step shrinks to the resolution of time in some fifty trials.
    if (refusal == Evaluation::ok && tried() - last_word_.at < 100) result.evaluation = last_word_.evaluation;
  }

  [[nodiscard]] bool after_rejection() const noexcept { return after_rejection_; }

  Result<Scalar> result;
  Scalar largest;             ///< step allowed
  Scalar length = Scalar(0);  ///< of the step to try next, positive
  Scalar t_next = Scalar(0), h = Scalar(0);
  Evaluation refusal = Evaluation::ok;

 private:
  static Scalar smallest_step(Scalar t) noexcept {
    return std::max(Scalar(10) * std::numeric_limits<Scalar>::epsilon() * std::abs(t),
                    std::numeric_limits<Scalar>::min());
  }

  [[nodiscard]] std::int64_t tried() const noexcept {
    return result.statistics.accepted + result.statistics.rejected;
  }

  struct {
    Evaluation evaluation = Evaluation::ok;
    std::int64_t at = 0;
  } last_word_;  // of the model that is not ok
  bool after_rejection_ = false;
};

}  // namespace torsor::runtime
