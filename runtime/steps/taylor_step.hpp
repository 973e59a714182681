// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// A system that also gives the Taylor coefficients of its motions: `system.jets(t, y, c)` writes c[k] = y^(k)(t) / k!
/// for all k of the span, c[0] = y, and returns an enumeration, 0 if it could.
template <class S, class Scalar, std::size_t size>
concept HasTaylorCoefficients = System<S, Scalar, size> &&
    requires(S& system, const Scalar& t, const std::array<Scalar, size>& y, std::span<std::array<Scalar, size>> c) {
  requires std::is_enum_v<std::remove_cvref_t<decltype(system.jets(t, y, c))>>;
};

/// One accepted step of Taylor's method: the polynomial itself, of the method's order at any time inside it.
template <class Scalar, std::size_t size>
class TaylorStep {
 public:
  using Coefficients = std::array<std::array<Scalar, size>, 31>;

  TaylorStep(Scalar from, Scalar to, std::size_t order, const Coefficients& coefficients) noexcept
      : start(from), end(to), order_(order) {
    for (std::size_t k = 0; k <= order; ++k) coefficients_[k] = coefficients[k];
  }

  Scalar start;  ///< time at which the step begins
  Scalar end;    ///< time at which it ends, before `start` when time runs backwards

  /// The state at a time between `start` and `end`, by Horner's rule.
  [[nodiscard]] std::array<Scalar, size> operator()(Scalar time) const noexcept {
    const Scalar h = time - start;
    std::array<Scalar, size> y = coefficients_[order_];
    for (std::size_t k = order_; k-- > 0;) {
      for (std::size_t i = 0; i < size; ++i) y[i] = coefficients_[k][i] + h * y[i];
    }
    return y;
  }

  /// c[k] = y^(k)(start) / k!, k from 0 to the order.
  [[nodiscard]] std::span<const std::array<Scalar, size>> coefficients() const noexcept {
    return {coefficients_.data(), order_ + 1};
  }

 private:
  std::size_t order_;
  Coefficients coefficients_;
};

}  // namespace torsor::runtime
