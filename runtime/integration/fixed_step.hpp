// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// A formula for FixedStepRun made of an explicit one, `Explicit::increment(f, t, h, y, change) -> bool`, which writes
/// y(t + h) - y and returns false when the model failed: the sum is compensated on request.
template <class Explicit, class Scalar, std::size_t size>
class SummedFormula {
 public:
  using Vector = std::array<Scalar, size>;

  explicit SummedFormula(bool compensated) noexcept : compensated_(compensated) {}

  template <class F>
  [[nodiscard]] bool step(F& f, Scalar t, Scalar h, const Vector& y, Vector& next) {
    Vector change;
    if (!Explicit::increment(f, t, h, y, change)) return false;
    for (std::size_t i = 0; i < size; ++i) next[i] = compensated_ ? sums_.add(i, y[i], change[i]) : y[i] + change[i];
    return true;
  }

 private:
  bool compensated_;
  CompensatedState<Scalar, size> sums_;
};

/// The `Step` of a formula that has one.
template <class Formula>
struct StepOfFormula {};
template <class Formula>
requires requires { typename Formula::Step; }
struct StepOfFormula<Formula> {
  using Step = typename Formula::Step;
};

/// The steps that a method of fixed step takes at most unless told otherwise: a step mistaken by orders shows at once.
inline constexpr std::int64_t usual_fixed_step_limit = 1'000'000'000;

/// One integration with a fixed step: the part that all methods of fixed step share. `Formula` has
/// `step(f, t, h, y, next)`, which returns false when the model failed, or an IntegrationStatus. A formula that keeps
/// something from step to step (a compensation, a starting guess) is a value of its own in each integration; it may
/// have `prepare(f, t, y) -> IntegrationStatus`, called once before the first step.
///
/// One with an interpolant has a type `Step`, `refine(f, t, t_next, y, next) -> bool` (what only an interpolant needs,
/// at settled states) and `interpolant(t, t_next, y, next)`, asked for by observers that take steps only.
///
/// An interval is cut into the fewest steps of equal length that do not exceed the step asked for, so that its end is
/// hit exactly without a short last step. Times are start + k h, hence free of accumulated rounding. An interval that
/// would take more steps than are left of `step_limit` is refused before the first of them, `too_many_steps`.
template <class Formula, class S, class Scalar, std::size_t size>
class FixedStepRun : public StepOfFormula<Formula> {
 public:
  using Vector = std::array<Scalar, size>;

  FixedStepRun(S& system, Vector& y, Scalar t, double step, const Formula& formula = Formula{},
               std::int64_t step_limit = usual_fixed_step_limit) noexcept
      : f_(system), y_(y), step_(step), step_limit_(step_limit), formula_(formula) {
    result_.time = t;
  }

  template <class Observer>
  void advance(Scalar end, Observer& observer) {
    if (result_.status != IntegrationStatus::reached_end || !accept_interval(end)) return;
    const Scalar start = result_.time;
    const std::int64_t count = count_of(start, end);
    if (count > step_limit_ - result_.statistics.accepted) {
      result_.status = IntegrationStatus::too_many_steps;
      return;
    }
    if (count == 0 || !prepare()) return;
    const Wide wide_h = (static_cast<Wide>(end) - static_cast<Wide>(start)) / static_cast<Wide>(count);
    const Scalar h = static_cast<Scalar>(wide_h);
    if (!(std::abs(h) > resolution(start, end))) result_.status = IntegrationStatus::step_too_small;
    Vector next;
    for (std::int64_t k = 1; k <= count && result_.status == IntegrationStatus::reached_end; ++k) {
      if (!completes(formula_.step(f_, result_.time, h, y_, next))) return;
      if (!all_finite(next)) return fail(Evaluation::not_finite);
      const Scalar time =
          k == count ? end : static_cast<Scalar>(static_cast<Wide>(start) + static_cast<Wide>(k) * wide_h);
      const Vector before = next;
      if (!f_.settle(time, next)) return fail(f_.evaluation);
      if (!keep(time, before, next, observer)) return;
    }
  }

  void stop() noexcept { result_.status = IntegrationStatus::stopped_by_observer; }

  [[nodiscard]] Result<Scalar> result() const noexcept {
    Result<Scalar> result = result_;
    result.statistics.calls = f_.calls;
    result.statistics.jacobians = f_.jacobians;
    result.statistics.decompositions = f_.decompositions;
    return result;
  }

 private:
  using Wide = std::common_type_t<double, Scalar>;  // a float could not count its steps beyond 2^24
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr double most_steps = 1e15;  // below 2^53, so that k is exact in Wide

  static Scalar resolution(Scalar start, Scalar end) noexcept {
    return epsilon * std::max(std::abs(start), std::abs(end));
  }

  bool accept_interval(Scalar end) noexcept {
    if (!(step_ > 0.0) || !std::isfinite(step_) || step_limit_ < 1 || !std::isfinite(end) || !std::isfinite(result_.time) ||
        !all_finite(y_)) {
      result_.status = IntegrationStatus::invalid_options;
    } else if (!(std::abs(static_cast<double>(end) - static_cast<double>(result_.time)) / step_ < most_steps)) {
      result_.status = IntegrationStatus::step_too_small;
    }
    return result_.status == IntegrationStatus::reached_end;
  }

  // A quotient that exceeds a whole number by rounding alone (0.3 of a float over 0.1) must not cost one more step.
  std::int64_t count_of(Scalar start, Scalar end) const noexcept {
    const double quotient = std::abs(static_cast<double>(end) - static_cast<double>(start)) / step_;
    return static_cast<std::int64_t>(std::ceil(quotient * (1.0 - 4.0 * static_cast<double>(epsilon))));
  }

  // Tells the observer and moves on; the inside of the step is only made for those who take it.
  template <class Observer>
  bool keep(Scalar time, [[maybe_unused]] const Vector& before, const Vector& next, Observer& observer) {
    ++result_.statistics.accepted;
    if constexpr (takes_steps<Observer, typename StepOfRun<StepOfFormula<Formula>>::type>) {
      if (!formula_.refine(f_, result_.time, time, y_, next)) {
        --result_.statistics.accepted;
        fail(f_.evaluation);
        return false;
      }
      const auto step = formula_.interpolant(result_.time, time, y_, f_.unwound(next, before));
      y_ = next;
      result_.time = time;
      if (!notify(observer, step)) stop();
    } else {
      y_ = next;
      result_.time = time;
      if (!notify(observer, time, y_)) stop();
    }
    return true;
  }

  bool prepare() {
    if constexpr (requires { formula_.prepare(f_, result_.time, y_); }) {
      if (!prepared_) return prepared_ = completes(formula_.prepare(f_, result_.time, y_));
    }
    return true;
  }

  bool completes(bool evaluated) noexcept {
    if (!evaluated) fail(f_.evaluation);
    return evaluated;
  }
  bool completes(IntegrationStatus status) noexcept {
    if (status == IntegrationStatus::model_failure) {
      fail(f_.evaluation);
    } else {
      result_.status = status;
    }
    return status == IntegrationStatus::reached_end;
  }

  void fail(Evaluation evaluation) noexcept {
    result_.status = IntegrationStatus::model_failure;
    result_.evaluation = evaluation;
  }

  CheckedSystem<S, Scalar, size> f_;
  Vector& y_;
  double step_;
  std::int64_t step_limit_;
  Formula formula_;
  bool prepared_ = false;
  Result<Scalar> result_;
};

}  // namespace torsor::runtime
