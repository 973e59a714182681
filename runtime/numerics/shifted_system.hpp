// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/numerics/lu.hpp"

namespace torsor::runtime {

/// Solves (γ I - J) x = r for a real or complex γ and the Jacobian J of y' = f(t, y).
///
/// Where y = [q; v] with q' = v (`second_order`), J = [[0, I], [K, C]] and half as many unknowns are solved for:
///   (γ² I - γ C - K) x_q = r_v + (γ I - C) r_q,   x_v = γ x_q - r_q,
/// an eighth of the work of the decomposition (Hairer-Wanner II, IV.8, "second order equations").
template <class Field, class Scalar, std::size_t size, bool second_order>
class ShiftedSystem {
 public:
  using Jacobian = JacobianMatrix<Scalar, size>;
  using Vector = std::array<Field, size>;

  [[nodiscard]] Evaluation factorise(const Jacobian& J, const Field& gamma) noexcept {
    gamma_ = gamma;
    auto& matrix = lu_.matrix();
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        if constexpr (second_order) {
          const Scalar stiffness = J[j * size + n + i], damping = J[(n + j) * size + n + i];
          matrix[j * n + i] = Field{} - damping * gamma - from_real(stiffness);
          if (i == j) matrix[j * n + i] = matrix[j * n + i] + gamma * gamma;
        } else {
          matrix[j * n + i] = Field{} - from_real(J[j * size + i]);
          if (i == j) matrix[j * n + i] = matrix[j * n + i] + gamma;
        }
      }
    }
    return lu_.factorise();
  }

  /// Overwrites r with x; J is the one that was factorised.
  void solve(const Jacobian& J, Vector& r) const noexcept {
    if constexpr (second_order) {
      typename Lu<Field, n>::Vector x;
      for (std::size_t i = 0; i < n; ++i) x[i] = r[n + i] + gamma_ * r[i];
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) x[i] = x[i] - J[(n + j) * size + n + i] * r[j];
      }
      lu_.solve(x);
      for (std::size_t i = 0; i < n; ++i) {
        r[n + i] = gamma_ * x[i] - r[i];
        r[i] = x[i];
      }
    } else {
      lu_.solve(r);
    }
  }

 private:
  static constexpr std::size_t n = second_order ? size / 2 : size;

  static Field from_real(Scalar x) noexcept { return Field{x}; }

  Field gamma_{};
  Lu<Field, n> lu_;
};

}  // namespace torsor::runtime
