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
/// error: its distance from that of half the length, and roundings of M. It is false where differences of some length
/// agree within their bound, the best bound or that of the shortest; where a value is no number nothing is learnt.
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

  // Ṁ v - ∂T₂/∂q, `length` being that of differences beside the size of each coordinate, and its roundings.
  const auto christoffel = [&](Scalar length, Vector& c, Vector& rounding) {
    c.fill(Scalar(0));
    rounding.fill(Scalar(0));
    for (std::size_t k = 0; k < n; ++k) {
      typename M::State before = rest, behind = rest;
      const Scalar reach = length * std::max(Scalar(1), std::abs(state.q[at(k)]));
      before.q[at(k)] -= reach;
      behind.q[at(k)] += reach;
      const Scalar apart = behind.q[at(k)] - before.q[at(k)];
      Matrix less{}, more{};
      M::mass_matrix(precomputed, before, less);
      M::mass_matrix(precomputed, behind, more);
      for (std::size_t i = 0; i < n; ++i) {
        Scalar row = Scalar(0);
        for (std::size_t j = 0; j < n; ++j) row += (more[j * n + i] - less[j * n + i]) / apart * v[j];
        c[i] += v[k] * row;
        c[k] -= half * v[i] * row;
        rounding[i] += epsilon * weight[i] * size * std::abs(v[k]) / apart;
      }
      rounding[k] += epsilon * size * size / apart;
    }
  };

  Vector bound_of_best, excess_of_best{}, excess{};
  bound_of_best.fill(std::numeric_limits<Scalar>::infinity());
  for (int j = 0; j < 3; ++j) {
    const Scalar length = std::pow(epsilon, static_cast<Scalar>(8 + 6 * j) / Scalar(52));  // of double 2^-8, 2^-14, 2^-20
    Vector c, c_of_half, rounding, rounding_of_half;
    christoffel(length, c, rounding);
    christoffel(half * length, c_of_half, rounding_of_half);
    for (std::size_t k = 0; k < n; ++k) {
      const Scalar even = half * (forward[at(k)] + backward[at(k)]) - still[at(k)];
      // A bias may lose some digits where terms cancel, those of other coordinates too: √M_kk has their units alike.
      const Scalar of_bias = Scalar(1000) * epsilon * weight[k] * of_forces;
      const Scalar bound = Scalar(4) * std::abs(c[k] - c_of_half[k]) + Scalar(32) * rounding_of_half[k] + of_bias;
      excess[k] = std::abs(even - c_of_half[k]) - bound;
      if (bound < bound_of_best[k]) {
        bound_of_best[k] = bound;
        excess_of_best[k] = excess[k];
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (excess_of_best[k] > Scalar(0) && excess[k] > Scalar(0)) return true;
  }
  return false;
}

}  // namespace torsor::runtime
