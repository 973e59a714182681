// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/runtime/mechanisms.hpp"

namespace mechanisms {

/// A row of parallelograms (IFToMM benchmark A02 in absolute angles): cranks 0..N of length 1 hang from pivots one
/// apart, at angles θ from the downward vertical, and N couplers of length 1 at angles ψ from the horizontal join their
/// ends,
///   f_k = P_{k-1} + e(ψ_k) - P_k = 0.
/// Point masses at the ends, couplers with an inertia of their own. On the branch of parallelograms θ_k = θ, ψ_k = 0 it
/// is a pendulum of length 1. Where all lie flat, θ = ±π/2, it may go on in N + 1 ways: N of 2N constraints are lost.
template <int windows>
struct Windows : Contract<2 * windows + 1, 2 * windows> {
  using Base = Contract<2 * windows + 1, 2 * windows>;
  using typename Base::Accelerations;
  using typename Base::Constraints;
  using typename Base::GeneralizedForces;
  using typename Base::Inputs;
  using typename Base::Multipliers;
  using typename Base::State;
  static constexpr int n = 2 * windows + 1, m = 2 * windows, parameter_count = 2;
  static constexpr std::size_t size = static_cast<std::size_t>(n), rows = static_cast<std::size_t>(m);
  struct Parameters {
    static constexpr int size = 2;
    double angle, rate;  ///< of the cranks at the start
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {2.0, 0.0}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state(const Parameters& p) noexcept {
    State state{};
    for (int k = 0; k <= windows; ++k) {
      state.q[k] = p.angle;
      state.v[k] = p.rate;
    }
    return state;
  }
  static State initial_state() noexcept { return initial_state(default_parameters()); }
  static double mass_of(int k) noexcept { return k <= windows ? 1.0 + 0.5 * (k % 3) : 0.3; }

  static void mass_matrix(const Precomputed&, const State&, std::array<double, size * size>& mass) noexcept {
    mass.fill(0.0);
    for (int k = 0; k < n; ++k) mass[static_cast<std::size_t>(k * (n + 1))] = mass_of(k);
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    for (int k = 0; k < n; ++k) h[k] = k <= windows ? mass_of(k) * gravity<double> * std::sin(s.q[k]) : 0.0;
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c = {};
    const auto entry = [&](int row, int column) -> double& {
      return c.jacobian[static_cast<std::size_t>(column * m + row)];
    };
    for (int k = 1; k <= windows; ++k) {
      const int row = 2 * (k - 1), coupler = windows + k;
      const auto x = static_cast<std::size_t>(row), y = x + 1;
      const double sa = std::sin(s.q[k - 1]), ca = std::cos(s.q[k - 1]), sb = std::sin(s.q[k]), cb = std::cos(s.q[k]);
      const double sp = std::sin(s.q[coupler]), cp = std::cos(s.q[coupler]);
      const double a = s.v[k - 1], b = s.v[k], p = s.v[coupler];
      c.value[x] = sa + cp - 1.0 - sb;
      c.value[y] = -ca + sp + cb;
      entry(row, k - 1) = ca, entry(row, coupler) = -sp, entry(row, k) = -cb;
      entry(row + 1, k - 1) = sa, entry(row + 1, coupler) = cp, entry(row + 1, k) = -sb;
      c.rate[x] = ca * a - sp * p - cb * b;
      c.rate[y] = sa * a + cp * p - sb * b;
      c.gamma[x] = -sa * a * a - cp * p * p + sb * b * b;
      c.gamma[y] = ca * a * a - sp * p * p - cb * b * b;
    }
  }
  /// By L D Lᵀ of the Schur complement, as generated headers do.
  static Status forward_dynamics(const Precomputed& p, const State& s, const Inputs&, Accelerations& a,
                                 Multipliers& lambda) noexcept {
    Constraints c;
    GeneralizedForces h;
    constraints(p, s, c);
    bias(p, s, h);
    static thread_local std::array<double, rows * rows> S;
    S.fill(0.0);
    std::array<double, rows> x;
    const auto A = [&](std::size_t i, std::size_t j) { return c.jacobian[j * rows + i]; };
    for (std::size_t i = 0; i < rows; ++i) {
      x[i] = -c.gamma[i];
      for (std::size_t j = 0; j < size; ++j) {
        if (A(i, j) == 0.0) continue;
        x[i] += A(i, j) * h[static_cast<int>(j)] / mass_of(static_cast<int>(j));
        for (std::size_t k = 0; k < rows; ++k) S[i * rows + k] += A(i, j) * A(k, j) / mass_of(static_cast<int>(j));
      }
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < rows; ++i) largest = std::max(largest, S[i * (rows + 1)]);
    for (std::size_t k = 0; k < rows; ++k) {
      if (!(S[k * (rows + 1)] > 2.2e-16 * largest)) return Status::singular;
      for (std::size_t i = k + 1; i < rows; ++i) {
        const double factor = S[i * rows + k] / S[k * (rows + 1)];
        if (factor == 0.0) continue;
        for (std::size_t j = k; j < rows; ++j) S[i * rows + j] -= factor * S[k * rows + j];
        x[i] -= factor * x[k];
      }
    }
    for (std::size_t k = rows; k-- > 0;) {
      for (std::size_t j = k + 1; j < rows; ++j) x[k] -= S[k * rows + j] * x[j];
      x[k] /= S[k * (rows + 1)];
      lambda[static_cast<int>(k)] = x[k];
    }
    for (std::size_t j = 0; j < size; ++j) {
      double sum = -h[static_cast<int>(j)];
      for (std::size_t i = 0; i < rows; ++i) sum += A(i, j) * x[i];
      a[static_cast<int>(j)] = sum / mass_of(static_cast<int>(j));
    }
    return Status::ok;
  }
  /// T - U over that of the whole pendulum's mass
  static double energy(const State& s) noexcept {
    double sum = 0.0, mass = 0.0;
    for (int k = 0; k < n; ++k) {
      sum += 0.5 * mass_of(k) * s.v[k] * s.v[k];
      if (k > windows) continue;
      sum -= mass_of(k) * gravity<double> * std::cos(s.q[k]);
      mass += mass_of(k);
    }
    return sum / mass;
  }
};

}  // namespace mechanisms
