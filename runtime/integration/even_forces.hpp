// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/mechanism.hpp"

namespace torsor::runtime {

/// Whether some action of a motion with a Lagrangian is even in the velocities, as a drag -c v² without the sign of v
/// is: what is even in v in the bias, beyond what is there at rest, is then not Ṁ v - ∂T₂/∂q alone.
///
/// Both are compared at one state, ∂M/∂q_k by central differences. Each length of difference has a bound of its own
/// error: its distance from that of half the length, and roundings of M, of the coordinates too: of angles that have turned
/// often M reads differences. The least bound decides, of lengths that agree with all shorter ones; where a value is no
/// number nothing is learnt.
template <MechanismModel M>
requires HasMassMatrixAndBias<M>
[[nodiscard]] bool has_forces_even_in_velocities(const typename M::Precomputed& precomputed,
                                                 const typename M::State& state) noexcept {
  using Scalar = ScalarOf<M>;
  constexpr std::size_t n = velocities_of<M>;
  using Vector = std::array<Scalar, n>;
  using Matrix = std::array<Scalar, n * n>;
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon(), half = Scalar(1) / Scalar(2);
  const auto at = [](std::size_t i) { return static_cast<int>(i); };

  typename M::State back = state, rest = state;
  Vector v;
  for (std::size_t i = 0; i < n; ++i) {
    v[i] = state.v[at(i)];
    back.v[at(i)] = -v[i];
    rest.v[at(i)] = Scalar(0);
  }
  typename M::GeneralizedForces forward{}, backward{}, still{};
  M::bias(precomputed, state, forward);
  M::bias(precomputed, back, backward);
  M::bias(precomputed, rest, still);

  Matrix mass{};
  M::mass_matrix(precomputed, state, mass);
  // |M_ij v_i v_j| <= r_i r_j: the size of what is added, in units of energy.
  Scalar size = Scalar(0), of_forces = Scalar(0);
  Vector weight;
  for (std::size_t i = 0; i < n; ++i) {
    weight[i] = std::sqrt(mass[i * n + i]);
    size += weight[i] * std::abs(v[i]);
    const Scalar force = std::abs(forward[at(i)]) + std::abs(backward[at(i)]) + std::abs(still[at(i)]);
    of_forces = std::max(of_forces, force / weight[i]);
  }

  // M at q_k - reach and at q_k + reach; how far they are apart.
  const auto read_beside = [&](std::size_t k, Scalar length, Matrix& less, Matrix& more) {
    typename M::State below = rest, above = rest;
    // The angles that a rotor has turned by are no scale of M; but they must change.
    const Scalar reach = std::max(length, Scalar(64) * epsilon * std::abs(state.q[at(k)]));
    below.q[at(k)] -= reach;
    above.q[at(k)] += reach;
    M::mass_matrix(precomputed, below, less);
    M::mass_matrix(precomputed, above, more);
    return above.q[at(k)] - below.q[at(k)];
  };

  // The rounding of M as a part of √(M_ii M_jj): its own, and what roundings of coordinates change.
  Scalar part = epsilon;
  for (std::size_t k = 0; k < n; ++k) {
    Matrix less{}, more{};
    const Scalar apart = read_beside(k, std::sqrt(std::sqrt(epsilon)), less, more);
    Scalar slope = Scalar(0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const Scalar change = std::abs(more[j * n + i] - less[j * n + i]);
        if (change > Scalar(0)) slope = std::max(slope, change / apart / (weight[i] * weight[j]));
      }
    }
    part += epsilon * slope * std::abs(state.q[at(k)]);
  }

  // Ṁ v - ∂T₂/∂q, by differences of that length, and its roundings.
  const auto christoffel = [&](Scalar length, Vector& c, Vector& rounding) {
    c.fill(Scalar(0));
    rounding.fill(Scalar(0));
    for (std::size_t k = 0; k < n; ++k) {
      Matrix less{}, more{};
      const Scalar apart = read_beside(k, length, less, more);
      for (std::size_t i = 0; i < n; ++i) {
        Scalar row = Scalar(0);
        for (std::size_t j = 0; j < n; ++j) row += (more[j * n + i] - less[j * n + i]) / apart * v[j];
        c[i] += v[k] * row;
        c[k] -= half * v[i] * row;
        rounding[i] += part * weight[i] * size * std::abs(v[k]) / apart;
      }
      rounding[k] += part * size * size / apart;
    }
  };

  // From the shortest length on, which rounding rules: a longer one tells more where it agrees with those before it, and
  // where it does not it is longer than what M varies over.
  Vector known{}, bound_of_known;
  bound_of_known.fill(std::numeric_limits<Scalar>::infinity());
  for (int j = 4; j >= 0; --j) {
    const Scalar length = std::pow(epsilon, static_cast<Scalar>(8 + 6 * j) / Scalar(52));  // of double 2^-32 to 2^-8
    Vector c, c_of_half, rounding, rounding_of_half;
    christoffel(length, c, rounding);
    christoffel(half * length, c_of_half, rounding_of_half);
    for (std::size_t k = 0; k < n; ++k) {
      const Scalar bound = Scalar(4) * std::abs(c[k] - c_of_half[k]) + Scalar(32) * rounding_of_half[k];
      if (!(bound < bound_of_known[k]) || std::abs(c_of_half[k] - known[k]) > bound + bound_of_known[k]) continue;
      known[k] = c_of_half[k];
      bound_of_known[k] = bound;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Scalar even = half * (forward[at(k)] + backward[at(k)]) - still[at(k)];
    // A bias may lose some digits where terms cancel, those of other coordinates too: √M_kk has their units alike.
    const Scalar of_bias = Scalar(1000) * part * weight[k] * of_forces;
    if (std::abs(even - known[k]) > bound_of_known[k] + of_bias) return true;
  }
  return false;
}

}  // namespace torsor::runtime
