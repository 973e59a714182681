// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "torsor/runtime/integration/adaptive_run.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/step_control.hpp"
#include "torsor/runtime/steps/taylor_rule.hpp"
#include "torsor/runtime/steps/taylor_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Taylor's method for systems that give the Taylor coefficients of their motions:
///   system.jets(t, y, std::span<std::array<Scalar, size>> c):  c[k] = y^(k)(t) / k!,  c[0] = y,
/// such as `equations_of_motion` of a header with the kernel `jets`. The fastest of the explicit methods for
/// few bodies, at any tolerance. Its polynomial is the state at all times of a step, ends included.
///
/// Order and step. The last four coefficients each give a radius ρ_k = |c_k|^(-1/k), in units of the state's own size
/// (largest component, weighted as errors are); the step is that at which a term of order p + 1 with the least of them
/// meets the tolerance ε, h = 0.95 ρ ε^(1/(p+1)). The order p = 1 - 0.55 ln ε was found by measuring: a higher one
/// makes longer steps of more work; it is chosen anew where the state's size has changed so much, against an absolute
/// tolerance, that p would be another by four. Source: Jorba & Zou, Experimental Mathematics 14 (2005) 99-117, who take
/// two coefficients.
///
/// No step is believed for its coefficients alone, which vanish at regular orders for some motions: the polynomial's
/// slope at its end must agree with the equations' there, c[1] of the next step,
///   h |y_p'(t + h) - f(t + h, y_p(t + h))| <= (p + 1) (absolute + relative |y|)   in each component,
/// which is the same as a local error within the tolerance; otherwise the step is halved. Only what rounding makes of
/// the two slopes is not held against a step; for the equations' that is measured, component by component, by a second
/// evaluation where the first disagrees.
struct Taylor {
  double relative_tolerance = 1e-9;      ///< 0, or at least four roundings of the scalar
  double absolute_tolerance = 1e-12;     ///< in the units of the state, the same for every component
  int order = 0;                         ///< 4 to 30; 0: chosen from the tolerances
  double first_step = 0.0;               ///< 0: chosen from the coefficients
  double largest_step = 0.0;             ///< 0: no limit
  std::int64_t step_limit = 10'000'000;  ///< accepted and rejected together
  bool compensated = false;              ///< carry what rounding loses of each sum of state and step

  static constexpr int least_order = 4, largest_order = 30;

  template <class Scalar, std::size_t size>
  class Formula;

  template <class S, class Scalar, std::size_t size>
  requires HasTaylorCoefficients<S, Scalar, size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    return AdaptiveRun<Formula<Scalar, size>, Taylor, S, Scalar, size>(system, y, t, *this);
  }
};

/// Coefficients, step and defect; see AdaptiveRun.
template <class Scalar, std::size_t size>
class Taylor::Formula {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = TaylorStep<Scalar, size>;
  using State = AccumulatedState<Scalar, size>;
  using Coefficients = typename Step::Coefficients;
  static constexpr bool settles = true;

  explicit Formula(const Taylor& options) noexcept : rule_(options.order) {}

  static bool usable(const Taylor& o) noexcept {
    return o.order == 0 || (o.order >= least_order && o.order <= largest_order);
  }

  template <class F>
  Evaluation prepare(F& f, const StepsAhead<Scalar, size>& ahead, Scalar& length) {
    rule_.start(ahead.y, ahead.tolerances);
    if (!f.jets(ahead.range.start, ahead.y, span(now(), rule_.order()))) return f.evaluation;
    if (!(length > Scalar(0))) length = rule_.first(each(now()), ahead.range);
    return Evaluation::ok;
  }

  template <class F>
  Evaluation attempt(F& f, Scalar t, Scalar h, State& state, Scalar& error) {
    Vector slope, increment;
    evaluate_taylor(span(now(), rule_.order()), h, increment, slope);
    state.propose(increment);
    if (!all_finite(state.next()) || !all_finite(slope)) return Evaluation::not_finite;
    if (!state.settle(f, t + h)) return f.evaluation;
    rule_.choose_next(state.next());
    if (!f.jets(t + h, state.next(), span(next(), rule_.next_order()))) return f.evaluation;
    Vector noise{};
    const EndSlopes<Scalar, size> slopes{.polynomial = slope, .equations = next()[1], .noise = noise};
    error = rule_.disagreement(h, slopes, state.now(), state.next());
    if (error > Scalar(1) && rounding_of_slopes(f, t + h, state, noise)) {
      error = rule_.disagreement(h, slopes, state.now(), state.next());
    }
    return std::isfinite(error) ? Evaluation::ok : Evaluation::not_finite;
  }

  [[nodiscard]] static Scalar shorter(Scalar h, Scalar) noexcept { return TaylorRule<Scalar, size>::shorter(h); }

  [[nodiscard]] Scalar longer(Scalar h, Scalar, Scalar planned, bool after_rejection) const noexcept {
    return rule_.longer(each(c_[1 - current_]), h, planned, after_rejection);
  }

  template <class F>
  Evaluation refine(F&, Scalar, Scalar, const State&) noexcept {
    return Evaluation::ok;
  }

  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, Scalar, const State&) const noexcept {
    return Step(t, t_next, rule_.order(), c_[current_]);
  }

  void accept() noexcept {
    current_ = 1 - current_;
    rule_.accept();
  }

 private:
  [[nodiscard]] Coefficients& now() noexcept { return c_[current_]; }
  [[nodiscard]] Coefficients& next() noexcept { return c_[1 - current_]; }

  [[nodiscard]] static std::span<Vector> span(Coefficients& c, std::size_t degree) noexcept {
    return {c.data(), degree + 1};
  }
  [[nodiscard]] static auto each(const Coefficients& c) noexcept {
    return [&c](std::size_t k) -> const Vector& { return c[k]; };
  }

  // False: the slopes could not be computed there.
  template <class F>
  [[nodiscard]] bool rounding_of_slopes(F& f, Scalar t, const State& state, Vector& noise) {
    const Vector moved = TaylorRule<Scalar, size>::some_roundings_from(state.now(), state.next());
    std::array<Vector, 2> there;
    if (!f.jets(t, moved, std::span<Vector>(there))) return false;
    for (std::size_t i = 0; i < size; ++i) noise[i] = std::abs(there[1][i] - next()[1][i]);
    return true;
  }

  TaylorRule<Scalar, size> rule_;
  std::array<Coefficients, 2> c_;  // at the start of a step and at its end, in turn
  std::size_t current_ = 0;
};

}  // namespace torsor::runtime
