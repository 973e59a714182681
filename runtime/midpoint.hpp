// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "runtime/fixed_step.hpp"
#include "runtime/integrate.hpp"

namespace torsor::runtime {

/// The explicit midpoint method, order 2, two evaluations a step:
///   m1 = f(t, y),  m2 = f(t + h/2, y + h/2 m1),  y(t + h) = y + h m2.
/// Source: Pommier, Dynamique des systèmes de solides, 7.3.1 (méthode du point milieu); Hairer-Nørsett-Wanner I, II.1.
struct Midpoint {
  double step = 0.0;  ///< in units of time, positive in both directions of time

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    return FixedStepRun<Formula, S, Scalar, size>(system, y, t, step);
  }

  struct Formula {
    template <class F, class Scalar, std::size_t size>
    [[nodiscard]] static bool step(F& f, Scalar t, Scalar h, const std::array<Scalar, size>& y,
                                   std::array<Scalar, size>& next) {
      const Scalar half = h / Scalar(2);
      std::array<Scalar, size> m;
      if (!f(t, y, m)) return false;
      for (std::size_t i = 0; i < size; ++i) next[i] = y[i] + half * m[i];
      if (!f(t + half, next, m)) return false;
      for (std::size_t i = 0; i < size; ++i) next[i] = y[i] + h * m[i];
      return true;
    }
  };
};

}  // namespace torsor::runtime
