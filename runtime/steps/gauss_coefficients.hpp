// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

namespace torsor::runtime {

namespace detail {

/// Legendre's polynomial P_n and its derivative at x, by the recurrence n P_n = (2n - 1) x P_{n-1} - (n - 1) P_{n-2}.
struct LegendreValue {
  long double value, derivative;
};
constexpr LegendreValue legendre(int n, long double x) noexcept {
  long double before = 1.0L, value = x;
  for (int k = 2; k <= n; ++k) {
    const long double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1.0L)};
}

/// The zeros of P_n on (-1, 1) that are not below 0, from the largest, to seven digits: Newton's method does the rest.
inline constexpr long double legendre_zeros[6][3] = {
    {0.0L, 0.0L, 0.0L},
    {0.5773503L, 0.0L, 0.0L},
    {0.7745967L, 0.0L, 0.0L},
    {0.8611363L, 0.3399810L, 0.0L},
    {0.9061798L, 0.5384693L, 0.0L},
    {0.9324695L, 0.6612094L, 0.2386192L},
};

}  // namespace detail

/// The s-stage collocation method at Gauss' nodes on [0, 1], of order 2s:
///   c_i  the nodes, b_j = ∫₀¹ ℓ_j, a_ij = ∫₀^{c_i} ℓ_j with ℓ_j the Lagrange polynomials of the nodes.
/// Made in extended precision when the program is compiled; `b_rest` is what the rounding of b to Scalar lost, and
/// `ahead_ij` = ℓ_j(1 + c_i) extrapolates what is known at the nodes of one step to those of the next.
/// Source: Hairer-Lubich-Wanner, Geometric Numerical Integration, II.1.3 (1.10)-(1.12); weights: Abramowitz-Stegun
/// 25.4.29.
template <class Scalar, std::size_t stages>
struct GaussCoefficients {
  static_assert(stages >= 1 && stages <= 6, "Gauss collocation has one to six stages here (orders 2 to 12)");
  using Row = std::array<Scalar, stages>;
  using Wide = std::array<long double, stages>;

  Row c{}, b{}, b_rest{};
  std::array<Row, stages> a{}, ahead{};

  constexpr GaussCoefficients() noexcept {
    const Wide nodes = wide_nodes();
    const Wide weights = wide_weights(nodes);
    for (std::size_t i = 0; i < stages; ++i) {
      c[i] = static_cast<Scalar>(nodes[i]);
      b[i] = static_cast<Scalar>(weights[i]);
      b_rest[i] = static_cast<Scalar>(weights[i] - static_cast<long double>(b[i]));
      for (std::size_t j = 0; j < stages; ++j) {
        long double integral = 0.0L;
        for (std::size_t k = 0; k < stages; ++k) integral += weights[k] * lagrange(nodes, j, nodes[i] * nodes[k]);
        a[i][j] = static_cast<Scalar>(nodes[i] * integral);
        ahead[i][j] = static_cast<Scalar>(lagrange(nodes, j, 1.0L + nodes[i]));
      }
    }
  }

  static constexpr Wide wide_nodes() noexcept {
    Wide nodes{};
    for (std::size_t i = 0; i < (stages + 1) / 2; ++i) {
      long double x = detail::legendre_zeros[stages - 1][i];
      for (int step = 0; step < 3 && 2 * i + 1 != stages; ++step) {
        const auto p = detail::legendre(static_cast<int>(stages), x);
        x -= p.value / p.derivative;
      }
      nodes[i] = (1.0L - x) / 2.0L;
      nodes[stages - 1 - i] = (1.0L + x) / 2.0L;
    }
    return nodes;
  }

  static constexpr Wide wide_weights(const Wide& nodes) noexcept {
    Wide weights{};
    for (std::size_t i = 0; i < stages; ++i) {
      const long double x = 2.0L * nodes[i] - 1.0L;
      const long double slope = detail::legendre(static_cast<int>(stages), x).derivative;
      weights[i] = 1.0L / ((1.0L - x * x) * slope * slope);
    }
    return weights;
  }

  static constexpr long double lagrange(const Wide& nodes, std::size_t j, long double x) noexcept {
    long double value = 1.0L;
    for (std::size_t k = 0; k < stages; ++k) {
      if (k != j) value *= (x - nodes[k]) / (nodes[j] - nodes[k]);
    }
    return value;
  }
};

template <class Scalar, std::size_t stages>
inline constexpr GaussCoefficients<Scalar, stages> gauss_coefficients{};

}  // namespace torsor::runtime
