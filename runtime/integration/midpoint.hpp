// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/integration/fixed_step.hpp"
#include "torsor/runtime/integration/integrate.hpp"

namespace torsor::runtime {

/// The explicit midpoint method, order 2, two evaluations a step:
///   m1 = f(t, y),  m2 = f(t + h/2, y + h/2 m1),  y(t + h) = y + h m2.
/// Source: Pommier, Dynamique des systèmes de solides, 7.3.1 (méthode du point milieu); Hairer-Nørsett-Wanner I, II.1.
struct Midpoint {
  double step = 0.0;         ///< in units of time, positive in both directions of time
  bool compensated = false;  ///< carry what rounding loses of each sum of state and step
  std::int64_t step_limit = usual_fixed_step_limit;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    using Sum = SummedFormula<Formula, Scalar, size>;
    return FixedStepRun<Sum, S, Scalar, size>(system, y, t, step, Sum(compensated), step_limit);
  }

  struct Formula {
    template <class F, class Scalar, std::size_t size>
    [[nodiscard]] static bool increment(F& f, Scalar t, Scalar h, const std::array<Scalar, size>& y,
                                        std::array<Scalar, size>& change) {
      const Scalar half = h / Scalar(2);
      std::array<Scalar, size> m, x;
      if (!f(t, y, m)) return false;
      for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + half * m[i];
      if (!f(t + half, x, m)) return false;
      for (std::size_t i = 0; i < size; ++i) change[i] = h * m[i];
      return true;
    }
  };
};

}  // namespace torsor::runtime
