// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

namespace torsor::runtime {

/// One accepted step of Dormand-Prince, to be evaluated at any time inside it, ends included.
/// The interpolant has order 4 (local error h^5) and is continuously differentiable from step to step.
/// Source: Hairer-Nørsett-Wanner I, II.6 (6.12), in the form of their code dopri5 (contd5).
template <class Scalar, std::size_t size>
struct DenseStep {
  Scalar start;  ///< time at which the step begins
  Scalar end;    ///< time at which it ends, before `start` when time runs backwards
  std::array<std::array<Scalar, size>, 5> coefficients;

  /// The state at a time between `start` and `end`.
  [[nodiscard]] std::array<Scalar, size> operator()(Scalar time) const noexcept {
    const Scalar theta = (time - start) / (end - start);
    const Scalar rest = Scalar(1) - theta;
    const auto& c = coefficients;
    std::array<Scalar, size> y;
    for (std::size_t i = 0; i < size; ++i) {
      y[i] = c[0][i] + theta * (c[1][i] + rest * (c[2][i] + theta * (c[3][i] + rest * c[4][i])));
    }
    return y;
  }
};

}  // namespace torsor::runtime
