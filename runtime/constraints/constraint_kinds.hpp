// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/mechanism_model.hpp"

namespace torsor::runtime {

namespace detail {

/// q := q + displacement, a velocity for one unit of time; quaternions keep their norm.
template <MechanismModel M, class Displacement>
void displace(const typename M::Precomputed& precomputed, ScalarOf<M> t, const Displacement& displacement,
              StateVector<M>& y) noexcept {
  typename M::State state = unpack<M>(t, y);
  for (int i = 0; i < M::velocity_count; ++i) state.v[i] = displacement(i);
  StateVector<M> change{};
  write_coordinate_rates<M>(precomputed, state, change);
  for (std::size_t i = 0; i < coordinates_of<M>; ++i) y[i] += change[i];
  if constexpr (HasQuaternions<M>) normalise_quaternions<M>(y);
}

/// Pseudo-random numbers from 1/2 to 3/2, the same ones every time: a mechanism moved by them is nowhere special.
/// Source: Knuth, The Art of Computer Programming 2, 3.3.4 (the multiplier).
class AnyNumbers {
 public:
  template <class Scalar>
  [[nodiscard]] Scalar next() noexcept {
    bits_ = bits_ * 6364136223846793005u + 1442695040888963407u;
    return Scalar(0.5) + static_cast<Scalar>(bits_ >> 40) / static_cast<Scalar>(std::uint64_t{1} << 24);
  }

 private:
  std::uint64_t bits_ = 7;
};

}  // namespace detail

/// What kinds of constraints and of velocities a mechanism has, found by evaluating its kernel `constraints` beside a
/// state, moved a little in all freedoms, and there a turn away along each velocity.
template <HasConstraints M>
requires(M::multiplier_count > 0) struct ConstraintKinds {
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>;
  static constexpr std::size_t m = static_cast<std::size_t>(M::multiplier_count);
  static constexpr Scalar whole_turn = static_cast<Scalar>(6.28318530717958647692528676655900577L);

  /// Whether a constraint is f(q, t) = 0: those on velocities alone have no value.
  std::array<bool, m> holonomic{};
  /// The coordinate whose rate a velocity is; nq where it is none, of an attitude.
  std::array<std::size_t, nv> coordinate{};
  /// Whether a whole turn along a velocity leaves all f as they are: angles, and attitudes. Of a length, and of an
  /// angle that a length or another angle grows with (a rack, a pair of gears), it does not.
  std::array<bool, nv> turns{};

  [[nodiscard]] bool all_holonomic() const noexcept {
    return std::all_of(holonomic.begin(), holonomic.end(), [](bool each) { return each; });
  }

  [[nodiscard]] static ConstraintKinds at(const typename M::Precomputed& precomputed, Scalar t,
                                          const StateVector<M>& y) noexcept {
    constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
    detail::AnyNumbers any;
    ConstraintKinds kinds;
    typename M::Constraints here{}, there{};
    M::constraints(precomputed, unpack<M>(t, y), there);
    Scalar largest = Scalar(0);
    for (std::size_t i = 0; i < nq; ++i) largest = std::max(largest, std::abs(y[i]));
    StateVector<M> beside = y;
    const Scalar least = std::sqrt(epsilon) * largest;
    detail::displace<M>(
        precomputed, t, [&](int) { return (Scalar(1e-3) + least) * any.template next<Scalar>(); }, beside);
    M::constraints(precomputed, unpack<M>(t, beside), here);
    for (std::size_t i = 0; i < m; ++i) {
      kinds.holonomic[i] = here.value[i] != Scalar(0) || there.value[i] != Scalar(0);
    }
    for (std::size_t j = 0; j < nv; ++j) {
      kinds.coordinate[j] = moved_by(precomputed, t, beside, j);
      kinds.turns[j] = true;
      if (kinds.coordinate[j] == nq) continue;
      StateVector<M> turned = beside;
      Scalar& angle = turned[kinds.coordinate[j]];
      angle += angle > Scalar(0) ? -whole_turn : whole_turn;
      M::constraints(precomputed, unpack<M>(t, turned), there);
      for (std::size_t i = 0; i < m; ++i) {
        Scalar terms = Scalar(0);
        for (std::size_t k = 0; k < nv; ++k) terms += std::abs(here.jacobian[k * m + i]);
        const Scalar rounding = Scalar(256) * epsilon * terms * (Scalar(1) + largest);
        const Scalar change = std::abs(there.value[i] - here.value[i]);
        const Scalar of_slope = std::abs(there.jacobian[j * m + i] - here.jacobian[j * m + i]);
        kinds.turns[j] = kinds.turns[j] && (!kinds.holonomic[i] || (change <= rounding && of_slope <= rounding));
      }
    }
    return kinds;
  }

 private:
  // The one coordinate that a velocity is the rate of, or nq.
  static std::size_t moved_by([[maybe_unused]] const typename M::Precomputed& precomputed, [[maybe_unused]] Scalar t,
                              [[maybe_unused]] const StateVector<M>& y, std::size_t j) noexcept {
    if constexpr (HasCoordinateRates<M>) {
      typename M::State state = unpack<M>(t, y);
      for (std::size_t k = 0; k < nv; ++k) state.v[static_cast<int>(k)] = Scalar(k == j ? 1 : 0);
      std::array<Scalar, nq> rates;
      M::coordinate_rates(precomputed, state, rates);
      std::size_t found = nq;
      for (std::size_t i = 0; i < nq; ++i) {
        if (rates[i] == Scalar(0)) continue;
        if (found != nq || rates[i] != Scalar(1)) return nq;
        found = i;
      }
      return found;
    } else {
      return j;
    }
  }
};

}  // namespace torsor::runtime
