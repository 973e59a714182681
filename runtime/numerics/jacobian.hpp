// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// ∂f_i/∂y_j of y' = f(t, y), column by column (entry i + j size).
template <class Scalar, std::size_t size>
using JacobianMatrix = std::array<Scalar, size * size>;

/// A system that offers its Jacobian, `system.jacobian(t, y, J)`, which returns an enumeration, 0 if it could.
template <class S, class Scalar, std::size_t size>
concept HasJacobian = requires(const S& system, const Scalar& t, const std::array<Scalar, size>& y,
                               JacobianMatrix<Scalar, size>& J) {
  to_evaluation(system.jacobian(t, y, J));
};

/// The Jacobian at (t, y), where f is `slope`: the system's own, else by forward differences with
/// δ_j = sqrt(ε max(10⁻⁵, |y_j|)), one call for each column (Hairer-Wanner II, IV.8, as in their code radau5), and
/// sqrt(ε) |y_j| where |y_j| is so large that this would be lost in it; ε is that of what the system computes in.
/// False when the model failed; `f.evaluation` then says how.
template <class S, class Scalar, std::size_t size>
[[nodiscard]] bool evaluate_jacobian(CheckedSystem<S, Scalar, size>& f, Scalar t, const std::array<Scalar, size>& y,
                                     const std::array<Scalar, size>& slope, JacobianMatrix<Scalar, size>& J) {
  ++f.jacobians;
  if constexpr (HasJacobian<S, Scalar, size>) {
    f.evaluation = to_evaluation(f.system().jacobian(t, y, J));
    if (f.evaluation == Evaluation::ok) {
      for (const Scalar& entry : J) {
        if (!std::isfinite(entry)) f.evaluation = Evaluation::not_finite;
      }
    }
    return f.evaluation == Evaluation::ok;
  } else {
    using Precision = typename PrecisionOf<S, Scalar>::type;
    const auto computed_at = [](Scalar number) { return static_cast<Scalar>(static_cast<Precision>(number)); };
    const Scalar epsilon = static_cast<Scalar>(std::numeric_limits<Precision>::epsilon());
    std::array<Scalar, size> moved = y, at_moved;
    for (std::size_t j = 0; j < size; ++j) {
      const Scalar largeness = std::abs(y[j]);
      const Scalar relative = std::sqrt(epsilon) * largeness;
      const Scalar wanted = relative < Scalar(1) ? std::sqrt(epsilon * std::max(Scalar(1e-5), largeness)) : relative;
      moved[j] = computed_at(y[j] + wanted);
      const Scalar delta = moved[j] - computed_at(y[j]);
      if (!f(t, moved, at_moved)) return false;
      for (std::size_t i = 0; i < size; ++i) J[i + j * size] = (at_moved[i] - slope[i]) / delta;
      moved[j] = y[j];
    }
    return true;
  }
}

}  // namespace torsor::runtime
