// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/steps/gauss_coefficients.hpp"

namespace torsor::runtime {

/// What the slopes at 0, at Gauss' nodes and at 1 make of the inside of a step: with ℓ_j the Lagrange polynomials of
/// these nodes and w_j the weights of the step, (∫₀^θ ℓ_j - θ w_j)/(θ (1 - θ)) in powers of u = 2θ - 1.
template <class Scalar, std::size_t stages>
struct GaussInside {
  static constexpr std::size_t nodes = stages + 2;
  std::array<std::array<Scalar, stages + 1>, nodes> bend{};

  constexpr GaussInside() noexcept {
    using Coefficients = GaussCoefficients<long double, stages>;
    const auto c = Coefficients::wide_nodes();
    const auto weights = Coefficients::wide_weights(c);
    std::array<long double, nodes> place{};  // in u
    place[0] = -1.0L;
    place[nodes - 1] = 1.0L;
    for (std::size_t i = 0; i < stages; ++i) place[i + 1] = 2.0L * c[i] - 1.0L;
    for (std::size_t j = 0; j < nodes; ++j) {
      std::array<long double, nodes + 1> p{};  // ℓ_j, then its integral, then that divided by θ, and by 1 - θ
      p[0] = 1.0L;
      for (std::size_t k = 0, degree = 0; k < nodes; ++k) {
        if (k == j) continue;
        ++degree;
        for (std::size_t m = degree + 1; m-- > 0;) {
          p[m] = ((m > 0 ? p[m - 1] : 0.0L) - place[k] * p[m]) / (place[j] - place[k]);
        }
      }
      for (std::size_t m = nodes; m > 0; --m) p[m] = p[m - 1] / static_cast<long double>(2 * m);  // dθ = du/2
      p[0] = 0.0L;
      long double at_start = 0.0L;
      for (std::size_t m = 1; m <= nodes; ++m) at_start += m % 2 == 0 ? p[m] : -p[m];
      p[0] = -at_start;
      divide(p, -1.0L);  // by 1 + u = 2 θ
      for (auto& value : p) value *= 2.0L;
      if (j > 0 && j + 1 < nodes) p[0] -= weights[j - 1];
      divide(p, 1.0L);  // by u - 1 = -2 (1 - θ)
      for (std::size_t m = 0; m <= stages; ++m) bend[j][m] = static_cast<Scalar>(-2.0L * p[m]);
    }
  }

 private:
  // By u - root, without the remainder.
  static constexpr void divide(std::array<long double, nodes + 1>& p, long double root) noexcept {
    long double carried = 0.0L;
    for (std::size_t m = nodes + 1; m-- > 0;) {
      const long double next = p[m] + root * carried;
      p[m] = carried;
      carried = next;
    }
  }
};

template <class Scalar, std::size_t stages>
inline constexpr GaussInside<Scalar, stages> gauss_inside{};

/// One step of Gauss collocation, to be evaluated inside: the polynomial through the states of both ends whose slopes
/// are those at the stages and at both ends, local error h^(stages + 2) (h^4 with one stage: the cubic of both ends);
/// continuously differentiable from step to step. With the slopes at the stages alone it would be the collocation
/// polynomial, of one order less.
///   y(t + θ h) = c0 + θ (c1 + (1 - θ) (d0 + d1 u + d2 u² + ...)),   u = 2θ - 1.
/// Source: Hairer-Nørsett-Wanner I, II.6 (interpolation with more slopes) and II.7 (7.10).
template <class Scalar, std::size_t size, std::size_t stages>
struct GaussStep {
  using Vector = std::array<Scalar, size>;
  Scalar start;  ///< time at which the step begins
  Scalar end;    ///< time at which it ends, before `start` when time runs backwards
  Vector first, change;
  std::array<Vector, stages + 1> bend;

  /// From the states at both ends, the slopes there, and those at the stages.
  GaussStep(Scalar t, Scalar t_next, const Vector& y, const Vector& next, const Vector& first_slope,
            const std::array<Vector, stages>& slopes, const Vector& last_slope) noexcept
      : start(t), end(t_next), first(y) {
    [[maybe_unused]] const auto& inside = gauss_inside<Scalar, stages>;
    const Scalar h = t_next - t;
    for (std::size_t i = 0; i < size; ++i) {
      change[i] = next[i] - y[i];
      if constexpr (stages == 1) {
        const Scalar a = h * first_slope[i] - change[i], b = change[i] - h * last_slope[i];
        bend[0][i] = (a + b) / Scalar(2);
        bend[1][i] = (b - a) / Scalar(2);
      } else {
        for (std::size_t m = 0; m <= stages; ++m) {
          Scalar sum = inside.bend[0][m] * first_slope[i] + inside.bend[stages + 1][m] * last_slope[i];
          for (std::size_t j = 0; j < stages; ++j) sum += inside.bend[j + 1][m] * slopes[j][i];
          bend[m][i] = h * sum;
        }
      }
    }
  }

  /// The state at a time between `start` and `end`.
  [[nodiscard]] Vector operator()(Scalar time) const noexcept {
    const Scalar theta = (time - start) / (end - start), rest = Scalar(1) - theta, u = theta - rest;
    Vector y = bend[stages];
    for (std::size_t m = stages; m-- > 0;) {
      for (std::size_t i = 0; i < size; ++i) y[i] = y[i] * u + bend[m][i];
    }
    for (std::size_t i = 0; i < size; ++i) y[i] = first[i] + theta * (change[i] + rest * y[i]);
    return y;
  }
};

}  // namespace torsor::runtime
