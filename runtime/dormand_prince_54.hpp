// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "runtime/dense_step.hpp"
#include "runtime/dormand_prince_tableau.hpp"
#include "runtime/integrate.hpp"
#include "runtime/status.hpp"
#include "runtime/system.hpp"

namespace torsor::runtime {

/// Dormand-Prince 5(4): an error of order 5 estimated against an embedded order 4, first stage same as last, a
/// proportional-integral step control and an interpolant of order 4.
///
/// A step is kept when  sqrt(1/n Σ (e_i / (absolute + relative max(|y_i|, |y_i next|)))²) <= 1.  A stage that the model
/// refuses, or that is not finite, rejects the step; so does a state that overflows.
/// Source: Hairer-Nørsett-Wanner I, II.4 (error norm 4.11, starting step 4.14), II.5 (pair); Hairer-Wanner II, IV.2
/// (control).
struct DormandPrince54 {
  double relative_tolerance = 1e-9;      ///< 0, or at least four roundings of the scalar
  double absolute_tolerance = 1e-12;     ///< in the units of the state, the same for every component
  double first_step = 0.0;               ///< 0: chosen from the equations
  double largest_step = 0.0;             ///< 0: no limit
  std::int64_t step_limit = 10'000'000;  ///< accepted and rejected together

  template <class S, class Scalar, std::size_t size>
  class Run;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    return Run<S, Scalar, size>(system, y, t, *this);
  }
};

/// One integration under way. `advance` may be called again and again; the step length is kept from call to call.
template <class S, class Scalar, std::size_t size>
class DormandPrince54::Run {
 public:
  using Vector = std::array<Scalar, size>;

  Run(S& system, Vector& y, Scalar t, const DormandPrince54& options) noexcept
      : f_(system),
        y_(y),
        options_(options),
        relative_(static_cast<Scalar>(options.relative_tolerance)),
        absolute_(static_cast<Scalar>(options.absolute_tolerance)),
        largest_(options.largest_step > 0.0 ? static_cast<Scalar>(options.largest_step)
                                            : std::numeric_limits<Scalar>::infinity()) {
    result_.time = t;
  }

  template <class Observer>
  void advance(Scalar end, Observer& observer) {
    if (result_.status != IntegrationStatus::reached_end || !usable(end)) return;
    if (end == result_.time) return;
    if (!prepared_ && !prepare(end)) return;
    bool after_rejection = false;
    while (result_.time != end) {
      const Scalar t = result_.time;
      const Scalar remaining = end - t;
      // A step that all but reaches the end is stretched to it, so that none of a rounding's length is left over.
      const bool last = length_ * Scalar(1.01) >= std::abs(remaining);
      const Scalar t_next = last ? end : t + std::copysign(length_, remaining);
      const Scalar h = t_next - t;  // what the clock really advances, so that rounding of time never accumulates
      if (!last && !(std::abs(h) > smallest_step(t))) return give_up();
      if (result_.statistics.accepted + result_.statistics.rejected >= options_.step_limit) {
        result_.status = IntegrationStatus::too_many_steps;
        return;
      }
      Scalar error = Scalar(0);
      refusal_ = attempt(t, h, error);
      if (refusal_ != Evaluation::ok || !(error <= Scalar(1))) {
        ++result_.statistics.rejected;
        length_ = std::abs(h) * (refusal_ == Evaluation::ok ? shrink(error) : strongest_shrink);
        after_rejection = true;
        continue;
      }
      propose(std::abs(h), error, after_rejection);
      after_rejection = false;
      ++result_.statistics.accepted;
      if (!keep(t, t_next, h, observer)) stop();
      if (result_.status != IntegrationStatus::reached_end) return;
    }
  }

  void stop() noexcept { result_.status = IntegrationStatus::stopped_by_observer; }

  [[nodiscard]] Result<Scalar> result() const noexcept {
    Result<Scalar> result = result_;
    result.statistics.calls = f_.calls;
    return result;
  }

 private:
  using Tableau = DormandPrinceTableau<Scalar>;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar safety = Scalar(0.9), strongest_shrink = Scalar(0.2), strongest_growth = Scalar(10);
  static constexpr Scalar integral_exponent = Scalar(0.04);  // Hairer's beta
  static constexpr Scalar exponent = Scalar(0.2) - integral_exponent * Scalar(0.75);

  static Scalar smallest_step(Scalar t) noexcept {
    return std::max(Scalar(10) * epsilon * std::abs(t), std::numeric_limits<Scalar>::min());
  }

  bool usable(Scalar end) noexcept {
    const auto& o = options_;
    const bool relative_works =
        o.relative_tolerance == 0.0 || o.relative_tolerance >= 4.0 * static_cast<double>(epsilon);
    const bool tolerances = relative_works && std::isfinite(o.relative_tolerance) && o.absolute_tolerance >= 0.0 &&
                            std::isfinite(o.absolute_tolerance) && o.relative_tolerance + o.absolute_tolerance > 0.0;
    const bool steps = o.first_step >= 0.0 && o.largest_step >= 0.0 && o.step_limit > 0;
    if (!tolerances || !steps || !std::isfinite(end) || !std::isfinite(result_.time) || !all_finite(y_)) {
      result_.status = IntegrationStatus::invalid_options;
    }
    return result_.status == IntegrationStatus::reached_end;
  }

  void give_up() noexcept {
    result_.evaluation = refusal_;
    result_.status = refusal_ == Evaluation::ok ? IntegrationStatus::step_too_small : IntegrationStatus::model_failure;
  }

  // The first slope and the first step: a step that changes y by a hundredth of its own scale, tried with Euler's
  // method, gives the second derivative, and that the length at which the error terms reach a hundredth of the
  // tolerance.
  bool prepare(Scalar end) {
    if (!f_(result_.time, y_, k1_)) {
      refusal_ = f_.evaluation;
      give_up();
      return false;
    }
    prepared_ = true;
    if (options_.first_step > 0.0) {
      length_ = std::min(static_cast<Scalar>(options_.first_step), largest_);
      return true;
    }
    const Scalar reach = std::abs(end - result_.time);
    const Scalar d0 = norm(y_), d1 = norm(k1_), little = Scalar(1e-5);
    Scalar h0 = d0 < little || d1 < little ? Scalar(1e-6) : Scalar(0.01) * d0 / d1;
    // Far from time 0 the clock itself sets a least step, which the equations know nothing of.
    const Scalar least = Scalar(100) * epsilon * std::abs(result_.time);
    h0 = std::min({std::max(h0, least), largest_, reach});
    const Scalar signed_h0 = std::copysign(h0, end - result_.time);
    for (std::size_t i = 0; i < size; ++i) next_[i] = y_[i] + signed_h0 * k1_[i];
    length_ = h0;
    // Where the trial step leaves the model's domain, the step control finds the way back from h0.
    if (!f_(result_.time + signed_h0, next_, k2_)) return true;
    for (std::size_t i = 0; i < size; ++i) k3_[i] = (k2_[i] - k1_[i]) / h0;
    const Scalar slope = std::max(d1, norm(k3_));
    const Scalar h1 = slope <= Scalar(1e-15) ? std::max(Scalar(1e-6), h0 * Scalar(1e-3))
                                             : std::pow(Scalar(0.01) / slope, Scalar(0.2));
    const Scalar proposal = std::min(std::max(std::min(Scalar(100) * h0, h1), least), largest_);
    if (std::isfinite(proposal) && proposal > Scalar(0)) length_ = proposal;
    return true;
  }

  Scalar norm(const Vector& v) const noexcept {
    Scalar sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) sum += weighted_square(v[i], std::abs(y_[i]));
    return std::sqrt(sum / static_cast<Scalar>(size));
  }

  // A component that is exactly zero weighs nothing even when its tolerance is zero too.
  Scalar weighted_square(Scalar value, Scalar magnitude) const noexcept {
    if (value == Scalar(0)) return Scalar(0);
    const Scalar ratio = value / (absolute_ + relative_ * magnitude);
    return ratio * ratio;
  }

  // One step of length h to next_, its last slope in k7_; the weighted error is that of the embedded formula.
  Evaluation attempt(Scalar t, Scalar h, Scalar& error) {
    using T = Tableau;
    for (std::size_t i = 0; i < size; ++i) next_[i] = y_[i] + h * (T::a21 * k1_[i]);
    if (!f_(t + T::c2 * h, next_, k2_)) return f_.evaluation;
    for (std::size_t i = 0; i < size; ++i) next_[i] = y_[i] + h * (T::a31 * k1_[i] + T::a32 * k2_[i]);
    if (!f_(t + T::c3 * h, next_, k3_)) return f_.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      next_[i] = y_[i] + h * (T::a41 * k1_[i] + T::a42 * k2_[i] + T::a43 * k3_[i]);
    }
    if (!f_(t + T::c4 * h, next_, k4_)) return f_.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      next_[i] = y_[i] + h * (T::a51 * k1_[i] + T::a52 * k2_[i] + T::a53 * k3_[i] + T::a54 * k4_[i]);
    }
    if (!f_(t + T::c5 * h, next_, k5_)) return f_.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      next_[i] = y_[i] + h * (T::a61 * k1_[i] + T::a62 * k2_[i] + T::a63 * k3_[i] + T::a64 * k4_[i] + T::a65 * k5_[i]);
    }
    if (!f_(t + h, next_, k6_)) return f_.evaluation;
    for (std::size_t i = 0; i < size; ++i) {
      next_[i] = y_[i] + h * (T::a71 * k1_[i] + T::a73 * k3_[i] + T::a74 * k4_[i] + T::a75 * k5_[i] + T::a76 * k6_[i]);
    }
    if (!all_finite(next_)) return Evaluation::not_finite;
    if (!f_(t + h, next_, k7_)) return f_.evaluation;
    Scalar sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar e =
          h * (T::e1 * k1_[i] + T::e3 * k3_[i] + T::e4 * k4_[i] + T::e5 * k5_[i] + T::e6 * k6_[i] + T::e7 * k7_[i]);
      sum += weighted_square(e, std::max(std::abs(y_[i]), std::abs(next_[i])));
    }
    error = std::sqrt(sum / static_cast<Scalar>(size));
    return Evaluation::ok;
  }

  static Scalar shrink(Scalar error) noexcept {
    return std::isfinite(error) ? std::max(strongest_shrink, safety / std::pow(error, exponent)) : strongest_shrink;
  }

  void propose(Scalar h, Scalar error, bool after_rejection) noexcept {
    const Scalar wanted = safety * std::pow(memory_, integral_exponent) / std::pow(error, exponent);
    const Scalar factor = error > Scalar(0) ? std::clamp(wanted, strongest_shrink, strongest_growth) : strongest_growth;
    const bool cut_short = h < length_ * Scalar(0.99);
    Scalar proposal = h * factor;
    if (after_rejection) proposal = std::min(proposal, h);
    // A step cut short by the end says little about how long the next one may be.
    if (cut_short)
      proposal = std::max(proposal, length_);
    else
      memory_ = std::max(error, Scalar(1e-4));
    length_ = std::min(proposal, largest_);
  }

  // Tells the observer and moves on; the interpolant is only built for those who take it.
  template <class Observer>
  bool keep(Scalar t, Scalar t_next, Scalar h, Observer& observer) {
    constexpr bool dense = std::is_invocable_v<Observer&, const DenseStep<Scalar, size>&>;
    result_.time = t_next;
    f_.settle(next_);  // the slope k7 stays: it moves by less than the error estimate
    bool go_on = true;
    if constexpr (dense) {
      const DenseStep<Scalar, size> step = interpolant(t, t_next, h);
      advance_state();
      go_on = notify(observer, step);
    } else {
      advance_state();
      go_on = notify(observer, t_next, y_);
    }
    return go_on;
  }

  void advance_state() noexcept {
    y_ = next_;
    k1_ = k7_;
  }

  DenseStep<Scalar, size> interpolant(Scalar t, Scalar t_next, Scalar h) const noexcept {
    using T = Tableau;
    DenseStep<Scalar, size> step{t, t_next, {}};
    auto& c = step.coefficients;
    for (std::size_t i = 0; i < size; ++i) {
      c[0][i] = y_[i];
      c[1][i] = next_[i] - y_[i];
      c[2][i] = h * k1_[i] - c[1][i];
      c[3][i] = c[1][i] - h * k7_[i] - c[2][i];
      c[4][i] =
          h * (T::d1 * k1_[i] + T::d3 * k3_[i] + T::d4 * k4_[i] + T::d5 * k5_[i] + T::d6 * k6_[i] + T::d7 * k7_[i]);
    }
    return step;
  }

  CheckedSystem<S, Scalar, size> f_;
  Vector& y_;
  DormandPrince54 options_;
  Scalar relative_, absolute_, largest_;
  Scalar length_ = Scalar(0);     // of the step to try next, positive
  Scalar memory_ = Scalar(1e-4);  // the last error kept, for the integral part of the control
  Evaluation refusal_ = Evaluation::ok;
  bool prepared_ = false;
  Result<Scalar> result_;
  Vector k1_, k2_, k3_, k4_, k5_, k6_, k7_, next_;
};

}  // namespace torsor::runtime
