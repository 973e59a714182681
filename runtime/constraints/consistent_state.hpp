// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// What is known of a starting state: values that must stay as they are, and how dear it is to change the others.
/// Positions are counted as displacements along the velocities: they are the coordinates where q' = v, and turns about
/// moving axes where an attitude is a quaternion.
template <MechanismModel M>
struct StateWishes {
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nv = velocities_of<M>;
  std::array<bool, nv> position_fixed{}, velocity_fixed{};
  /// Among the solutions that of least Σ (weight δ)²: one over a typical change of each value.
  std::array<Scalar, nv> position_weight = ones(), velocity_weight = ones();

  static constexpr std::array<Scalar, nv> ones() noexcept {
    std::array<Scalar, nv> result{};
    for (Scalar& one : result) one = Scalar(1);
    return result;
  }
};

enum class ConsistencyStatus : int { consistent = 0, positions_conflict, velocities_conflict, not_finite };

/// What was found, or what conflicts: the constraints that cannot all hold, by how much at best, and the fixed values
/// that stand in their way.
template <MechanismModel M>
struct Consistency {
  using Scalar = ScalarOf<M>;
  ConsistencyStatus status = ConsistencyStatus::consistent;
  std::array<Scalar, static_cast<std::size_t>(M::multiplier_count)> left{};  ///< f, or A v - b, at best
  std::optional<int> constraint{};                                           ///< where that is worst, of a conflict
  std::array<bool, velocities_of<M>> position_involved{}, velocity_involved{};
  int free_positions = 0;   ///< in how many ways the positions could still be chosen
  int free_velocities = 0;  ///< the same of the velocities
  int iterations = 0;

  [[nodiscard]] explicit constexpr operator bool() const noexcept { return status == ConsistencyStatus::consistent; }
};

/// In words: which constraint conflicts with which fixed values, by how much.
template <MechanismModel M>
[[nodiscard]] std::string describe(const Consistency<M>& found) {
  switch (found.status) {
    case ConsistencyStatus::consistent:
      return "a consistent state was found";
    case ConsistencyStatus::not_finite:
      return "the constraints have a value that is not finite: start nearer, from finite values";
    case ConsistencyStatus::positions_conflict:
    case ConsistencyStatus::velocities_conflict:
      break;
  }
  const bool positions = found.status == ConsistencyStatus::positions_conflict;
  const auto& involved = positions ? found.position_involved : found.velocity_involved;
  const int worst = found.constraint.value_or(0);
  std::string text = "constraint " + std::to_string(worst) + " is off by " +
                     std::to_string(found.left[static_cast<std::size_t>(worst)]) + " at best";
  std::string names;
  for (std::size_t i = 0; i < involved.size(); ++i) {
    if (involved[i]) names += (names.empty() ? "" : ", ") + std::to_string(i);
  }
  if (names.empty()) return text + ": no fixed value is to blame, start nearer or change the lengths";
  return text + ": let go of a fixed " + (positions ? "position" : "velocity") + " among " + names;
}

namespace detail {

/// The x of least Σ (x_j/ease_j)² with G x = c as nearly as may be, x_j = 0 where ease_j = 0; damped by `damping` times
/// the largest singular value (Levenberg). By Jacobi's rotations of one side, which give small singular values to high
/// relative accuracy. Source: Golub-Van Loan, Matrix Computations, 8.6.3.
template <class Scalar, int rows, int columns>
struct LeastChange {
  Eigen::Matrix<Scalar, columns, 1> change;
  Eigen::Matrix<Scalar, rows, 1> left;  ///< c - G change
  int rank = 0;

  LeastChange(const Eigen::Matrix<Scalar, rows, columns>& G, const Eigen::Matrix<Scalar, rows, 1>& c,
              const Eigen::Matrix<Scalar, columns, 1>& ease, Scalar damping, Scalar rank_tolerance) noexcept {
    // U = E Gᵀ V with orthogonal columns, V orthogonal: c = V g, change = E U/σ² g.
    Eigen::Matrix<Scalar, columns, rows> U;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) U(j, i) = ease(j) * G(i, j);
    }
    Eigen::Matrix<Scalar, rows, rows> V = Eigen::Matrix<Scalar, rows, rows>::Identity();
    for (int sweep = 0; sweep < 40; ++sweep) {
      Scalar largest = Scalar(0);
      for (int p = 0; p + 1 < rows; ++p) {
        for (int q = p + 1; q < rows; ++q) largest = std::max(largest, rotate(U, V, p, q));
      }
      if (largest <= Scalar(4) * std::numeric_limits<Scalar>::epsilon()) break;
    }
    Scalar longest = Scalar(0);
    for (int k = 0; k < rows; ++k) longest = std::max(longest, U.col(k).norm());
    change.setZero();
    left = c;
    for (int k = 0; k < rows; ++k) {
      const Scalar sigma = U.col(k).norm();
      if (!(sigma > rank_tolerance * longest)) continue;
      ++rank;
      const Scalar along = V.col(k).dot(c), lambda = damping * longest;
      const Scalar factor = along / (sigma * sigma + lambda * lambda);
      for (int j = 0; j < columns; ++j) change(j) += ease(j) * U(j, k) * factor;
      left -= along * V.col(k);
    }
  }

 private:
  // Makes two columns orthogonal; how far they were from it.
  static Scalar rotate(Eigen::Matrix<Scalar, columns, rows>& U, Eigen::Matrix<Scalar, rows, rows>& V, int p,
                       int q) noexcept {
    const Scalar alpha = U.col(p).squaredNorm(), beta = U.col(q).squaredNorm(), gamma = U.col(p).dot(U.col(q));
    const Scalar size = std::sqrt(alpha * beta);
    if (!(std::abs(gamma) > std::numeric_limits<Scalar>::min()) || !(size > Scalar(0))) return Scalar(0);
    const Scalar zeta = (beta - alpha) / (Scalar(2) * gamma);
    const Scalar t = std::copysign(Scalar(1), zeta) / (std::abs(zeta) + std::sqrt(Scalar(1) + zeta * zeta));
    const Scalar cosine = Scalar(1) / std::sqrt(Scalar(1) + t * t), sine = cosine * t;
    const auto turn = [&](auto& matrix, int count) {
      for (int i = 0; i < count; ++i) {
        const Scalar x = matrix(i, p), y = matrix(i, q);
        matrix(i, p) = cosine * x - sine * y;
        matrix(i, q) = sine * x + cosine * y;
      }
    };
    turn(U, columns);
    turn(V, rows);
    return std::abs(gamma) / size;
  }
};

/// The search behind `find_consistent_state`.
template <HasConstraints M>
requires(M::multiplier_count > 0) class ConsistentStateSearch {
 public:
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  static constexpr int n = static_cast<int>(nv), rows = static_cast<int>(m);
  using Column = Eigen::Matrix<Scalar, n, 1>;
  using Residual = Eigen::Matrix<Scalar, rows, 1>;
  using Change = LeastChange<Scalar, rows, n>;

  ConsistentStateSearch(const typename M::Precomputed& precomputed, Scalar t, const StateWishes<M>& wishes) noexcept
      : precomputed_(precomputed), t_(t) {
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      position_ease_(i) = wishes.position_fixed[k] ? Scalar(0) : Scalar(1) / wishes.position_weight[k];
      velocity_ease_(i) = wishes.velocity_fixed[k] ? Scalar(0) : Scalar(1) / wishes.velocity_weight[k];
    }
  }

  [[nodiscard]] Consistency<M> operator()(StateVector<M>& y) noexcept {
    StateVector<M> next = y;
    if constexpr (HasQuaternions<M>) normalise_quaternions<M>(next);
    find_holonomic(next);
    if (!positions(next) || !velocities(next)) return result_;
    y = next;
    return result_;
  }

 private:
  struct Equations {
    Eigen::Matrix<Scalar, rows, n> G;
    Residual value, rate;
    Scalar size = Scalar(0);  // of the coordinates, for what rounding leaves
    bool finite = true;
  };

  Equations read(const StateVector<M>& y) const noexcept {
    const typename M::State state = unpack<M>(t_, y);
    typename M::Constraints constraints{};
    M::constraints(precomputed_, state, constraints);
    Equations e;
    for (int i = 0; i < rows; ++i) {
      const auto k = static_cast<std::size_t>(i);
      Scalar size = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) size += std::abs(constraints.jacobian[j * m + k]);
      e.finite =
          e.finite && std::isfinite(size) && std::isfinite(constraints.value[k]) && std::isfinite(constraints.rate[k]);
      // In displacements of the coordinates, whatever the unit of the constraint.
      size_[k] = size > Scalar(0) ? size : Scalar(1);
      for (int j = 0; j < n; ++j) e.G(i, j) = constraints.jacobian[static_cast<std::size_t>(j) * m + k] / size_[k];
      e.value(i) = constraints.value[k] / size_[k];
      e.rate(i) = constraints.rate[k] / size_[k];
    }
    // Near zero the lengths of the mechanism round, not the coordinates.
    e.size = Scalar(1e-3);
    for (std::size_t i = 0; i < coordinates_of<M>; ++i) e.size = std::max(e.size, std::abs(y[i]));
    return e;
  }

  // A constraint that is no function of the position reads exactly 0 wherever one looks.
  void find_holonomic(const StateVector<M>& y) noexcept {
    AnyNumbers any;
    const Equations here = read(y), there = read(place_beside<M>(precomputed_, t_, y, any));
    for (int i = 0; i < rows; ++i) {
      holonomic_[static_cast<std::size_t>(i)] = here.value(i) != Scalar(0) || there.value(i) != Scalar(0);
    }
  }
  void only_holonomic(Equations& e) const noexcept {
    for (int i = 0; i < rows; ++i) {
      if (!holonomic_[static_cast<std::size_t>(i)]) e.G.row(i).setZero();
    }
  }

  bool positions(StateVector<M>& y) noexcept {
    const StateVector<M> start = y;
    Column travelled = Column::Zero();
    Equations here = read(y);
    only_holonomic(here);
    Scalar damping = Scalar(0);
    for (; result_.iterations < 200; ++result_.iterations) {
      if (!here.finite) return fail(ConsistencyStatus::not_finite);
      const Scalar off = here.value.norm();
      if (off <= few * here.size) break;
      const Change change(here.G, -here.value, position_ease_, damping, rank_tolerance);
      StateVector<M> trial = y;
      displace<M>(precomputed_, t_, change.change, trial);
      Equations there = read(trial);
      only_holonomic(there);
      if (there.finite && there.value.norm() < off) {
        const bool stalls = there.value.norm() > Scalar(0.999) * off && damping == Scalar(0);
        y = trial;
        here = there;
        travelled += change.change;
        damping = damping > Scalar(1e-6) ? damping / Scalar(10) : Scalar(0);
        if (stalls) break;
      } else {
        damping = std::max(Scalar(1e-3), damping * Scalar(4));
        if (damping > Scalar(1e6)) break;
      }
    }
    const Change last(here.G, -here.value, position_ease_, Scalar(0), rank_tolerance);
    result_.free_positions = free_of(position_ease_) - last.rank;
    if (here.value.norm() > tolerance * here.size) {
      return conflict(ConsistencyStatus::positions_conflict, here.G, here.value);
    }
    shorten(start, y, travelled);
    return true;
  }

  // The nearest of the solutions: from the start along what the constraints take away only, again and again.
  void shorten(const StateVector<M>& start, StateVector<M>& y, Column travelled) noexcept {
    if constexpr (HasCoordinateRates<M>) return;  // displacements of attitudes do not add up
    for (int repeat = 0; repeat < 50; ++repeat) {
      Equations here = read(y);
      only_holonomic(here);
      const Change change(here.G, here.G * travelled - here.value, position_ease_, Scalar(0), rank_tolerance);
      StateVector<M> trial = start;
      displace<M>(precomputed_, t_, change.change, trial);
      Column path = change.change;
      for (int newton = 0; newton < 8; ++newton) {
        Equations there = read(trial);
        only_holonomic(there);
        if (!there.finite) return;
        if (there.value.norm() <= few * there.size) break;
        const Change back(there.G, -there.value, position_ease_, Scalar(0), rank_tolerance);
        displace<M>(precomputed_, t_, back.change, trial);
        path += back.change;
      }
      const Equations there = read(trial);
      if (!there.finite || there.value.norm() > tolerance * there.size || !(length(path) < length(travelled))) return;
      const Scalar gained = length(travelled) - length(path);
      y = trial;
      travelled = path;
      if (gained <= few * length(path)) return;
    }
  }
  [[nodiscard]] Scalar length(const Column& change) const noexcept {
    Scalar sum = Scalar(0);
    for (int i = 0; i < n; ++i) {
      if (position_ease_(i) > Scalar(0)) sum += (change(i) / position_ease_(i)) * (change(i) / position_ease_(i));
    }
    return std::sqrt(sum);
  }

  bool velocities(StateVector<M>& y) noexcept {
    Scalar speed = Scalar(0);
    for (std::size_t i = 0; i < nv; ++i) speed = std::max(speed, std::abs(y[coordinates_of<M> + i]));
    for (int repeat = 0; repeat < 3; ++repeat) {
      const Equations e = read(y);
      if (!e.finite) return fail(ConsistencyStatus::not_finite);
      const Change change(e.G, -e.rate, velocity_ease_, Scalar(0), rank_tolerance);
      result_.free_velocities = free_of(velocity_ease_) - change.rank;
      for (int i = 0; i < n; ++i) y[coordinates_of<M> + static_cast<std::size_t>(i)] += change.change(i);
      speed = std::max(speed, change.change.cwiseAbs().maxCoeff());
    }
    const Equations e = read(y);
    if (!(e.rate.norm() <= tolerance * std::max(speed, std::numeric_limits<Scalar>::min()))) {
      return conflict(ConsistencyStatus::velocities_conflict, e.G, e.rate);
    }
    return true;
  }

  // The fixed values by which what is left could be made less.
  bool conflict(ConsistencyStatus status, const Eigen::Matrix<Scalar, rows, n>& G, const Residual& left) noexcept {
    const bool of_positions = status == ConsistencyStatus::positions_conflict;
    const Column& ease = of_positions ? position_ease_ : velocity_ease_;
    auto& involved = of_positions ? result_.position_involved : result_.velocity_involved;
    if (!left.allFinite()) return fail(ConsistencyStatus::not_finite);  // none of them is the worst
    Scalar worst = Scalar(0);
    for (int i = 0; i < rows; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result_.left[k] = left(i) * size_[k];
      if (std::abs(left(i)) > worst) {
        worst = std::abs(left(i));
        result_.constraint = i;
      }
    }
    for (int j = 0; j < n; ++j) {
      const bool matters = std::abs(G.col(j).dot(left)) > Scalar(1e-6) * left.norm();
      involved[static_cast<std::size_t>(j)] = ease(j) == Scalar(0) && matters;
    }
    return fail(status);
  }
  bool fail(ConsistencyStatus status) noexcept {
    result_.status = status;
    return false;
  }
  static int free_of(const Column& ease) noexcept {
    int count = 0;
    for (int i = 0; i < n; ++i) count += ease(i) > Scalar(0) ? 1 : 0;
    return count;
  }

  static constexpr Scalar few = Scalar(4) * std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar tolerance = Scalar(4096) * std::numeric_limits<Scalar>::epsilon();
  const Scalar rank_tolerance = usual_rank_tolerance<Scalar>();
  const typename M::Precomputed& precomputed_;
  Scalar t_;
  Column position_ease_, velocity_ease_;
  std::array<bool, m> holonomic_{};
  mutable std::array<Scalar, m> size_{};
  Consistency<M> result_;
};

}  // namespace detail

/// Makes a state consistent with the constraints of a mechanism by the least weighted change of what is not fixed:
///   min Σ (w_i δq_i)²  with  f(q + δq, t) = 0,   then  min Σ (w_i δv_i)²  with  A (v + δv) = b,
/// the first by Gauss-Newton with Levenberg's damping, constraints of any rank. y is left alone where values conflict;
/// the result then says which constraint is off by how much at best, and which fixed values stand in its way.
/// A state far from any solution may end in a smallest violation that is none: start nearer.
template <HasConstraints M>
requires(M::multiplier_count > 0)
    [[nodiscard]] Consistency<M> find_consistent_state(const typename M::Precomputed& precomputed, ScalarOf<M> t,
                                                       StateVector<M>& y, const StateWishes<M>& wishes = {}) noexcept {
  return detail::ConsistentStateSearch<M>(precomputed, t, wishes)(y);
}

}  // namespace torsor::runtime
