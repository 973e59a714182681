// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "runtime/integration/adaptive_run.hpp"
#include "runtime/integration/integrate.hpp"
#include "runtime/status.hpp"
#include "runtime/steps/step_control.hpp"
#include "runtime/steps/taylor_step.hpp"
#include "runtime/system.hpp"

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

  explicit Formula(const Taylor& options) noexcept
      : order_(static_cast<std::size_t>(options.order)), chosen_(options.order == 0) {}

  static bool usable(const Taylor& o) noexcept {
    return o.order == 0 || (o.order >= least_order && o.order <= largest_order);
  }

  template <class F>
  Evaluation prepare(F& f, const StepRange<Scalar>& range, const Vector& y, const Tolerances<Scalar>& tolerances,
                     Scalar& length) {
    tolerances_ = tolerances;
    part_ = part_of(y);
    if (chosen_) order_ = order_for(part_);
    next_part_ = part_;
    next_order_ = order_;
    if (!f.jets(range.start, y, span(now(), order_))) return f.evaluation;
    if (!(length > Scalar(0))) {
      const Scalar reach = std::min(std::abs(range.end - range.start), range.longest);
      length = std::min(std::max(proposal(now(), order_, part_), range.shortest()), reach);
    }
    return Evaluation::ok;
  }

  // The polynomial by Horner's rule without its first coefficient, whose sum with the rest is the state's own, and its
  // slope by the derivative of that rule.
  template <class F>
  Evaluation attempt(F& f, Scalar t, Scalar h, State& state, const Tolerances<Scalar>& tolerances, Scalar& error) {
    const Coefficients& c = now();
    Vector rest = c[order_], slope{}, increment;
    for (std::size_t k = order_ - 1; k > 0; --k) {
      for (std::size_t i = 0; i < size; ++i) {
        slope[i] = slope[i] * h + rest[i];
        rest[i] = rest[i] * h + c[k][i];
      }
    }
    for (std::size_t i = 0; i < size; ++i) {
      slope[i] = slope[i] * h + rest[i];
      increment[i] = rest[i] * h;
    }
    state.propose(increment);
    if (!all_finite(state.next()) || !all_finite(slope)) return Evaluation::not_finite;
    if (!state.settle(f, t + h)) return f.evaluation;
    choose_next(state.next());
    if (!f.jets(t + h, state.next(), span(next(), next_order_))) return f.evaluation;
    Vector noise{};
    error = disagreement(h, slope, state, tolerances, noise);
    if (error > Scalar(1) && rounding_of_slopes(f, t + h, state, noise)) {
      error = disagreement(h, slope, state, tolerances, noise);
    }
    return std::isfinite(error) ? Evaluation::ok : Evaluation::not_finite;
  }

  [[nodiscard]] static Scalar shorter(Scalar h, Scalar) noexcept { return h / Scalar(2); }

  // From the coefficients at the end of the step; its own length limits how fast steps grow.
  [[nodiscard]] Scalar longer(Scalar h, Scalar, Scalar planned, bool after_rejection) const noexcept {
    const Scalar wanted = proposal(c_[1 - current_], next_order_, next_part_);
    return std::min(wanted, after_rejection ? Scalar(2) * h : Scalar(10) * std::max(h, planned));
  }

  template <class F>
  Evaluation refine(F&, Scalar, Scalar, const State&) noexcept {
    return Evaluation::ok;
  }

  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, Scalar, const State&) const noexcept {
    return Step(t, t_next, order_, c_[current_]);
  }

  void accept() noexcept {
    current_ = 1 - current_;
    order_ = next_order_;
    part_ = next_part_;
  }

 private:
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr std::size_t considered = 4;  // coefficients that decide on a step

  [[nodiscard]] Coefficients& now() noexcept { return c_[current_]; }
  [[nodiscard]] Coefficients& next() noexcept { return c_[1 - current_]; }

  [[nodiscard]] static std::span<Vector> span(Coefficients& c, std::size_t degree) noexcept {
    return {c.data(), degree + 1};
  }

  // The largest difference of the polynomial's slope at its end from the equations', beyond what rounding makes of
  // either, as a part of what is allowed.
  [[nodiscard]] Scalar disagreement(Scalar h, const Vector& slope, const State& state,
                                    const Tolerances<Scalar>& tolerances, const Vector& noise) noexcept {
    Scalar error = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar defect = std::abs(h * (slope[i] - next()[1][i]));
      const Scalar magnitude = std::max(std::abs(state.now()[i]), std::abs(state.next()[i]));
      const Scalar allowed = static_cast<Scalar>(order_ + 1) * (tolerances.absolute + tolerances.relative * magnitude);
      const Scalar rounding = std::abs(h) * (noise[i] + Scalar(16) * epsilon * std::abs(slope[i]));
      if (defect > rounding) error = std::max(error, (defect - rounding) / allowed);
    }
    return error;
  }

  // What the rounding of the state makes of each of its slopes, in that slope's own unit: how much they change when the
  // state moves by some roundings, of every component another number, so that no two cancel. False: they could not be
  // computed there.
  template <class F>
  [[nodiscard]] bool rounding_of_slopes(F& f, Scalar t, const State& state, Vector& noise) {
    Vector moved;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar magnitude = std::max(std::abs(state.now()[i]), std::abs(state.next()[i]));
      const Scalar roundings = static_cast<Scalar>(4 + i % 4) * (i % 2 == 0 ? epsilon : -epsilon);
      moved[i] = state.next()[i] + roundings * magnitude;
    }
    std::array<Vector, 2> there;
    if (!f.jets(t, moved, std::span<Vector>(there))) return false;
    for (std::size_t i = 0; i < size; ++i) noise[i] = std::abs(there[1][i] - next()[1][i]);
    return true;
  }

  // The tolerance as a part of the state's own size.
  [[nodiscard]] Scalar part_of(const Vector& y) const noexcept {
    Scalar largest = Scalar(0);
    for (const Scalar& value : y) largest = std::max(largest, std::abs(value));
    Scalar part = tolerances_.relative;
    if (tolerances_.absolute > Scalar(0)) part += largest > Scalar(0) ? tolerances_.absolute / largest : Scalar(0);
    return std::clamp(part > Scalar(0) ? part : tolerances_.absolute, epsilon, Scalar(0.1));
  }
  [[nodiscard]] static std::size_t order_for(Scalar part) noexcept {
    const double wanted = 1.0 - 0.55 * std::log(static_cast<double>(part));
    return static_cast<std::size_t>(
        std::clamp(2 * static_cast<int>(std::ceil(wanted / 2.0)), least_order, largest_order));
  }

  // What the next step is made with: the same, unless the order would be another by four.
  void choose_next(const Vector& y) noexcept {
    next_order_ = order_;
    next_part_ = part_;
    if (!chosen_ || !(tolerances_.absolute > Scalar(0))) return;
    const Scalar part = part_of(y);
    const std::size_t best = order_for(part);
    if (best + 4 > order_ && best < order_ + 4) return;
    next_order_ = best;
    next_part_ = part;
  }

  // The step that the coefficients at one time allow.
  [[nodiscard]] Scalar proposal(const Coefficients& c, std::size_t degree, Scalar part) const noexcept {
    Vector scale;
    for (std::size_t i = 0; i < size; ++i) {
      scale[i] = part / (tolerances_.absolute + tolerances_.relative * std::abs(c[0][i]));
    }
    Scalar steepest = -std::numeric_limits<Scalar>::infinity();  // log2 of 1/ρ
    for (std::size_t k = degree + 1 - considered; k <= degree; ++k) {
      Scalar norm = Scalar(0);
      for (std::size_t i = 0; i < size; ++i) norm = std::max(norm, scale[i] * std::abs(c[k][i]));
      if (norm > Scalar(0)) steepest = std::max(steepest, std::log2(norm) / static_cast<Scalar>(k));
    }
    return Scalar(0.95) * std::exp2(std::log2(part) / static_cast<Scalar>(degree + 1) - steepest);
  }

  Tolerances<Scalar> tolerances_{};
  Scalar part_ = Scalar(0), next_part_ = Scalar(0);
  std::size_t order_, next_order_ = 0;
  bool chosen_;
  std::array<Coefficients, 2> c_;  // at the start of a step and at its end, in turn
  std::size_t current_ = 0;
};

}  // namespace torsor::runtime
