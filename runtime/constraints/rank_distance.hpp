// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/runtime/constraints/constraint_kinds.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// How far a configuration is from those at which the constraints of a mechanism lose rank: the last pivot of A Aᵀ,
/// rows weighed and exchanged, as a root, over the largest that it has been seen to be. 1 and more where all is
/// regular, in proportion to the displacement near such a place. Of constraints that repeat others, as many are counted
/// as are independent elsewhere. Velocities count over their reaches (see ConstraintKinds), and rows are weighed by the
/// largest length they were seen to have, so that one that vanishes as a whole is noticed too: no unit matters. Seen are
/// the initial configuration and some around it; the largest counts, since a start may be a change point itself.
template <HasConstraintMetric M>
class RankDistance {
 public:
  using Scalar = ScalarOf<M>;

  explicit RankDistance(const typename M::Precomputed& precomputed)
      : RankDistance(precomputed, ConstraintKinds<M>::at(precomputed, initial_state_of<M>(precomputed).time,
                                                         pack<M>(initial_state_of<M>(precomputed)))) {}
  RankDistance(const typename M::Precomputed& precomputed, const ConstraintKinds<M>& kinds) : kinds_(kinds) {
    Samples seen;
    look_around(precomputed, walks, seen);
    learn(seen);
    if (!repeats_) return;
    // Constraints may only seem to repeat others, where the start is a change point of many loops.
    look_around(precomputed, 3 * walks, seen);
    learn(seen);
  }

  [[nodiscard]] Scalar operator()(const typename M::Constraints& constraints) const noexcept {
    if (independent_ == 0) return Scalar(1);
    return last_pivot(constraints.jacobian) / usual_;
  }

  /// Whether some constraints repeat others everywhere, beside those that the generator left out.
  [[nodiscard]] bool repeats() const noexcept { return repeats_; }

 private:
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  static constexpr int walks = 4, steps = 4;
  static constexpr Scalar rounding = Scalar(1e-6);  // of a root of a pivot; a singular sample has less
  // The shortest displacement that is tried, in reaches. Back at the start, corrections leave the root of a rounding of
  // it, 1.5e-8, or the fourth root, 1.2e-4, where constraints vanish to third order: a tenth of the displacement is away.
  static constexpr Scalar least_reach = Scalar(1e-3), away = least_reach / Scalar(10);
  using Jacobian = std::array<Scalar, m * nv>;

  struct Samples {
    std::vector<Jacobian> closed, open;  // the first of the closed is the start
    int walked = 0;
    bool left = false;  // whether a closed one is away from the start
  };

  void learn(const Samples& seen) {
    over_.fill(Scalar(0));
    for (const auto* kind : {&seen.closed, &seen.open}) {
      for (const Jacobian& A : *kind) {
        for (std::size_t i = 0; i < m; ++i) {
          Scalar square = Scalar(0);
          for (std::size_t j = 0; j < nv; ++j) {
            const Scalar entry = A[j * m + i] * kinds_.reach[j];
            square += entry * entry;
          }
          over_[i] = std::max(over_[i], std::sqrt(square));
        }
      }
    }
    for (Scalar& length : over_) length = length > Scalar(0) ? Scalar(1) / length : Scalar(1);
    std::size_t kept = m;
    if constexpr (HasRedundantConstraints<M>) {
      for (const int j : M::redundant_multipliers) over_[static_cast<std::size_t>(j)] = Scalar(0);
      kept -= static_cast<std::size_t>(M::redundant_count);
    }
    independent_ = 0;
    usual_ = Scalar(0);
    const auto count_independent = [&](const std::vector<Jacobian>& all) {
      for (const Jacobian& A : all) {
        std::array<Scalar, m> pivots{};
        find_pivots(A, kept, pivots);
        std::size_t rank = 0;
        while (rank < kept && pivots[rank] > rounding) ++rank;
        if (rank < independent_ || rank == 0) continue;
        usual_ = rank > independent_ ? pivots[rank - 1] : std::max(usual_, pivots[rank - 1]);
        independent_ = rank;
      }
    };
    count_independent(seen.closed);
    // With velocities left and no way on that was found, the start is a change point of many loops: that constraints
    // repeat others there says nothing of other places.
    const bool stuck = !seen.closed.empty() && !seen.left;
    if (stuck && independent_ < std::min(kept, nv)) count_independent(seen.open);
    repeats_ = independent_ < kept;
    if (independent_ == 0) return;
    // From a start near a change point, all that is closed may be near one. Those of a hundred lengths in a row, all
    // independent, have a last pivot of some tenth of the first.
    Scalar open = Scalar(0);
    for (const Jacobian& A : seen.open) open = std::max(open, last_pivot(A));
    const Scalar start = last_pivot(seen.closed.front());
    if (start < std::max(usual_, open) / Scalar(10)) usual_ = std::max({usual_, open, Scalar(0.1)});
  }

  [[nodiscard]] Scalar last_pivot(const Jacobian& A) const noexcept {
    std::array<Scalar, m> pivots{};
    find_pivots(A, independent_, pivots);
    return pivots[independent_ - 1];
  }

  // Displaced at random in every freedom, before and after the constraints are met again, and walks over the
  // constraints by some tenths a step, less where loops tear apart: one along the initial velocities, the others each
  // in a direction of its own. Numbers from Lehmer's generator.
  void look_around(const typename M::Precomputed& precomputed, int more, Samples& seen) const {
    const auto start = initial_state_of<M>(precomputed);
    const Scalar t = start.time;
    StateVector<M> y = pack<M>(start);
    const auto look = [&](std::vector<Jacobian>& at) {
      typename M::Constraints constraints{};
      M::constraints(precomputed, unpack<M>(t, y), constraints);
      if (all_finite(constraints.jacobian)) at.push_back(constraints.jacobian);
    };
    const auto look_closed = [&] {
      look(seen.closed);
      for (std::size_t i = 0; i < coordinates_of<M>; ++i) {
        const Scalar gone = std::abs(y[i] - start.q[static_cast<int>(i)]) / kinds_.coordinate_reach[i];
        seen.left = seen.left || gone > away;
      }
    };
    // An initial state that is not closed would show constraints that repeat others as independent.
    if (seen.walked == 0 && project_on_constraints<M>(precomputed, t, y).evaluation == Evaluation::ok) look(seen.closed);
    std::uint64_t random = 48271 + static_cast<std::uint64_t>(seen.walked);
    for (const int last = seen.walked + more; seen.walked < last; ++seen.walked) {
      y = pack<M>(start);
      const bool given = std::any_of(y.begin() + coordinates_of<M>, y.end(), [](Scalar v) { return v != Scalar(0); });
      for (std::size_t i = coordinates_of<M>; i < y.size() && !(seen.walked == 0 && given); ++i) {
        random = random * 48271 % 2147483647;
        const Scalar part = Scalar(2) * static_cast<Scalar>(random) / Scalar(2147483647) - Scalar(1);
        y[i] = part * kinds_.reach[i - coordinates_of<M>];
      }
      if (seen.walked == 0 && given) {  // in reaches too, whatever the unit of time
        const Scalar fastest = fastest_of(y);
        for (std::size_t i = coordinates_of<M>; i < y.size(); ++i) y[i] /= fastest;
      }
      const StateVector<M> directed = y;
      for (Scalar reach = Scalar(2); reach > least_reach; reach /= Scalar(4)) {
        const auto displacement = [&](int i) {
          return reach * directed[coordinates_of<M> + static_cast<std::size_t>(i)];
        };
        y = directed;
        detail::displace<M>(precomputed, t, displacement, y);
        if (reach > Scalar(0.1)) look(seen.open);
        if (project_on_constraints<M>(precomputed, t, y).evaluation != Evaluation::ok) continue;
        look_closed();
        break;
      }
      y = directed;
      Scalar reach = Scalar(0.3);
      for (int step = 0; step < steps; ++step) {
        while (reach > least_reach && !move(precomputed, t, reach, y)) reach /= Scalar(4);
        if (!(reach > least_reach)) break;
        look_closed();
      }
    }
  }

  [[nodiscard]] Scalar fastest_of(const StateVector<M>& y) const noexcept {
    Scalar fastest = Scalar(0);
    for (std::size_t j = 0; j < nv; ++j) {
      fastest = std::max(fastest, std::abs(y[coordinates_of<M> + j]) / kinds_.reach[j]);
    }
    return fastest;
  }

  // Along the velocities of y, which are turned with the constraints: of one reach before, they are rounding when they
  // are lost.
  [[nodiscard]] bool move(const typename M::Precomputed& precomputed, Scalar t, Scalar reach,
                          StateVector<M>& y) const noexcept {
    const Scalar fastest = fastest_of(y);
    if (!(fastest > Scalar(1e-9))) return false;
    StateVector<M> there = y;
    const auto displacement = [&](int i) {
      return reach / fastest * y[coordinates_of<M> + static_cast<std::size_t>(i)];
    };
    detail::displace<M>(precomputed, t, displacement, there);
    if (project_on_constraints<M>(precomputed, t, there).evaluation != Evaluation::ok) return false;
    y = there;
    return true;
  }

  // Roots of the pivots of Cholesky's factor of the weighed A Aᵀ, the largest first, and none after one that is not
  // positive.
  void find_pivots(const Jacobian& jacobian, std::size_t count, std::array<Scalar, m>& pivots) const noexcept {
    std::array<Scalar, m * m> G{};
    for (std::size_t j = 0; j < nv; ++j) {
      std::array<Scalar, m> column;
      std::array<std::size_t, m> filled;
      std::size_t length = 0;
      for (std::size_t i = 0; i < m; ++i) {
        column[i] = jacobian[j * m + i] * kinds_.reach[j] * over_[i];
        if (column[i] != Scalar(0)) filled[length++] = i;
      }
      for (std::size_t a = 0; a < length; ++a) {
        for (std::size_t b = 0; b <= a; ++b) G[filled[b] * m + filled[a]] += column[filled[a]] * column[filled[b]];
      }
    }
    std::array<std::size_t, m> order;
    for (std::size_t i = 0; i < m; ++i) order[i] = i;
    const auto entry = [&](std::size_t a, std::size_t b) -> Scalar& {  // of the symmetric rest
      const std::size_t i = order[a], j = order[b];
      return i >= j ? G[j * m + i] : G[i * m + j];
    };
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t best = k;
      for (std::size_t i = k + 1; i < m; ++i) best = entry(i, i) > entry(best, best) ? i : best;
      std::swap(order[k], order[best]);
      const Scalar pivot = entry(k, k);
      pivots[k] = pivot > Scalar(0) ? std::sqrt(pivot) : pivot - pivot;  // 0, or not a number
      if (!(pivot > Scalar(0)) || k + 1 == count) return;
      for (std::size_t a = k + 1; a < m; ++a) {
        const Scalar factor = entry(a, k) / pivot;
        if (factor == Scalar(0)) continue;
        for (std::size_t b = k + 1; b <= a; ++b) entry(a, b) -= factor * entry(b, k);
      }
    }
  }

  ConstraintKinds<M> kinds_;
  std::array<Scalar, m> over_{};
  Scalar usual_ = Scalar(1);
  std::size_t independent_ = m;
  bool repeats_ = false;
};

}  // namespace torsor::runtime
