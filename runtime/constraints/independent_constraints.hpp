// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "torsor/runtime/numerics/small_matrix.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// ε^(2/3): a rank that rounding of positions can no longer feign.
template <class Scalar>
[[nodiscard]] Scalar usual_rank_tolerance() noexcept {
  return std::pow(std::numeric_limits<Scalar>::epsilon(), Scalar(2) / Scalar(3));
}
/// ε^(1/3): for motions through change points, where the branches of a closed loop meet. Nearer than that rounding of
/// positions can't tell the branches apart, and would turn the velocity into the wrong one; constraints below it are
/// let go for the moment of the passage, which costs an error of about this size.
template <class Scalar>
[[nodiscard]] Scalar change_point_tolerance() noexcept {
  return std::cbrt(std::numeric_limits<Scalar>::epsilon());
}

/// Constraints A x = c weighed by a mass matrix M, of any rank: M = L Lᵀ, of which the diagonal D² is scaled to one, and
/// of L⁻¹ Aᵀ, each column over the usual size of its constraint, a pivoted orthogonal factor
///   L⁻¹ Aᵀ S⁻¹ P = Q R,   R upper triangular with the largest remaining column first,
/// cut off where what remains of every column is below `rank_tolerance` of the longest, or of 1 where all are shorter:
/// those constraints repeat others, or hold nothing at a change point. The rank so depends neither on the units of
/// constraints nor on those of coordinates. By Gram-Schmidt, twice over. Source: Golub-Van Loan, Matrix Computations,
/// 5.2 and 5.4.
template <class Scalar, std::size_t nv, std::size_t m>
class IndependentConstraints {
 public:
  static constexpr int n = static_cast<int>(nv), rows = static_cast<int>(m);
  using Column = SmallMatrix<Scalar, nv>;
  using Residual = SmallMatrix<Scalar, m>;

  /// M is nv x nv, A is m x nv, both stored column by column. `usual` are sizes that the entries of A have elsewhere (see
  /// ConstraintKinds): the size of a constraint is that of D⁻¹ Aᵀ, by these or by A, whichever is larger. Without them a
  /// constraint that is about to vanish as a whole is not noticed. `singular` when M is not positive definite.
  [[nodiscard]] Evaluation factorise(const std::array<Scalar, nv * nv>& mass,
                                     const std::array<Scalar, m * nv>& jacobian,
                                     Scalar rank_tolerance = usual_rank_tolerance<Scalar>(),
                                     const std::array<Scalar, m * nv>& usual = {}) noexcept {
    A_.entries = jacobian;
    if (!are_finite(mass) || !are_finite(jacobian)) return Evaluation::not_finite;
    for (int i = 0; i < n; ++i) {
      const Scalar diagonal = mass[static_cast<std::size_t>(i) * (nv + 1)];
      if (!(diagonal > Scalar(0))) return Evaluation::singular;
      scale_(i) = Scalar(1) / std::sqrt(diagonal);
    }
    factor_.entries = mass;
    for (int k = 0; k < n; ++k) {
      for (int i = k; i < n; ++i) factor_(i, k) *= scale_(i) * scale_(k);
      for (int j = 0; j < k; ++j) {
        for (int i = k; i < n; ++i) factor_(i, k) -= factor_(k, j) * factor_(i, j);
      }
      const Scalar pivot = factor_(k, k);
      if (!(pivot > static_cast<Scalar>(n) * std::numeric_limits<Scalar>::epsilon())) return Evaluation::singular;
      const Scalar root = std::sqrt(pivot);
      for (int i = k; i < n; ++i) factor_(i, k) /= root;
    }
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < n; ++i) Q_(i, j) = scale_(i) * A_(j, i);
    }
    find_sizes(usual);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < n; ++i) {
        Q_(i, j) *= over_[static_cast<std::size_t>(j)];
        for (int k = 0; k < i; ++k) Q_(i, j) -= factor_(i, k) * Q_(k, j);
        Q_(i, j) /= factor_(i, i);
      }
    }
    orthogonalise(rank_tolerance);
    return Evaluation::ok;
  }

  /// How many constraints are independent.
  [[nodiscard]] int rank() const noexcept { return rank_; }
  /// What the others leave of the last one kept, in its usual size; small near a change point.
  [[nodiscard]] Scalar least_share() const noexcept { return rank_ > 0 ? R_(rank_ - 1, rank_ - 1) : Scalar(1); }
  /// Content of the parallelepiped that the independent rows of A span, in the metric of M⁻¹, over their usual sizes
  /// where these were given.
  [[nodiscard]] Scalar content() const noexcept {
    Scalar product = Scalar(1);
    for (int k = 0; k < rank_; ++k) {
      const auto j = static_cast<std::size_t>(constraint(k));
      product *= R_(k, k) / (over_[j] * usual_size_[j]);
    }
    return product;
  }
  /// Which constraint is the k-th in order of independence; those from rank() on repeat others.
  [[nodiscard]] int constraint(int k) const noexcept { return order_[static_cast<std::size_t>(k)]; }

  /// The x of least xᵀ M x with A x = c, as far as the independent constraints go.
  [[nodiscard]] Column least_change(const Residual& c) noexcept {
    const Residual w = along(c);
    Column x = combined(w);
    back_substitute(x);
    return x;
  }

  /// The largest part of c, over the sizes of the constraints, that the independent constraints contradict: a redundant
  /// constraint that does not close.
  [[nodiscard]] Scalar contradiction(const Residual& c) noexcept {
    const Residual w = along(c);
    Scalar largest = Scalar(0);
    for (int k = rank_; k < rows; ++k) {
      Scalar rest = c(constraint(k)) * over(k);
      for (int j = 0; j < rank_; ++j) rest -= R_(j, k) * w(j);
      largest = std::max(largest, std::abs(rest));
    }
    return largest;
  }

  /// Accelerations and multipliers of M a - Aᵀ λ = r, A a = c; the multipliers of constraints that repeat others are 0.
  void solve(const Column& r, const Residual& c, Column& a, Residual& lambda) noexcept {
    Column free;
    for (int i = 0; i < n; ++i) {
      free(i) = scale_(i) * r(i);
      for (int k = 0; k < i; ++k) free(i) -= factor_(i, k) * free(k);
      free(i) /= factor_(i, i);
    }
    back_substitute(free);
    Residual wanted = c;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < rows; ++i) wanted(i) -= A_(i, j) * free(j);
    }
    const Residual w = along(wanted);
    a = combined(w);
    back_substitute(a);
    for (int i = 0; i < n; ++i) a(i) += free(i);
    lambda = Residual{};
    for (int k = rank_ - 1; k >= 0; --k) {
      Scalar sum = w(k);
      for (int j = k + 1; j < rank_; ++j) sum -= R_(k, j) * mu_[static_cast<std::size_t>(j)];
      mu_[static_cast<std::size_t>(k)] = sum / R_(k, k);
      lambda(constraint(k)) = mu_[static_cast<std::size_t>(k)] * over(k);
    }
  }

 private:
  template <class Numbers>
  [[nodiscard]] static bool are_finite(const Numbers& numbers) noexcept {
    return std::all_of(numbers.begin(), numbers.end(), [](Scalar number) { return std::isfinite(number); });
  }
  [[nodiscard]] Scalar dot(int j, int k) const noexcept {
    Scalar sum = Scalar(0);
    for (int i = 0; i < n; ++i) sum += Q_(i, j) * Q_(i, k);
    return sum;
  }
  [[nodiscard]] Scalar length(int j) const noexcept { return std::sqrt(dot(j, j)); }
  // Q w, of the independent constraints.
  [[nodiscard]] Column combined(const Residual& w) const noexcept {
    Column x{};
    for (int k = 0; k < rank_; ++k) {
      for (int i = 0; i < n; ++i) x(i) += Q_(i, k) * w(k);
    }
    return x;
  }

  // One over the size of the k-th constraint in order of independence.
  [[nodiscard]] Scalar over(int k) const noexcept { return over_[static_cast<std::size_t>(constraint(k))]; }

  void find_sizes(const std::array<Scalar, m * nv>& usual) noexcept {
    for (std::size_t j = 0; j < m; ++j) {
      Scalar square = Scalar(0);
      for (std::size_t i = 0; i < nv; ++i) {
        const Scalar entry = usual[i * m + j] * scale_(static_cast<int>(i));
        square += entry * entry;
      }
      const Scalar elsewhere = std::sqrt(square), size = std::max(elsewhere, length(static_cast<int>(j)));
      over_[j] = size > Scalar(0) ? Scalar(1) / size : Scalar(1);
      usual_size_[j] = elsewhere > Scalar(0) ? elsewhere : Scalar(1);
    }
  }

  void orthogonalise(Scalar rank_tolerance) noexcept {
    R_ = {};
    Scalar longest = Scalar(1);
    for (int j = 0; j < rows; ++j) {
      order_[static_cast<std::size_t>(j)] = j;
      longest = std::max(longest, length(j));
    }
    for (rank_ = 0; rank_ < rows && rank_ < n; ++rank_) {
      int pivot = rank_;
      for (int j = rank_ + 1; j < rows; ++j) pivot = dot(j, j) > dot(pivot, pivot) ? j : pivot;
      if (pivot != rank_) {
        for (int i = 0; i < n; ++i) std::swap(Q_(i, rank_), Q_(i, pivot));
        for (int i = 0; i < rows; ++i) std::swap(R_(i, rank_), R_(i, pivot));
        std::swap(order_[static_cast<std::size_t>(rank_)], order_[static_cast<std::size_t>(pivot)]);
      }
      for (int k = 0; k < rank_; ++k) take_out(k, rank_);
      const Scalar norm = length(rank_);
      if (!(norm > rank_tolerance * longest)) return;
      R_(rank_, rank_) = norm;
      for (int i = 0; i < n; ++i) Q_(i, rank_) /= norm;
      for (int j = rank_ + 1; j < rows; ++j) take_out(rank_, j);
    }
  }
  void take_out(int k, int j) noexcept {
    const Scalar part = dot(k, j);
    R_(k, j) += part;
    for (int i = 0; i < n; ++i) Q_(i, j) -= part * Q_(i, k);
  }

  // R11ᵀ w = the independent ones of c, over their sizes.
  [[nodiscard]] Residual along(const Residual& c) const noexcept {
    Residual w{};
    for (int k = 0; k < rank_; ++k) {
      Scalar sum = c(constraint(k)) * over(k);
      for (int j = 0; j < k; ++j) sum -= R_(j, k) * w(j);
      w(k) = sum / R_(k, k);
    }
    return w;
  }
  // x := scale L⁻ᵀ x
  void back_substitute(Column& x) const noexcept {
    for (int i = n - 1; i >= 0; --i) {
      for (int k = i + 1; k < n; ++k) x(i) -= factor_(k, i) * x(k);
      x(i) /= factor_(i, i);
    }
    for (int i = 0; i < n; ++i) x(i) *= scale_(i);
  }

  SmallMatrix<Scalar, m, nv> A_;
  Column scale_;
  SmallMatrix<Scalar, nv, nv> factor_;
  SmallMatrix<Scalar, nv, m> Q_;
  SmallMatrix<Scalar, m, m> R_;
  std::array<int, m> order_{};
  std::array<Scalar, m> mu_{};
  std::array<Scalar, m> over_{}, usual_size_{};  // one over the size of each constraint
  int rank_ = 0;
};

}  // namespace torsor::runtime
