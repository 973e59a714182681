// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "torsor/runtime/steps/step_control.hpp"

namespace torsor::runtime {

/// Slopes at the end of a step.
template <class Scalar, std::size_t size>
struct EndSlopes {
  const std::array<Scalar, size>& polynomial;  ///< of the step
  const std::array<Scalar, size>& equations;   ///< y' of the state there
  const std::array<Scalar, size>& noise;       ///< what rounding makes of that
};

/// Order, step and defect of Taylor's method for one motion; see Taylor. Coefficients are taken one by one from a
/// callable, `c(k)` = y^(k)/k!, so that they may lie anywhere.
template <class Scalar, std::size_t size>
class TaylorRule {
 public:
  using Vector = std::array<Scalar, size>;

  /// An order of 0 is chosen from the tolerances and the state.
  explicit TaylorRule(int order) noexcept : order_(static_cast<std::size_t>(order)), chosen_(order == 0) {}

  /// For the step that begins in y.
  void start(const Vector& y, const Tolerances<Scalar>& tolerances) noexcept {
    tolerances_ = tolerances;
    part_ = part_of(y);
    if (chosen_) order_ = order_for(part_);
    next_part_ = part_;
    next_order_ = order_;
  }

  [[nodiscard]] std::size_t order() const noexcept { return order_; }
  [[nodiscard]] std::size_t next_order() const noexcept { return next_order_; }

  /// What the step after one that ends in y is made with: the same, unless the order would be another by four.
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
  void accept() noexcept {
    order_ = next_order_;
    part_ = next_part_;
  }

  /// The first step, from the coefficients where it begins.
  template <class Coefficients>
  [[nodiscard]] Scalar first(const Coefficients& c, const StepRange<Scalar>& range) const noexcept {
    const Scalar reach = std::min(std::abs(range.end - range.start), range.longest);
    return std::min(std::max(proposal(c, order_, part_), range.shortest()), reach);
  }
  [[nodiscard]] static Scalar shorter(Scalar h) noexcept { return h / Scalar(2); }
  /// After a step of length h, planned before the end cut it short, from the coefficients at its end; its own length
  /// limits how fast steps grow.
  template <class Coefficients>
  [[nodiscard]] Scalar longer(const Coefficients& c, Scalar h, Scalar planned, bool after_rejection) const noexcept {
    const Scalar wanted = proposal(c, next_order_, next_part_);
    return std::min(wanted, after_rejection ? Scalar(2) * h : Scalar(10) * std::max(h, planned));
  }

  /// The largest difference of the polynomial's slope at its end from the equations', beyond what rounding makes of
  /// either, as a part of what is allowed.
  [[nodiscard]] Scalar disagreement(Scalar h, const EndSlopes<Scalar, size>& slopes, const Vector& now,
                                    const Vector& next) const noexcept {
    const Vector &slope = slopes.polynomial, &noise = slopes.noise;
    Scalar error = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar defect = std::abs(h * (slope[i] - slopes.equations[i]));
      const Scalar magnitude = std::max(std::abs(now[i]), std::abs(next[i]));
      const Scalar allowed =
          static_cast<Scalar>(order_ + 1) * (tolerances_.absolute + tolerances_.relative * magnitude);
      const Scalar rounding = std::abs(h) * (noise[i] + Scalar(16) * epsilon * std::abs(slope[i]));
      if (defect > rounding) error = std::max(error, (defect - rounding) / allowed);
    }
    return error;
  }

  /// The state at the end of a step, moved by some roundings, of every component another number, so that no two cancel.
  /// What this changes of a slope is what rounding makes of it, in that slope's own unit.
  [[nodiscard]] static Vector some_roundings_from(const Vector& now, const Vector& next) noexcept {
    Vector moved;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar magnitude = std::max(std::abs(now[i]), std::abs(next[i]));
      const Scalar roundings = static_cast<Scalar>(4 + i % 4) * (i % 2 == 0 ? epsilon : -epsilon);
      moved[i] = next[i] + roundings * magnitude;
    }
    return moved;
  }

 private:
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr std::size_t considered = 4;  // coefficients that decide on a step

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
    return static_cast<std::size_t>(std::clamp(2 * static_cast<int>(std::ceil(wanted / 2.0)), 4, 30));
  }

  // The step that the coefficients at one time allow.
  template <class Coefficients>
  [[nodiscard]] Scalar proposal(const Coefficients& c, std::size_t degree, Scalar part) const noexcept {
    const Vector& state = c(0);
    Vector scale;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar allowed = tolerances_.absolute + tolerances_.relative * std::abs(state[i]);
      scale[i] = allowed > Scalar(0) ? part / allowed : Scalar(0);  // what is zero has no scale before it moves
    }
    Scalar steepest = -std::numeric_limits<Scalar>::infinity();  // log2 of 1/ρ
    for (std::size_t k = degree + 1 - considered; k <= degree; ++k) {
      const Vector& coefficient = c(k);
      Scalar norm = Scalar(0);
      for (std::size_t i = 0; i < size; ++i) norm = std::max(norm, scale[i] * std::abs(coefficient[i]));
      if (norm > Scalar(0)) steepest = std::max(steepest, std::log2(norm) / static_cast<Scalar>(k));
    }
    return Scalar(0.95) * std::exp2(std::log2(part) / static_cast<Scalar>(degree + 1) - steepest);
  }

  Tolerances<Scalar> tolerances_{};
  Scalar part_ = Scalar(0), next_part_ = Scalar(0);
  std::size_t order_, next_order_ = 0;
  bool chosen_;
};

/// What the polynomial y + h c_1 + ... + h^p c_p adds to y, and its slope at h, by Horner's rule without the first
/// coefficient, whose sum with the rest is the state's own, and by the derivative of that rule. Of numbers or packs.
template <class Scalar, std::size_t size>
void evaluate_taylor(std::type_identity_t<std::span<const std::array<Scalar, size>>> c, const Scalar& h,
                     std::array<Scalar, size>& increment, std::array<Scalar, size>& slope) noexcept {
  const std::size_t order = c.size() - 1;
  std::array<Scalar, size> rest = c[order];
  slope.fill(Scalar(0));
  for (std::size_t k = order - 1; k > 0; --k) {
    for (std::size_t i = 0; i < size; ++i) {
      slope[i] = slope[i] * h + rest[i];
      rest[i] = rest[i] * h + c[k][i];
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    slope[i] = slope[i] * h + rest[i];
    increment[i] = rest[i] * h;
  }
}

}  // namespace torsor::runtime
