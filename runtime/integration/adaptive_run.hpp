// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/accumulated_state.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/steps/settling_bound.hpp"
#include "torsor/runtime/steps/step_clock.hpp"
#include "torsor/runtime/steps/step_control.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// One integration under way with steps of a method's own choice: the part that all adaptive methods share (the clock,
/// limits, rejections, statuses, statistics, observers). `advance` may be called again and again; the step length is
/// kept from call to call.
///
/// `Options` has relative_tolerance, absolute_tolerance, first_step, largest_step, step_limit and compensated.
/// `Formula` has
///   Step                                              what observers may evaluate inside a step;
///   usable(options)                                   whether its own options make sense;
///   prepare(f, ahead, length)                         the first slopes, and the first length where `length` is 0;
///   attempt(f, t, h, state, error)                    one step to state.next(), kept when its weighted error is <= 1;
///   shorter(h, error), longer(h, error, planned, after_rejection)   lengths to try next;
///   refine(f, t, h, state)                            what only an interpolant needs, before the step is kept;
///   settles                                           declared where attempt has settled the state already;
///   interpolant(t, t_next, h, state), accept()        before and after the step is kept.
/// The functions that call the model return an Evaluation; one that is not ok rejects the step.
template <class Formula, class Options, class S, class Scalar, std::size_t size>
class AdaptiveRun {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = typename Formula::Step;

  AdaptiveRun(S& system, Vector& y, Scalar t, const Options& options) noexcept
      : f_(system),
        options_(options),
        tolerances_{static_cast<Scalar>(options.relative_tolerance), static_cast<Scalar>(options.absolute_tolerance)},
        clock_(options.largest_step),
        state_(y, options.compensated),
        formula_(options) {
    clock_.result.time = t;
  }

  template <class Observer>
  void advance(Scalar end, Observer& observer) {
    if (!running() || !usable(end)) return;
    if (end == clock_.result.time) return;
    if (!prepared_ && !prepare(end)) return;
    clock_.set_out();
    while (clock_.result.time != end) {
      if (!clock_.plan(end, options_.step_limit)) return;
      const Scalar t = clock_.result.time, h = clock_.h, length = std::abs(h);
      Scalar error = Scalar(0);
      const Evaluation evaluation = attempt<Observer>(t, h, error);
      if (evaluation != Evaluation::ok || !(error <= Scalar(1))) {
        if (evaluation != Evaluation::ok) error = std::numeric_limits<Scalar>::infinity();
        clock_.refuse(evaluation, formula_.shorter(length, error));
        continue;
      }
      clock_.keep(formula_.longer(length, error, clock_.length, clock_.after_rejection()));
      if (!keep(t, clock_.t_next, h, observer)) stop();
      if (!running()) return;
    }
  }

  /// Goes on from the same time and state with equations that may have become others: the first slope is taken anew. The step
  /// length and what a formula knows beside, as a Jacobian that still serves, are kept. Limits and statistics count from here.
  void renew() noexcept {
    prepared_ = false;
    clock_.count_anew();
    f_.calls = f_.jacobians = f_.decompositions = 0;
  }

  void stop() noexcept { clock_.result.status = IntegrationStatus::stopped_by_observer; }

  [[nodiscard]] Result<Scalar> result() const noexcept {
    Result<Scalar> result = clock_.result;
    result.statistics.calls = f_.calls;
    result.statistics.jacobians = f_.jacobians;
    result.statistics.decompositions = f_.decompositions;
    return result;
  }

 private:
  [[nodiscard]] bool running() const noexcept { return clock_.result.status == IntegrationStatus::reached_end; }

  bool usable(Scalar end) noexcept {
    const auto& o = options_;
    using Precision = typename PrecisionOf<S, Scalar>::type;
    const bool options = Tolerances<Precision>::usable(o.relative_tolerance, o.absolute_tolerance) &&
                         o.first_step >= 0.0 && o.largest_step >= 0.0 && o.step_limit > 0 && Formula::usable(o);
    if (!options || !std::isfinite(end) || !std::isfinite(clock_.result.time) || !all_finite(state_.now())) {
      clock_.result.status = IntegrationStatus::invalid_options;
    }
    return running();
  }

  bool prepare(Scalar end) {
    const StepsAhead<Scalar, size> ahead{
        .range = {clock_.result.time, end, clock_.largest}, .y = state_.now(), .tolerances = tolerances_};
    if (!(clock_.length > Scalar(0))) clock_.length = std::min(static_cast<Scalar>(options_.first_step), clock_.largest);
    clock_.refusal = formula_.prepare(f_, ahead, clock_.length);
    prepared_ = clock_.refusal == Evaluation::ok;
    if (!prepared_) clock_.give_up();
    return prepared_;
  }

  template <class Observer>
  Evaluation attempt(Scalar t, Scalar h, Scalar& error) {
    const Evaluation evaluation = formula_.attempt(f_, t, h, state_, error);
    if (evaluation != Evaluation::ok || !(error <= Scalar(1))) return evaluation;
    if constexpr (!requires { Formula::settles; }) {
      if (!state_.settle(f_, t + h)) return f_.evaluation;
    }
    if constexpr (Settles<S, Scalar, size>) {
      const Scalar moved = settling(t);
      if (!(moved <= Scalar(1))) {
        error = moved;
        return evaluation;
      }
    }
    if constexpr (takes_steps<Observer, Step>) return formula_.refine(f_, t, h, state_);
    return evaluation;
  }

  // How far settling moved the end of the step, over the most that it may. An open start is closed by the first step.
  Scalar settling(Scalar t) noexcept {
    using Precision = typename PrecisionOf<S, Scalar>::type;
    const SettlingBound<Scalar, Precision> bound{tolerances_};
    const auto share = [&](const Vector& before, const Vector& settled) {
      return bound.share(state_.now(), before, f_.unwound(settled, before));
    };
    const Scalar moved = share(state_.unsettled(), state_.next());
    if (moved <= Scalar(1) || !at_start_) return moved;
    if (!(open_ >= Scalar(0))) {
      Vector closed = state_.now();
      open_ = f_.settle(t, closed) ? share(state_.now(), closed) : Scalar(0);
    }
    return moved / std::max(Scalar(1), Scalar(2) * open_);
  }

  // Tells the observer and moves on; the interpolant is only built for those who take it, between settled states. The
  // last slope stays when the state is settled: it moves by less than the error estimate.
  template <class Observer>
  bool keep(Scalar t, Scalar t_next, Scalar h, Observer& observer) {
    if constexpr (takes_steps<Observer, Step>) {
      const Step step = interpolant(t, t_next, h);
      move_on();
      return notify(observer, step);
    } else {
      move_on();
      return notify(observer, t_next, state_.now());
    }
  }

  // Led to where the step went, not to where settling brought coordinates that jump.
  Step interpolant(Scalar t, Scalar t_next, Scalar h) noexcept {
    if constexpr (!requires { Formula::settles; }) {
      const Vector settled = state_.next();
      state_.replace(f_.unwound(settled, state_.unsettled()));
      const Step step = formula_.interpolant(t, t_next, h, state_);
      state_.replace(settled);
      return step;
    } else {
      return formula_.interpolant(t, t_next, h, state_);
    }
  }

  void move_on() noexcept {
    at_start_ = false;
    state_.accept();
    formula_.accept();
  }

  CheckedSystem<S, Scalar, size> f_;
  Options options_;
  Tolerances<Scalar> tolerances_;
  StepClock<Scalar> clock_;
  bool prepared_ = false;
  bool at_start_ = true;      // no step has been kept
  Scalar open_ = Scalar(-1);  // how far the start is moved by settling, as `settling` has it; not known below 0
  AccumulatedState<Scalar, size> state_;
  Formula formula_;
};

}  // namespace torsor::runtime
