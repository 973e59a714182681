// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "torsor/runtime/constraints/change_point_bounds.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/constraints/rank_distance.hpp"
#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// The motion of a mechanism with constraints at, and through, the places where these lose rank: change points, where
/// branches of a closed loop meet, and configurations at which conditions of rolling repeat each other. A motion is
/// smooth through such a place although the equations there do not determine it. By the distance d from it (see
/// RankDistance), three cases:
///   d >= 0.3        the equations as they are;
///   0.015 to 0.3    at the state projected on the constraints. The error of a stage, e off the constraints, else comes
///                   out as e/d² in the accelerations, and no step is short enough. So everywhere with constraints that
///                   repeat others, which off the constraints look independent by e;
///   below 0.015     by interpolation along the motion: g(σ) = value at the projection of (q + σ q', v), which is
///                   smooth, is taken at σ = ±1, ±2, ±3, ±4 units at which d is some 0.04 to 0.16. The interpolation
///                   errs by (4!)² σ⁸/8! g⁽⁸⁾, rounding by ε/d² of there.
/// `singular` where no direction is left to interpolate along (the mechanism at rest at the place itself), where the
/// projections fail, and where the values do not lie on one smooth curve: branches can't be told apart.
template <HasConstraintMetric M>
class ChangePoints {
 public:
  using Scalar = ScalarOf<M>;
  using Vector = StateVector<M>;

  explicit ChangePoints(const typename M::Precomputed& precomputed)
      : kinds_(ConstraintKinds<M>::at(precomputed, start(precomputed).time, pack<M>(start(precomputed)))),
        distance_(precomputed, kinds_) {}

  /// Whether accelerations of this state itself, as it is given, are those of a motion: nearer than some 1e-4, rounding
  /// of positions takes half of their digits.
  [[nodiscard]] bool regular(const typename M::Constraints& constraints) const noexcept {
    return distance_(constraints) >= blind;
  }

  [[nodiscard]] const ConstraintKinds<M>& kinds() const noexcept { return kinds_; }

  /// A state of a mechanism with these parameters.
  struct Place {
    const typename M::Precomputed& precomputed;
    Scalar t;
    const Vector& y;
  };

  /// A function of the motion, `function(t, y, value)` for states on the constraints, at a state near them.
  template <class Function>
  [[nodiscard]] Evaluation evaluate(const Place& place, const Function& function, Vector& value) const noexcept {
    const auto& [precomputed, t, y] = place;
    typename M::Constraints constraints{};
    M::constraints(precomputed, unpack<M>(t, y), constraints);
    const Scalar distance = distance_(constraints);
    if (!std::isfinite(distance)) return Evaluation::not_finite;
    if (distance >= plain && !distance_.repeats()) return function(t, y, value);
    if (distance < near) {
      const Evaluation evaluation = across(place, function, value);
      // So slow that no direction is left, the error of ε v²/d² is small too.
      if (evaluation == Evaluation::ok || distance < blind) return evaluation;
    }
    Vector there = y;
    const Evaluation evaluation = closed(precomputed, t, there);
    return evaluation == Evaluation::ok ? function(t, there, value) : evaluation;
  }

  /// Puts a state on its constraints.
  [[nodiscard]] Evaluation settle(const typename M::Precomputed& precomputed, Scalar t, Vector& y) const noexcept {
    typename M::Constraints constraints{};
    M::constraints(precomputed, unpack<M>(t, y), constraints);
    const Scalar distance = distance_(constraints);
    if (!std::isfinite(distance)) return Evaluation::not_finite;
    if (distance >= near) return closed(precomputed, t, y);
    Vector there;
    const auto itself = [](Scalar, const Vector& state, Vector& value) noexcept {
      value = state;
      return Evaluation::ok;
    };
    if (const Evaluation e = across({precomputed, t, y}, itself, there); e != Evaluation::ok) {
      return distance < blind ? e : closed(precomputed, t, y);
    }
    if constexpr (HasQuaternions<M>) normalise_quaternions<M>(there);
    y = there;
    return Evaluation::ok;
  }

 private:
  static constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>, size = nq + nv;
  static constexpr Scalar plain = Scalar(change_point_bounds::plain), near = Scalar(change_point_bounds::near);
  static constexpr Scalar blind = Scalar(change_point_bounds::blind), beside = Scalar(0.04);
  static constexpr int nodes = 4;  // on either side
  // Of Lagrange's polynomials through ±1..±4, and ±1..±3, at 0.
  static constexpr std::array<Scalar, nodes> weights{Scalar(56) / Scalar(70), Scalar(-28) / Scalar(70),
                                                     Scalar(8) / Scalar(70), Scalar(-1) / Scalar(70)};
  static constexpr std::array<Scalar, nodes> fewer{Scalar(15) / Scalar(20), Scalar(-6) / Scalar(20),
                                                   Scalar(1) / Scalar(20), Scalar(0)};

  [[nodiscard]] static typename M::State start(const typename M::Precomputed& precomputed) noexcept {
    return initial_state_of<M>(precomputed);
  }

  [[nodiscard]] Evaluation closed(const typename M::Precomputed& precomputed, Scalar t, Vector& y) const noexcept {
    detail::ProjectionOnConstraints<M> projection(precomputed, kinds_, t, usual_rank_tolerance<Scalar>());
    return projection(y, false).evaluation;
  }

  struct Line {
    Place start;
    Vector rates{};
    Scalar fastest = Scalar(0);  // of the rates, as all lengths here over the reaches of the coordinates
    bool in_time = false;  // constraints that change with time are looked at when they hold

    [[nodiscard]] Scalar time(Scalar sigma) const noexcept { return in_time ? start.t + sigma : start.t; }
    [[nodiscard]] Vector at(Scalar sigma) const noexcept {
      Vector there = start.y;
      for (std::size_t i = 0; i < nq; ++i) there[i] += sigma * rates[i];
      if constexpr (HasQuaternions<M>) normalise_quaternions<M>(there);
      return there;
    }
  };

  [[nodiscard]] Scalar distance_at(const Line& line, Scalar sigma) const noexcept {
    typename M::Constraints constraints{};
    M::constraints(line.start.precomputed, unpack<M>(line.time(sigma), line.at(sigma)), constraints);
    return distance_(constraints);
  }

  template <class Function>
  [[nodiscard]] Evaluation across(const Place& place, const Function& function, Vector& value) const noexcept {
    const auto& [precomputed, t, y] = place;
    Line line{place};
    write_coordinate_rates<M>(precomputed, unpack<M>(t, y), line.rates);
    for (std::size_t i = 0; i < nq; ++i) {
      line.fastest = std::max(line.fastest, std::abs(line.rates[i]) / kinds_.coordinate_reach[i]);
    }
    if (!std::isfinite(line.fastest)) return Evaluation::not_finite;
    if (!(line.fastest > Scalar(0))) return Evaluation::singular;
    line.in_time = moves_with_time(precomputed, t, y);
    Scalar unit = find_unit(line);
    if (!(unit > Scalar(0))) return Evaluation::singular;
    // Nearer nodes where the function bends much over these: four times the rounding, for a 256th of the error.
    for (int trial = 0; trial < 3; ++trial, unit /= Scalar(2)) {
      if (interpolate(line, unit, function, value) == Evaluation::ok) return Evaluation::ok;
    }
    return Evaluation::singular;
  }

  // `singular` too where the values do not lie on a smooth curve.
  template <class Function>
  [[nodiscard]] Evaluation interpolate(const Line& line, Scalar unit, const Function& function,
                                       Vector& value) const noexcept {
    Vector state{}, coarse_state{}, coarse{}, least_state, most_state, largest{};
    value.fill(Scalar(0));
    for (int k = -nodes; k <= nodes; ++k) {
      if (k == 0) continue;
      const Scalar sigma = static_cast<Scalar>(k) * unit, at = line.time(sigma);
      const Vector guess = line.at(sigma);
      Vector there = guess, of_there;
      if (const Evaluation e = closed(line.start.precomputed, at, there); e != Evaluation::ok) return e;
      // A projection that goes further than the node is away has left the motion.
      for (std::size_t i = 0; i < nq; ++i) {
        const Scalar led_away = std::abs(there[i] - guess[i]) / kinds_.coordinate_reach[i];
        if (!(led_away <= std::abs(sigma) * line.fastest / Scalar(2))) return Evaluation::singular;
      }
      if (const Evaluation e = function(at, there, of_there); e != Evaluation::ok) return e;
      const auto side = static_cast<std::size_t>(std::abs(k) - 1);
      for (std::size_t i = 0; i < size; ++i) {
        value[i] += weights[side] * of_there[i];
        coarse[i] += fewer[side] * of_there[i];
        largest[i] = std::max(largest[i], std::abs(of_there[i]));
        state[i] += weights[side] * there[i];
        coarse_state[i] += fewer[side] * there[i];
        least_state[i] = k == -nodes ? there[i] : std::min(least_state[i], there[i]);
        most_state[i] = k == -nodes ? there[i] : std::max(most_state[i], there[i]);
      }
    }
    // A corner of q(σ), one branch on one side and another on the other, shows as 0.03/8 of its spread.
    Scalar spread = Scalar(0), apart = Scalar(0), away = Scalar(0), of_values = Scalar(0), bent = Scalar(0);
    for (std::size_t i = 0; i < nq; ++i) {
      const Scalar reach = kinds_.coordinate_reach[i];
      spread = std::max(spread, (most_state[i] - least_state[i]) / reach);
      apart = std::max(apart, std::abs(state[i] - coarse_state[i]) / reach);
      away = std::max(away, std::abs(state[i] - line.start.y[i]) / reach);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar reach = i < nq ? kinds_.coordinate_reach[i] : kinds_.reach[i - nq];
      of_values = std::max(of_values, largest[i] / reach);
      bent = std::max(bent, std::abs(value[i] - coarse[i]) / reach);
    }
    if (!(apart <= Scalar(1e-3) * spread) || !(away <= spread / Scalar(8))) return Evaluation::singular;
    // Six nodes of eight differ by g⁽⁶⁾ σ⁶/20; eight err by a thousandth of that or less.
    const Scalar unseen = std::max(Scalar(1e-8), Scalar(4e3) * std::numeric_limits<Scalar>::epsilon());
    if (!(bent <= unseen * of_values)) return Evaluation::singular;
    return all_finite(value) ? Evaluation::ok : Evaluation::not_finite;
  }

  // b(q, t) of A v = b is the rate at which constraints move by themselves.
  [[nodiscard]] static bool moves_with_time(const typename M::Precomputed& precomputed, Scalar t,
                                            const Vector& y) noexcept {
    typename M::State state = unpack<M>(t, y);
    for (int i = 0; i < static_cast<int>(nv); ++i) state.v[i] = Scalar(0);
    typename M::Constraints constraints{};
    M::constraints(precomputed, state, constraints);
    return std::any_of(constraints.rate.begin(), constraints.rate.end(), [](Scalar rate) { return rate != Scalar(0); });
  }

  // The distance grows in proportion from the place itself: two or three trials find the unit. 0: there is none.
  [[nodiscard]] Scalar find_unit(const Line& line) const noexcept {
    Scalar unit = beside / line.fastest;
    for (int trial = 0; trial < 8; ++trial) {
      const Scalar before = distance_at(line, -unit), after = distance_at(line, unit);
      const Scalar less = std::min(before, after), more = std::max(before, after);
      if (!std::isfinite(less) || !std::isfinite(more)) return Scalar(0);
      const Scalar mean = (less + more) / Scalar(2);
      if (mean >= beside * Scalar(0.8) && mean <= beside * Scalar(1.25)) {
        return less >= beside / Scalar(5) ? unit : Scalar(0);
      }
      unit *= std::clamp(beside / std::max(mean, std::numeric_limits<Scalar>::min()), Scalar(0.1), Scalar(10));
    }
    return Scalar(0);
  }

  ConstraintKinds<M> kinds_;
  RankDistance<M> distance_;
};

}  // namespace torsor::runtime
