// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/numerics/small_matrix.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// A component of a twist (V, Ω).
enum class TwistRow : std::size_t { x, y, z, about_x, about_y, about_z };

inline constexpr std::array<TwistRow, 3> translation_rows{TwistRow::x, TwistRow::y, TwistRow::z};
inline constexpr std::array<TwistRow, 3> rotation_rows{TwistRow::about_x, TwistRow::about_y, TwistRow::about_z};
inline constexpr std::array<TwistRow, 6> twist_rows{TwistRow::x,       TwistRow::y,       TwistRow::z,
                                                    TwistRow::about_x, TwistRow::about_y, TwistRow::about_z};

template <class Scalar>
struct OperationalInertiaOptions {
  /// The axes that rows are along, in the ground's, column by column: `NAME_rotation` of the kernel `frames`, for one.
  std::array<Scalar, 9> axes{Scalar(1), Scalar(0), Scalar(0), Scalar(0), Scalar(1), Scalar(0), Scalar(0), Scalar(0), Scalar(1)};
  /// Usual length of the mechanism [m]. It matters only where the point moves by less than `tolerance` times it for a
  /// radian, or turns by less than that share of a radian for it: this is rounding.
  Scalar length = Scalar(1);
  /// Of eigenvalues of the scaled inverse: what is below is rounding. ε^(2/3), as of the rank of constraints.
  Scalar tolerance = std::cbrt(std::numeric_limits<Scalar>::epsilon() * std::numeric_limits<Scalar>::epsilon());
};

template <class Scalar, std::size_t k>
struct OperationalInertia {
  Evaluation evaluation = Evaluation::ok;
  int rank = 0;                      ///< of the task: how many independent motions it has
  SmallMatrix<Scalar, k, k> inertia;  ///< Λ, symmetric: [kg], [kg m], [kg m²] by the kinds of its rows
};

namespace detail {

/// Diagonalises a symmetric S by Jacobi's rotations, S ← Vᵀ S V. Source: Golub-Van Loan, Matrix Computations, 8.5.
template <class Scalar, std::size_t k>
void rotate_to_diagonal(SmallMatrix<Scalar, k, k>& S, SmallMatrix<Scalar, k, k>& V) noexcept {
  constexpr int n = static_cast<int>(k), most_sweeps = 30;  // they converge quadratically, six rows within 8
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) V(i, j) = Scalar(i == j ? 1 : 0);
  }
  bool turned = true;
  for (int sweep = 0; sweep < most_sweeps && turned; ++sweep) {
    turned = false;
    for (int p = 0; p < n; ++p) {
      for (int q = p + 1; q < n; ++q) {
        const Scalar size = std::abs(S(p, p)) + std::abs(S(q, q));
        // A rotation by so little changes no digit of the two.
        if (std::abs(S(p, q)) <= std::numeric_limits<Scalar>::epsilon() * Scalar(1e-3) * size) continue;
        turned = true;
        const Scalar half = (S(q, q) - S(p, p)) / (Scalar(2) * S(p, q));
        const Scalar root = std::abs(half) + std::sqrt(Scalar(1) + half * half);
        const Scalar t = (half < Scalar(0) ? Scalar(-1) : Scalar(1)) / root, c = Scalar(1) / std::sqrt(Scalar(1) + t * t);
        const Scalar s = t * c;
        for (int i = 0; i < n; ++i) {
          const Scalar a = S(i, p), b = S(i, q), v = V(i, p), w = V(i, q);
          S(i, p) = c * a - s * b;
          S(i, q) = s * a + c * b;
          V(i, p) = c * v - s * w;
          V(i, q) = s * v + c * w;
        }
        for (int i = 0; i < n; ++i) {
          const Scalar a = S(p, i), b = S(q, i);
          S(p, i) = c * a - s * b;
          S(q, i) = s * a + c * b;
        }
        S(p, q) = S(q, p) = Scalar(0);
      }
    }
  }
}

}  // namespace detail

/// The inertia Λ that a task of these rows feels at a point: a force F along them changes the velocities v of the task by
/// dv/dt = Λ⁻¹ F. `inverse` is `NAME_inverse_inertia` of the kernel `operational_inertia`, J M⁻¹ Jᵀ of the whole twist.
/// Of a task of fewer rows Λ is the inverse of this matrix's block, since other rows are free; a block of Λ would hold them.
///
/// `singular` where the arm cannot move the task in some direction, or a part of `inverse` is not positive. Then Λ is a
/// pseudo-inverse: W Λ W = W with W = `inverse` of the rows, so that F = Λ dv/dt gives any dv/dt that there is, by the least
/// force; directions without motion get none. Least is counted with translations and rotations in units of their own,
/// the roots of their mean inverse inertia. Which rank is found depends on no unit nor on the directions of axes.
/// `not_finite` where an entry is; all of Λ is then not a number.
/// Source: O. Khatib, A unified approach for motion and force control of robot manipulators, 1987.
template <std::size_t k, class Scalar>
[[nodiscard]] OperationalInertia<Scalar, k> operational_inertia(
    const std::array<Scalar, 36>& inverse, const std::array<TwistRow, k>& rows,
    const OperationalInertiaOptions<Scalar>& options = {}) noexcept {
  static_assert(k >= 1 && k <= 6);
  constexpr int n = static_cast<int>(k);
  OperationalInertia<Scalar, k> result;
  const auto kind = [](std::size_t row) { return row / 3; };
  std::array<Scalar, 2> mean{};  // of the inverse inertias, of translations and of rotations
  Scalar sum = options.length + options.tolerance;
  for (const Scalar entry : inverse) sum += std::abs(entry);
  for (const Scalar entry : options.axes) sum += std::abs(entry);
  for (std::size_t i = 0; i < 6; ++i) mean[kind(i)] += inverse[7 * i] / Scalar(3);
  if (!std::isfinite(sum)) {
    result.evaluation = Evaluation::not_finite;
    result.inertia.entries.fill(std::numeric_limits<Scalar>::quiet_NaN());
    return result;
  }
  const Scalar square = options.length * options.length;
  const std::array<Scalar, 2> least{options.tolerance * square * mean[1], options.tolerance * mean[0] / square};
  std::array<Scalar, 2> scale{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Scalar size = std::max(mean[i], least[i]);
    scale[i] = size > Scalar(0) ? Scalar(1) / std::sqrt(size) : Scalar(0);
  }

  SmallMatrix<Scalar, k, k> S{}, V{};
  for (std::size_t a = 0; a < k; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto first = static_cast<std::size_t>(rows[a]), second = static_cast<std::size_t>(rows[b]);
      Scalar entry = Scalar(0);
      for (std::size_t i = 0; i < 3; ++i) {
        Scalar product = Scalar(0);
        for (std::size_t j = 0; j < 3; ++j) {
          const std::size_t row = 3 * kind(first) + i, column = 3 * kind(second) + j;
          product += inverse[6 * std::min(row, column) + std::max(row, column)] * options.axes[3 * (second % 3) + j];
        }
        entry += options.axes[3 * (first % 3) + i] * product;
      }
      S(static_cast<int>(a), static_cast<int>(b)) = S(static_cast<int>(b), static_cast<int>(a)) =
          entry * scale[kind(first)] * scale[kind(second)];
    }
  }
  detail::rotate_to_diagonal(S, V);
  result.inertia.entries.fill(Scalar(0));
  for (int e = 0; e < n; ++e) {
    if (!(S(e, e) > options.tolerance)) continue;
    ++result.rank;
    for (int j = 0; j < n; ++j) {
      for (int i = j; i < n; ++i) result.inertia(i, j) += V(i, e) * V(j, e) / S(e, e);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i) {
      result.inertia(i, j) *= scale[kind(static_cast<std::size_t>(rows[static_cast<std::size_t>(i)]))] *
                              scale[kind(static_cast<std::size_t>(rows[static_cast<std::size_t>(j)]))];
      result.inertia(j, i) = result.inertia(i, j);
    }
  }
  if (result.rank < n) result.evaluation = Evaluation::singular;
  return result;
}

/// That of the whole twist, of an arm with six freedoms or more.
template <class Scalar>
[[nodiscard]] OperationalInertia<Scalar, 6> operational_inertia(const std::array<Scalar, 36>& inverse,
                                                                const OperationalInertiaOptions<Scalar>& options = {}) noexcept {
  return operational_inertia(inverse, twist_rows, options);
}

}  // namespace torsor::runtime
