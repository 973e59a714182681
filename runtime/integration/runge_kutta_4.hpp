// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/integration/fixed_step.hpp"
#include "torsor/runtime/integration/integrate.hpp"

namespace torsor::runtime {

/// The classical Runge-Kutta method, order 4, four evaluations a step:
///   m1 = f(t, y),  m2 = f(t + h/2, y + h/2 m1),  m3 = f(t + h/2, y + h/2 m2),  m4 = f(t + h, y + h m3),
///   y(t + h) = y + h/6 (m1 + 2 m2 + 2 m3 + m4).
/// Source: Pommier, Dynamique des systèmes de solides, 7.3.1 (méthode de Runge-Kutta); Hairer-Nørsett-Wanner I, II.1.
struct RungeKutta4 {
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
      std::array<Scalar, size> m1, m2, m3, m4, x;
      if (!f(t, y, m1)) return false;
      for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + half * m1[i];
      if (!f(t + half, x, m2)) return false;
      for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + half * m2[i];
      if (!f(t + half, x, m3)) return false;
      for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + h * m3[i];
      if (!f(t + h, x, m4)) return false;
      for (std::size_t i = 0; i < size; ++i) {
        change[i] = h / Scalar(6) * (m1[i] + Scalar(2) * (m2[i] + m3[i]) + m4[i]);
      }
      return true;
    }
  };
};

}  // namespace torsor::runtime
