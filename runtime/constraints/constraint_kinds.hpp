// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "torsor/runtime/mechanism_model.hpp"

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

/// A place beside y, moved a little in all freedoms and nowhere special: f of a holonomic constraint is not 0 both here
/// and there.
template <MechanismModel M>
[[nodiscard]] StateVector<M> place_beside(const typename M::Precomputed& precomputed, ScalarOf<M> t, StateVector<M> y,
                                          AnyNumbers& any) noexcept {
  using Scalar = ScalarOf<M>;
  Scalar largest = Scalar(0);
  for (std::size_t i = 0; i < coordinates_of<M>; ++i) largest = std::max(largest, std::abs(y[i]));
  const Scalar least = std::sqrt(std::numeric_limits<Scalar>::epsilon()) * largest;
  displace<M>(
      precomputed, t, [&](int) { return (Scalar(1e-3) + least) * any.template next<Scalar>(); }, y);
  return y;
}

}  // namespace detail

/// What kinds of constraints and of velocities a mechanism has, found by evaluating its kernel `constraints` beside a
/// state, moved a little in all freedoms, and there a turn away along each velocity; and the sizes that make ranks
/// independent of the units of constraints and of coordinates, found at places all around.
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
  /// The displacement along each velocity that counts as much as a turn by 1 rad: 1 of what turns; of a length the one
  /// that moves the constraints as far as such turns do; where nothing turns, the largest of such coordinates.
  std::array<Scalar, nv> reach{};
  /// The same by coordinates; 1 of the components of an attitude.
  std::array<Scalar, nq> coordinate_reach{};
  /// The largest |A_ij| seen: a row of A is small beside these near a place where it vanishes, in whatever unit.
  std::array<Scalar, m * nv> usual{};

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
    const StateVector<M> beside = detail::place_beside<M>(precomputed, t, y, any);
    M::constraints(precomputed, unpack<M>(t, beside), here);
    for (std::size_t i = 0; i < m; ++i) {
      kinds.holonomic[i] = here.value[i] != Scalar(0) || there.value[i] != Scalar(0);
    }
    // Of f_i: of its terms, each with a coordinate, and with an angle wound up that is known no better. Terms that are
    // small here are large a quarter of a turn away.
    StateVector<M> aside = beside;
    detail::displace<M>(
        precomputed, t, [&](int) { return whole_turn / Scalar(4); }, aside);
    M::constraints(precomputed, unpack<M>(t, aside), there);
    std::array<Scalar, m> rounding{};
    for (std::size_t j = 0; j < nv; ++j) {
      kinds.coordinate[j] = moved_by(precomputed, t, beside, j);
      const Scalar far = kinds.coordinate[j] == nq ? Scalar(1) : std::abs(beside[kinds.coordinate[j]]);
      for (std::size_t i = 0; i < m; ++i) {
        const Scalar aside_too = std::abs(there.jacobian[j * m + i]), entry = std::abs(here.jacobian[j * m + i]);
        const Scalar term = std::isfinite(aside_too) ? std::max(entry, aside_too) : entry;
        rounding[i] += Scalar(256) * epsilon * term * (Scalar(1) + far);
      }
    }
    for (std::size_t j = 0; j < nv; ++j) {
      kinds.turns[j] = true;
      if (kinds.coordinate[j] == nq) continue;
      StateVector<M> turned = beside;
      Scalar& angle = turned[kinds.coordinate[j]];
      angle += angle > Scalar(0) ? -whole_turn : whole_turn;
      M::constraints(precomputed, unpack<M>(t, turned), there);
      for (std::size_t i = 0; i < m; ++i) {
        const Scalar change = std::abs(there.value[i] - here.value[i]);
        const Scalar of_slope = std::abs(there.jacobian[j * m + i] - here.jacobian[j * m + i]);
        kinds.turns[j] = kinds.turns[j] && (!kinds.holonomic[i] || (change <= rounding[i] && of_slope <= rounding[i]));
      }
    }
    kinds.measure(precomputed, t, y, any);
    return kinds;
  }

 private:
  static constexpr int places = 6;

  void measure(const typename M::Precomputed& precomputed, Scalar t, const StateVector<M>& y,
               detail::AnyNumbers& any) noexcept {
    const auto look_at = [&](const StateVector<M>& place) {
      typename M::Constraints there{};
      M::constraints(precomputed, unpack<M>(t, place), there);
      for (std::size_t k = 0; k < m * nv; ++k) {
        const Scalar entry = std::abs(there.jacobian[k]);
        if (std::isfinite(entry)) usual[k] = std::max(usual[k], entry);
      }
    };
    const auto look_around = [&](bool lengths_too) {
      for (int place = 0; place < places; ++place) {
        StateVector<M> moved = y;
        // Up to half a turn, and to half the reach of a length, to either side.
        const auto displacement = [&](int i) {
          const auto j = static_cast<std::size_t>(i);
          const Scalar part = any.template next<Scalar>() - Scalar(1);
          return turns[j] ? part * whole_turn : lengths_too ? part * reach[j] : Scalar(0);
        };
        detail::displace<M>(precomputed, t, displacement, moved);
        look_at(moved);
      }
    };
    look_at(y);
    look_around(false);
    find_reach(y);
    look_around(true);
    coordinate_reach.fill(Scalar(1));
    for (std::size_t j = 0; j < nv; ++j) {
      if (coordinate[j] != nq) coordinate_reach[coordinate[j]] = reach[j];
    }
  }

  // Lengths are compared with what turns, through the constraints that tie both, then with lengths that are known so.
  // The median of the constraints decides: an entry that is rounding says nothing.
  void find_reach(const StateVector<M>& y) noexcept {
    std::array<bool, nv> known = turns;
    for (std::size_t j = 0; j < nv; ++j) reach[j] = Scalar(turns[j] ? 1 : 0);
    for (bool more = true; more;) {
      more = false;
      const auto before = known;
      for (std::size_t j = 0; j < nv; ++j) {
        if (known[j]) continue;
        std::array<Scalar, m> ratios{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < m; ++i) {
          Scalar by_others = Scalar(0);
          for (std::size_t k = 0; k < nv; ++k) by_others += before[k] ? usual[k * m + i] * reach[k] : Scalar(0);
          const Scalar ratio = by_others / usual[j * m + i];
          if (!(ratio > Scalar(0)) || !std::isfinite(ratio)) continue;
          std::size_t place = count++;  // in order of size
          for (; place > 0 && ratios[place - 1] > ratio; --place) ratios[place] = ratios[place - 1];
          ratios[place] = ratio;
        }
        if (count == 0) continue;
        reach[j] = ratios[(count - 1) / 2];
        known[j] = more = true;
      }
    }
    Scalar largest = Scalar(0);
    for (std::size_t j = 0; j < nv; ++j) {
      if (!known[j]) largest = std::max(largest, std::abs(y[coordinate[j]]));
    }
    for (std::size_t j = 0; j < nv; ++j) {
      if (!known[j]) reach[j] = largest > Scalar(0) ? largest : Scalar(1);
    }
  }

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
